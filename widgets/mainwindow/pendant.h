// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QString>

class QAction;
class QKeyEvent;
class QWidget;

namespace nmc {

class Gamepad;
class HoldButton;
class JogWheel;
class ModulePanel;
class MoveByBox;

/// Keyboard, gamepad and jog wheel as a pendant: a mode in which Shift with an arrow key presses the hold
/// button of the module that is shown, and brings it into view; neither key alone moves anything. On a
/// gamepad, a shoulder button and a direction do the same, and so do a button and the ring of a jog wheel,
/// whose wheel moves by steps. Whatever ends a hold ends this one, and so do the release of either key, any
/// other key, and the mouse; auto-repeat is not a press. The mode itself ends on Esc, when the window is no
/// longer the active one, and when the module accepts no commands.
class Pendant : public QObject {
    Q_OBJECT

public:
    Pendant(QWidget& window, ModulePanel& panel);

    /// Begins and ends the mode.
    [[nodiscard]] QAction* action() const { return m_action; }
    [[nodiscard]] bool isOn() const;
    /// `reason`: why the pendant cannot move the module that is shown; empty if it can.
    void showModule(const QString& reason);
    /// Why the last press moved nothing; empty if it moved the motor.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    // Known only while the mode is on.
    [[nodiscard]] bool hasGamepad() const;
    [[nodiscard]] const JogWheel& wheel() const { return *m_wheel; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The mode, problem(), hasGamepad() or wheel() has changed.
    void changed();
    /// The stop button of the gamepad or the jog wheel was pressed, whatever else is held.
    void stopRequested();

private:
    void setOn(bool on);
    [[nodiscard]] bool endsMode(const QObject& watched, QEvent::Type type) const;
    [[nodiscard]] bool takeKey(const QKeyEvent& key, bool pressed);
    [[nodiscard]] bool isOurs(const QObject& watched) const;
    void press(bool reverse, double share = 1);
    void push(double share);
    void turn(int detents);
    void setProblem(const QString& problem);
    void release();

    QWidget& m_window;
    ModulePanel& m_panel;
    QAction* m_action;
    QString m_problem;
    Gamepad* m_gamepad;
    JogWheel* m_wheel;
    QPointer<HoldButton> m_held;
    QPointer<MoveByBox> m_turned;
    int m_arrow = 0;  ///< the arrow key that is held; 0: none
};

}  // namespace nmc
