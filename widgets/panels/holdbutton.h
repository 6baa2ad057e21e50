// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QTimer>
#include <functional>
#include <optional>

#include "bus/types.h"

namespace nmc {

class ModuleContext;

/// Hold to move: requests motion when pressed, and repeatedly while it is held, as evidence for the bus
/// thread, which stops the motor when no more evidence arrives. Ends when mouse, touch or key is released,
/// when the pointer leaves, on another key or mouse button, when the focus is lost, when the window is
/// deactivated, hidden or blocked by a dialog, and when the button is disabled. Once ended, it stays ended
/// until it is pressed again.
class HoldButton : public QPushButton {
    Q_OBJECT

public:
    explicit HoldButton(QWidget* parent = nullptr);

    /// The direction in which it moves the motor; None for PWM.
    enum class Direction { None, Forward, Reverse };
    void setDirection(Direction direction) { m_direction = direction; }
    [[nodiscard]] Direction direction() const { return m_direction; }
    /// Begins a hold from elsewhere, like a press of the mouse, if the button is enabled and visible.
    /// `share`: of the speed of a press, above 0 and up to 1.
    void beginHold(double share = 1);
    /// Changes it during the hold.
    void setShare(double share);
    [[nodiscard]] double share() const { return m_share; }
    /// Interval of held() while the button is held; 100 ms by default.
    void setInterval(int milliseconds) { m_timer.setInterval(milliseconds); }
    [[nodiscard]] bool isHeld() const { return m_timer.isActive(); }
    /// Number of its present or last press, counted over all hold buttons; for bus::HoldToMove.
    [[nodiscard]] quint32 press() const { return m_press; }
    /// Ends the hold from outside: another module, another speed, a port error, or the bus has ended the
    /// motion.
    void endHold();

signals:
    void held();
    void holdEnded();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    void begin(double share = 1);

    QTimer m_timer;
    quint32 m_press = 0;
    double m_share = 1;
    Direction m_direction = Direction::None;
};

/// What a hold requests at a share of the speed of a press; empty if nothing is possible.
using WantedHold = std::function<std::optional<bus::HoldToMove>(double share)>;
/// A button that jogs the module while it is held. `reverse`: as the user sees it.
[[nodiscard]] HoldButton* newJogButton(ModuleContext& context, bool reverse, const WantedHold& wanted,
                                       QWidget* parent);

}  // namespace nmc
