// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace nmc {

/// Words whose room is fixed, however many there are: as many lines as it was made for, the last of them ends
/// in … where that is too few, and the tool tip says the rest. What stands below it never moves. Plain text.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(int lines, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString visibleText() const;

    int m_lines;
};

/// One line of quiet secondary text that gives way to its neighbours.
[[nodiscard]] ElidedLabel* newMutedLine(QWidget* parent);

}  // namespace nmc
