// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QTimer>

namespace nmc {

/// Hold to move: asks for motion when pressed and again while it is held, as evidence for the bus thread,
/// which stops the motor when the evidence stops coming. Ends on release of mouse, touch or key, when the
/// pointer leaves, on another key or mouse button, focus out, window deactivated, hidden or blocked by a
/// dialog, and when disabled. Once ended it stays ended until it is pressed anew.
class HoldButton : public QPushButton {
    Q_OBJECT

public:
    explicit HoldButton(QWidget* parent = nullptr);

    /// Which way it moves the motor; PWM is no way.
    enum class Direction { None, Forward, Reverse };
    void setDirection(Direction direction) { m_direction = direction; }
    [[nodiscard]] Direction direction() const { return m_direction; }
    /// A press from elsewhere: as one of the mouse, where it is enabled and in sight.
    void beginHold();
    /// How often held() comes while it is held; 100 ms.
    void setInterval(int milliseconds) { m_timer.setInterval(milliseconds); }
    [[nodiscard]] bool isHeld() const { return m_timer.isActive(); }
    /// Which press of all hold buttons this is, or was last; for bus::HoldToMove.
    [[nodiscard]] quint32 press() const { return m_press; }
    /// Ends the motion from outside: another module, another speed, a port error, or the bus has ended it.
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
    void begin();

    QTimer m_timer;
    quint32 m_press = 0;
    Direction m_direction = Direction::None;
};

}  // namespace nmc
