// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QHash>
#include <QPixmap>
#include <QStyledItemDelegate>

namespace nmc {

/// Paints a row of the chain: the wire with the module's address on it, name and type, state glyph and word,
/// and position. Only the position changes with every status, so the rest of a row is kept as a picture.
class ChainDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    /// Everything that the picture of a row depends on.
    struct Look {
        QFont font;
        qint64 palette = 0;
        QStyle::State state;
        QSize size;
        double devicePixelRatio = 0;
        int activity = 0;
        int address = 0;
        QStringList texts;

        bool operator==(const Look&) const = default;
    };
    struct Still {
        Look look;
        QPixmap picture;
        QFont digits;
    };

    [[nodiscard]] const Still& stillOf(const QStyleOptionViewItem& option, const QModelIndex& index,
                                       double devicePixelRatio) const;
    static void paintStill(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                           const QFont& digits);
    static void paintWire(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                          const QRect& column);
    static void paintTexts(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                           const QFont& digits);

    mutable QHash<int, Still> m_still;  ///< by row
};

}  // namespace nmc
