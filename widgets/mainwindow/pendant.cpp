// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/pendant.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <QWindow>
#include <cmath>
#include <utility>

#include "widgets/gamepad/gamepad.h"
#include "widgets/gamepad/jogwheel.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/modulepage.h"
#include "widgets/panels/modulepanel.h"
#include "widgets/panels/movebybox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

bool isArrow(int key) {
    return key == Qt::Key_Left || key == Qt::Key_Right;
}

/// True if Shift is the only modifier; the arrows may be those of the number pad.
bool enables(const QKeyEvent& key) {
    return (key.modifiers() & ~Qt::KeypadModifier) == Qt::ShiftModifier;
}

}  // namespace

Pendant::Pendant(QWidget& window, ModulePanel& panel)
    : QObject(&window),
      m_window(window),
      m_panel(panel),
      m_action(new QAction(tr("Pendant: &keyboard, gamepad or jog wheel"), this)),
      m_gamepad(new Gamepad(this)),
      m_wheel(new JogWheel(this)) {
    m_action->setObjectName(u"pendantAction"_s);
    m_action->setShortcut(Qt::Key_F12);
    m_action->setCheckable(true);
    m_action->setAutoRepeat(false);
    window.addAction(m_action);  // its shortcut acts whether its menu is open or not
    connect(m_action, &QAction::toggled, this, &Pendant::setOn);
    connect(m_gamepad, &Gamepad::changed, this, &Pendant::changed);
    connect(m_gamepad, &Gamepad::stopPressed, this, &Pendant::stopRequested);
    connect(m_gamepad, &Gamepad::released, this, &Pendant::release);
    connect(m_gamepad, &Gamepad::pressed, this, [this](bool reverse) {
        if (m_arrow != 0)
            release();  // as any other key does
        else
            press(reverse);
    });
    connect(m_wheel, &JogWheel::changed, this, &Pendant::changed);
    connect(m_wheel, &JogWheel::stopPressed, this, &Pendant::stopRequested);
    connect(m_wheel, &JogWheel::released, this, &Pendant::release);
    connect(m_wheel, &JogWheel::pushed, this, &Pendant::push);
    connect(m_wheel, &JogWheel::turned, this, &Pendant::turn);
    connect(&panel, &ModulePanel::pageChanged, this, [this] {
        release();
        setProblem({});  // it was the other module's
    });
}

bool Pendant::isOn() const {
    return m_action->isChecked();
}

bool Pendant::hasGamepad() const {
    return m_gamepad->isThere();
}

void Pendant::setOn(bool on) {
    if (on)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
    release();
    m_gamepad->setOn(on);
    m_wheel->setOn(on);
    m_problem.clear();
    emit changed();
}

void Pendant::showModule(const QString& reason) {
    m_action->setEnabled(reason.isEmpty());
    m_action->setToolTip(
        reason.isEmpty()
            ? tr("To move the motor, hold Shift with an arrow key, or a shoulder button of a gamepad with its left stick or D-pad, or a button of a jog wheel with its ring or wheel. B (○) of the gamepad and the middle button of the wheel are STOP ALL. (F12)")
            : reason);
    if (!reason.isEmpty())
        m_action->setChecked(false);
}

/// A key comes to the window first, and then to the widget that has the focus and its parents.
bool Pendant::isOurs(const QObject& watched) const {
    if (QApplication::activePopupWidget() != nullptr)
        return false;
    const auto* widget = qobject_cast<const QWidget*>(&watched);
    return widget != nullptr ? widget->window() == &m_window : &watched == m_window.windowHandle();
}

bool Pendant::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (endsMode(*watched, type))
        m_action->setChecked(false);
    else if (type == QEvent::MouseButtonPress || type == QEvent::Wheel || type == QEvent::TouchBegin)
        release();
    if (type != QEvent::ShortcutOverride && type != QEvent::KeyPress && type != QEvent::KeyRelease)
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape) {
        m_action->setChecked(false);  // the key is passed on, and stops all
        return false;
    }
    if (!isOn() || !isOurs(*watched))
        return false;
    if (type != QEvent::ShortcutOverride)
        return takeKey(*key, type == QEvent::KeyPress);
    if (isArrow(key->key()) && enables(*key))
        event->accept();
    return false;
}

bool Pendant::endsMode(const QObject& watched, QEvent::Type type) const {
    if (type == QEvent::ApplicationStateChange)
        return QGuiApplication::applicationState() != Qt::ApplicationActive;
    return &watched == &m_window &&
           (type == QEvent::WindowDeactivate || type == QEvent::WindowBlocked || type == QEvent::Hide);
}

/// Returns true if the key must not be passed on.
bool Pendant::takeKey(const QKeyEvent& key, bool pressed) {
    const bool held = m_arrow != 0;
    if (key.isAutoRepeat())
        return held || (isArrow(key.key()) && enables(key));
    if (!pressed) {
        const bool ends = key.key() == m_arrow || key.key() == Qt::Key_Shift;
        if (held && ends)
            release();
        return held && ends;
    }
    if (isArrow(key.key()) && enables(key) && !held) {
        m_arrow = key.key();
        press(m_arrow == Qt::Key_Left);
        return true;
    }
    release();
    return held;
}

void Pendant::press(bool reverse, double share) {
    if (m_held && m_held->isHeld())
        return release();  // by another hand: one motion has one hand
    ModulePage* page = m_panel.page();
    m_held = page != nullptr ? page->holdButton(reverse) : nullptr;
    if (m_held)
        m_held->beginHold(share);
    const bool moves = m_held && m_held->isHeld();
    setProblem(moves || !m_held ? QString() : m_held->toolTip());
}

void Pendant::push(double share) {
    const auto direction = share < 0 ? HoldButton::Direction::Reverse : HoldButton::Direction::Forward;
    if (m_held && m_held->direction() == direction)
        return m_held->setShare(std::abs(share));
    if (m_arrow != 0 || m_held)
        return release();
    press(share < 0, std::abs(share));
}

void Pendant::turn(int detents) {
    ModulePage* page = m_panel.page();
    m_turned = page != nullptr ? page->moveByBox() : nullptr;
    if (m_turned)
        connect(m_turned.data(), &MoveByBox::turnsDropped, this, &Pendant::setProblem, Qt::UniqueConnection);
    setProblem(m_turned ? m_turned->turn(detents) : QString());
}

void Pendant::setProblem(const QString& problem) {
    if (std::exchange(m_problem, problem) != problem)
        emit changed();
}

void Pendant::release() {
    m_arrow = 0;
    m_wheel->interrupt();
    if (m_turned)
        m_turned->endTurns();
    m_turned.clear();
    if (m_held)
        m_held->endHold();
    m_held.clear();
}

}  // namespace nmc
