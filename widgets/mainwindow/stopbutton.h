// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

namespace nmc {

/// STOP ALL: black with white words and an octagon, at least 15 mm high, always in the same place. It acts on
/// press.
class StopButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit StopButton(QWidget* parent = nullptr);

    /// "reaches 5 of 5"; empty while no port is open.
    void showReach(const QString& reach);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QFont largeFont() const;
    [[nodiscard]] int symbolSide() const;

    QString m_reach;
};

}  // namespace nmc
