// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace nmc {

/// A label with a fixed number of lines, whatever its text, so that nothing below it ever moves. If the text
/// does not fit, its last line ends in …, and the tool tip shows all of it. Plain text.
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

/// Makes a label for one line of muted secondary text, which shrinks in favour of its neighbours.
[[nodiscard]] ElidedLabel* newMutedLine(QWidget* parent, const QString& objectName = {});

}  // namespace nmc
