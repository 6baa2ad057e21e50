// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/layoutline.h"

#include <QStyle>
#include <QWidget>
#include <algorithm>

namespace nmc {

int LayoutLine::height() const {
    int high = 0;
    for (const Placed& placed : m_items)
        high = std::max(high, placed.size.height());
    return high;
}

void LayoutLine::place(const QWidget& parent, const QRect& rect, int top) const {
    const int high = height();
    for (const auto& [item, left, size] : m_items) {
        const int down = item->widget() != nullptr ? (high - size.height()) / 2 : 0;
        const QRect at(rect.topLeft() + QPoint(left, top + down), size);
        item->setGeometry(QStyle::visualRect(parent.layoutDirection(), rect, at));
    }
}

}  // namespace nmc
