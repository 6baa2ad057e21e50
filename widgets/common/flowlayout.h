// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <initializer_list>
#include <memory>
#include <vector>

namespace nmc {

/// Arranges widgets in a row, or in as many rows as they need where there is less room. It is never narrower
/// than its widest widget.
class FlowLayout : public QLayout {
    Q_OBJECT

public:
    /// `spacing`: pixels between neighbours; rows are half as far apart.
    explicit FlowLayout(int spacing, QWidget* parent = nullptr);
    FlowLayout(int spacing, std::initializer_list<QWidget*> widgets);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    void insertWidget(int index, QWidget* widget);
    /// Adds a layout whose items stay together.
    void addLayout(QLayout* layout);
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;

private:
    enum class Move : bool { No, Yes };
    /// Computes the positions of the items in `rect`, and moves them there if `move` is Yes. Returns the
    /// height that they take.
    int place(const QRect& rect, Move move) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace nmc
