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
class ModulePanel;

/// Keyboard and gamepad as a pendant: a mode in which Shift with an arrow key presses the hold button of the
/// module that is shown, which comes in sight; neither key alone moves anything. A gamepad does the same by a
/// shoulder button and a way. What ends a hold ends this one, and so do the release of either, any other key,
/// and the mouse; auto-repeat is no press. The mode itself ends with Esc, when the window is not the active
/// one any more, and when the module cannot be told anything.
class Pendant : public QObject {
    Q_OBJECT

public:
    Pendant(QWidget& window, ModulePanel& panel);

    /// Begins and ends the mode.
    [[nodiscard]] QAction* action() const { return m_action; }
    [[nodiscard]] bool isOn() const;
    /// Why there is no pendant for the module that is shown; empty: there is one.
    void showModule(const QString& reason);
    /// Why the last press moved nothing; empty: it did.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// There is one; known only while the mode is on.
    [[nodiscard]] bool hasGamepad() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The mode, problem(), or hasGamepad().
    void changed();
    /// By the gamepad, whatever is held.
    void stopRequested();

private:
    void setOn(bool on);
    [[nodiscard]] bool endsMode(const QObject& watched, QEvent::Type type) const;
    [[nodiscard]] bool takeKey(const QKeyEvent& key, bool pressed);
    [[nodiscard]] bool isOurs(const QObject& watched) const;
    void press(bool reverse);
    void release();

    QWidget& m_window;
    ModulePanel& m_panel;
    QAction* m_action;
    QString m_problem;
    Gamepad* m_gamepad;
    QPointer<HoldButton> m_held;
    int m_arrow = 0;  ///< the key that is held; 0: none
};

}  // namespace nmc
