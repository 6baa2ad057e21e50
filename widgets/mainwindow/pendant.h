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

class HoldButton;
class ModulePanel;

/// The keyboard as a pendant: a mode in which Shift with an arrow key presses the hold button of the module
/// that is shown, which comes in sight; neither key alone moves anything. What ends a hold ends this one, and
/// so do the release of either key, any other key, and the mouse; auto-repeat is no press. The mode itself
/// ends with Esc, when the window is not the active one any more, and when the module cannot be told
/// anything.
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

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The mode, or problem().
    void changed();

private:
    void setOn(bool on);
    [[nodiscard]] bool endsMode(const QObject& watched, QEvent::Type type) const;
    [[nodiscard]] bool takeKey(const QKeyEvent& key, bool pressed);
    [[nodiscard]] bool isOurs(const QObject& watched) const;
    void press(int arrow);
    void release();

    QWidget& m_window;
    ModulePanel& m_panel;
    QAction* m_action;
    QString m_problem;
    QPointer<HoldButton> m_held;
    int m_arrow = 0;  ///< the key that is held; 0: none
};

}  // namespace nmc
