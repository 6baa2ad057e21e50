// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/foldinggrid.h"

#include <QFormLayout>
#include <QLabel>
#include <algorithm>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/layoutline.h"

namespace nmc {

void FoldingGrid::letFold(const QWidget& page, bool may) {
    for (auto* form : page.findChildren<QFormLayout*>())
        form->setRowWrapPolicy(may ? QFormLayout::WrapLongRows : QFormLayout::DontWrapRows);
    for (auto* grid : page.findChildren<FoldingGrid*>()) {
        if (grid->m_mayFold == may)
            continue;
        grid->m_mayFold = may;
        if (may)
            grid->m_around = grid->contentsMargins();
        const QMargins& around = grid->m_around;
        const int share = may ? 2 : 1;
        grid->setContentsMargins(around.left() / share, around.top(), around.right() / share,
                                 around.bottom());
        grid->m_need = 0;
        // A layout in the grid does not notice that its items were placed without it.
        for (auto* inner : grid->findChildren<QLayout*>())
            inner->invalidate();
        grid->invalidate();
    }
}

bool FoldingGrid::folds(int width) const {
    if (m_mayFold)
        m_need = std::max(m_need, QGridLayout::minimumSize().width());
    return m_mayFold && width < m_need;
}

void FoldingGrid::gather(QLayoutItem& item, int column, bool whole, std::vector<Cell>& row) const {
    QLayout* inner = item.layout();
    const bool line =
        qobject_cast<QHBoxLayout*>(inner) != nullptr || qobject_cast<FlowLayout*>(inner) != nullptr;
    if (line && (m_kind == Kind::Form || whole)) {
        for (int i = 0; i < inner->count(); ++i)
            gather(*inner->itemAt(i), column, false, row);
    } else if (!item.isEmpty() && item.spacerItem() == nullptr) {
        row.push_back({&item, column, whole});
    }
}

std::vector<std::vector<FoldingGrid::Cell>> FoldingGrid::rows() const {
    std::vector<std::vector<Cell>> rows(static_cast<std::size_t>(rowCount()));
    for (int i = 0; i < count(); ++i) {
        int row = 0;
        int column = 0;
        int lines = 0;
        int columns = 0;
        getItemPosition(i, &row, &column, &lines, &columns);
        const bool whole = m_kind == Kind::Table ? columns > 1 : itemAt(i)->hasHeightForWidth();
        gather(*itemAt(i), column, whole, rows[static_cast<std::size_t>(row)]);
    }
    for (std::vector<Cell>& row : rows)
        std::ranges::stable_sort(row, {}, &Cell::column);
    return rows;
}

std::vector<int> FoldingGrid::columnWidths(const std::vector<std::vector<Cell>>& rows) const {
    std::vector<int> widths(static_cast<std::size_t>(columnCount()));
    for (const std::vector<Cell>& row : rows)
        for (const Cell& cell : row)
            if (int& width = widths[static_cast<std::size_t>(cell.column)]; !cell.whole)
                width = std::max(width, cell.item->sizeHint().width());
    return widths;
}

QSize FoldingGrid::minimumSize() const {
    if (!m_mayFold)
        return QGridLayout::minimumSize();
    QSize widest;
    for (const std::vector<Cell>& row : rows())
        for (const Cell& cell : row)
            widest = widest.expandedTo(cell.item->minimumSize());
    return widest.grownBy(contentsMargins());
}

bool FoldingGrid::hasHeightForWidth() const {
    return m_mayFold || QGridLayout::hasHeightForWidth();
}

int FoldingGrid::heightForWidth(int width) const {
    if (!folds(width))
        return QGridLayout::hasHeightForWidth() ? QGridLayout::heightForWidth(width)
                                                : QGridLayout::sizeHint().height();
    const QMargins around = contentsMargins();
    return place(QRect(0, 0, width - around.left() - around.right(), 0), Move::No) + around.top() +
           around.bottom();
}

int FoldingGrid::minimumHeightForWidth(int width) const {
    if (folds(width))
        return heightForWidth(width);
    return QGridLayout::hasHeightForWidth() ? QGridLayout::minimumHeightForWidth(width)
                                            : QGridLayout::minimumSize().height();
}

void FoldingGrid::setGeometry(const QRect& rect) {
    if (!folds(rect.width()))
        return QGridLayout::setGeometry(rect);
    QLayout::setGeometry(rect);
    place(rect.marginsRemoved(contentsMargins()), Move::Yes);
}

int FoldingGrid::place(const QRect& rect, Move move) const {
    const auto rows = this->rows();
    const std::vector<int> columns = columnWidths(rows);
    int top = 0;
    LayoutLine line;
    const auto endLine = [&] {
        if (move == Move::Yes)
            line.place(*parentWidget(), rect, top);
        if (!line.empty())
            top += line.height() + verticalSpacing();
        line = {};
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        int left = 0;
        for (const Cell& cell : rows[i]) {
            const bool table = m_kind == Kind::Table && !cell.whole;
            QSize size = cell.item->sizeHint().boundedTo({rect.width(), QWIDGETSIZE_MAX});
            // Text that may be elided takes the rest of the line, or all of the next line if the rest is
            // short.
            if (qobject_cast<ElidedLabel*>(cell.item->widget()) != nullptr)
                size.setWidth(left < rect.width() * 2 / 3 ? rect.width() - left : rect.width());
            else if (cell.whole)
                size.setWidth(rect.width());
            if (cell.item->hasHeightForWidth())
                size.setHeight(cell.item->heightForWidth(size.width()));
            const int width = table ? columns[static_cast<std::size_t>(cell.column)] : size.width();
            const bool belowName = !table && line.count() == 1 && cell.column > 0 &&
                                   qobject_cast<QLabel*>(line.first()->widget()) != nullptr;
            if (left > 0 && (belowName || left + width > rect.width())) {
                endLine();
                // In a table, further lines of a row start to the right of its name.
                left = table ? columns.front() + horizontalSpacing() : 0;
            }
            line.add(cell.item, left, size);
            left += width + horizontalSpacing();
        }
        endLine();
        if (rows[i].empty())
            top += rowMinimumHeight(static_cast<int>(i));
    }
    return std::max(0, top - verticalSpacing());
}

}  // namespace nmc
