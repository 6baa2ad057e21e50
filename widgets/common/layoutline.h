// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayoutItem>
#include <vector>

namespace nmc {

/// The items that share one line of a layout that breaks lines, from left to right.
class LayoutLine {
public:
    /// `left`: pixels from the beginning of the line.
    void add(QLayoutItem* item, int left, QSize size) { m_items.push_back({item, left, size}); }
    [[nodiscard]] bool empty() const { return m_items.empty(); }
    [[nodiscard]] std::size_t count() const { return m_items.size(); }
    [[nodiscard]] QLayoutItem* first() const { return m_items.front().item; }
    /// The height of the tallest item.
    [[nodiscard]] int height() const;
    /// Moves the items to where they belong in `rect`, `top` pixels below its upper edge. Lines run from
    /// right to left where `parent` does. A widget lower than the line is centred on it, as words beside a
    /// field are; tables begin at the same height.
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
