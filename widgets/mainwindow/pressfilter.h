// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for presses at the place of the stop button that something else would take:
/// an open menu, the list of a combo box, another finger. Such a press stops, closes the popups, and does
/// nothing else. A window that covers the button keeps its own presses.
class PressFilter : public QObject {
    Q_OBJECT

public:
    /// `button` must outlive it.
    PressFilter(const QWidget& button, QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void pressed();

private:
    [[nodiscard]] bool comesByItself(const QObject* watched) const;
    [[nodiscard]] bool isOnButton(const QPoint& global) const;

    const QWidget& m_button;
};

}  // namespace nmc
