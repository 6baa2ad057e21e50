// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace nmc {

/// A row of the chain: the wire with the module's address on it, name and type, state glyph and word,
/// position.
class ChainDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    static void paintWire(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                          const QRect& column);
};

}  // namespace nmc
