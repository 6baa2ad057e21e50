// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGridLayout>

namespace nmc {

/// A grid whose rows can take several lines each where it is too narrow for one: the name at the left has a
/// line for itself then, and what belongs to it flows below. In a table, columns stay columns.
class FoldingGrid : public QGridLayout {
    Q_OBJECT

public:
    enum class Kind : bool { Form, Table };
    explicit FoldingGrid(QWidget* parent, Kind kind = Kind::Form) : QGridLayout(parent), m_kind(kind) {}

    /// Lets every FoldingGrid and QFormLayout on `page` fold, or none.
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
        bool whole;  ///< takes a line for itself
    };
    /// What stands in each row, from left to right.
    [[nodiscard]] std::vector<std::vector<Cell>> rows() const;
    void gather(QLayoutItem& item, int column, bool whole, std::vector<Cell>& row) const;
    [[nodiscard]] std::vector<int> columnWidths(const std::vector<std::vector<Cell>>& rows) const;
    [[nodiscard]] bool folds(int width) const;
    /// The height that they take in this rectangle.
    int place(const QRect& rect, Move move) const;

    Kind m_kind;
    bool m_mayFold = false;
    QMargins m_around;       ///< where it does not fold; otherwise half of them at the sides
    mutable int m_need = 0;  ///< pixels that it needed unfolded; never less again, or it would flutter
};

}  // namespace nmc
