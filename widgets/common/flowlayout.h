// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace nmc {

/// Widgets in a row, and in as many rows as it takes where there is less room: no narrower than the widest of
/// them.
class FlowLayout : public QLayout {
    Q_OBJECT

public:
    /// `spacing`: pixels between them, and half of it between rows.
    explicit FlowLayout(int spacing, QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    void insertWidget(int index, QWidget* widget);
    /// Stays together.
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
    /// The height that they take in this rectangle.
    int place(const QRect& rect, Move move) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace nmc
