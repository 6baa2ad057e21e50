// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGridLayout>

namespace nmc {

/// A grid whose rows fold into several lines where it is too narrow: the name on the left then has a line to
/// itself, and the other items of the row flow below it. In a table, columns stay columns.
class FoldingGrid : public QGridLayout {
    Q_OBJECT

public:
    enum class Kind : bool { Form, Table };
    explicit FoldingGrid(QWidget* parent, Kind kind = Kind::Form) : QGridLayout(parent), m_kind(kind) {}

    /// Allows every FoldingGrid and QFormLayout on `page` to fold, or forbids it.
    static void letFold(const QWidget& page, bool may);

    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] bool hasHeightForWidth() const override;
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] int minimumHeightForWidth(int width) const override;
    void setGeometry(const QRect& rect) override;

private:
    enum class Move : bool { No, Yes };
    struct Cell {
        QLayoutItem* item;
        int column;
        bool whole;  ///< takes a line to itself
    };
    /// The items of each row, from left to right.
    [[nodiscard]] std::vector<std::vector<Cell>> rows() const;
    void gather(QLayoutItem& item, int column, bool whole, std::vector<Cell>& row) const;
    [[nodiscard]] std::vector<int> columnWidths(const std::vector<std::vector<Cell>>& rows) const;
    [[nodiscard]] bool folds(int width) const;
    /// Computes the positions of the items in `rect`, and moves them there if `move` is Yes. Returns the
    /// height that they take.
    int place(const QRect& rect, Move move) const;

    Kind m_kind;
    bool m_mayFold = false;
    QMargins m_around;       ///< while it must not fold; while it may, half of them at the sides
    mutable int m_need = 0;  ///< pixels needed unfolded; never reduced, to avoid flutter
};

}  // namespace nmc
