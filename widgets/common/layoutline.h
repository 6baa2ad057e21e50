// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayoutItem>
#include <vector>

namespace nmc {

/// The items in one line of a layout that breaks lines, from left to right.
class LayoutLine {
public:
    /// `left`: pixels from the beginning of the line.
    void add(QLayoutItem* item, int left, QSize size) { m_items.push_back({item, left, size}); }
    [[nodiscard]] bool empty() const { return m_items.empty(); }
    [[nodiscard]] std::size_t count() const { return m_items.size(); }
    [[nodiscard]] QLayoutItem* first() const { return m_items.front().item; }
    /// The height of the tallest item.
    [[nodiscard]] int height() const;
    /// Moves the items to their places in `rect`, `top` pixels below its upper edge. Lines run from right to
    /// left if `parent` does. A widget that is not as high as the line is centred vertically, like text
    /// beside a field; layouts are aligned at the top.
    void place(const QWidget& parent, const QRect& rect, int top) const;

private:
    struct Placed {
        QLayoutItem* item;
        int left;
        QSize size;
    };
    std::vector<Placed> m_items;
};

}  // namespace nmc
