// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/flowlayout.h"

#include <QWidget>

#include "widgets/common/layoutline.h"

namespace nmc {

FlowLayout::FlowLayout(int spacing, QWidget* parent) : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
    setSpacing(spacing);
}

FlowLayout::FlowLayout(int spacing, std::initializer_list<QWidget*> widgets) : FlowLayout(spacing) {
    for (QWidget* widget : widgets)
        addWidget(widget);
}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) {
    m_items.emplace_back(item);
}

void FlowLayout::insertWidget(int index, QWidget* widget) {
    addChildWidget(widget);
    m_items.emplace(m_items.begin() + index, std::make_unique<QWidgetItem>(widget));
    invalidate();
}

void FlowLayout::addLayout(QLayout* layout) {
    addChildLayout(layout);
    addItem(layout);
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    if (index < 0 || index >= count())
        return nullptr;
    const auto place = m_items.begin() + index;
    QLayoutItem* item = place->release();
    m_items.erase(place);
    return item;
}

int FlowLayout::heightForWidth(int width) const {
    const QMargins around = contentsMargins();
    return place(QRect(0, 0, width, 0).marginsRemoved({around.left(), 0, around.right(), 0}), Move::No) +
           around.top() + around.bottom();
}

QSize FlowLayout::sizeHint() const {
    QSize all;
    for (const auto& item : m_items) {
        if (item->isEmpty())
            continue;
        const QSize one = item->sizeHint();
        all = {all.width() + one.width() + (all.width() > 0 ? spacing() : 0),
               qMax(all.height(), one.height())};
    }
    return all.grownBy(contentsMargins());
}

QSize FlowLayout::minimumSize() const {
    QSize widest;
    for (const auto& item : m_items)
        widest = widest.expandedTo(item->minimumSize());
    return widest.grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    place(rect.marginsRemoved(contentsMargins()), Move::Yes);
}

int FlowLayout::place(const QRect& rect, Move move) const {
    LayoutLine line;
    int top = 0;
    const auto endLine = [&] {
        if (move == Move::Yes)
            line.place(*parentWidget(), rect, top);
        top += line.height();
        line = {};
    };
    int left = 0;
    for (const auto& item : m_items) {
        if (item->isEmpty())
            continue;
        const QSize size =
            item->sizeHint().boundedTo({qMax(rect.width(), item->minimumSize().width()), QWIDGETSIZE_MAX});
        if (left > 0 && left + size.width() > rect.width()) {
            endLine();
            left = 0;
            top += spacing() / 2;
        }
        line.add(item.get(), left, size);
        left += size.width() + spacing();
    }
    endLine();
    return top;
}

}  // namespace nmc
