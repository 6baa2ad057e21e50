// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/inputfilters.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QShortcutEvent>
#include <QTextEdit>

namespace nmc {

namespace {

/// Watches for the wheel over combo boxes, spin boxes, sliders and fields: without the focus, which the wheel
/// does not give them either, they ignore it, and what surrounds them scrolls.
class WheelFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
            return false;
        QWidget* value = widgetWithValue(watched);
        if (value == nullptr)
            return false;
        if (event->type() == QEvent::Polish) {
            if (value->focusPolicy() == Qt::WheelFocus)
                value->setFocusPolicy(Qt::StrongFocus);
            return false;
        }
        if (value->hasFocus())
            return false;
        event->ignore();
        return true;
    }

private:
    /// Returns the widget if it has a value that the wheel would change, otherwise null.
    static QWidget* widgetWithValue(QObject* watched) {
        const bool slider = qobject_cast<QAbstractSlider*>(watched) != nullptr &&
                            qobject_cast<QScrollBar*>(watched) == nullptr;
        const bool value = slider || qobject_cast<QComboBox*>(watched) != nullptr ||
                           qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                           qobject_cast<QLineEdit*>(watched) != nullptr;
        return value ? static_cast<QWidget*>(watched) : nullptr;
    }
};

/// Watches for shortcuts and mnemonics of buttons, and makes them act at once. Qt would first show the button
/// pressed for 100 ms, and then click it whatever it does by then: a stop would be delayed, and a move might
/// be that of another module.
class PromptFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Shortcut || static_cast<QShortcutEvent*>(event)->isAmbiguous())
            return false;
        auto* button = qobject_cast<QAbstractButton*>(watched);
        if (button == nullptr)
            return false;
        button->click();
        return true;
    }
};

/// Watches for keys that repeat while they are held, so that repeats trigger no command. Enter, shortcuts of
/// the window, and keys on buttons and combo boxes count once for each press; typing, Tab, and the shortcuts
/// of a single view, such as the scope, repeat as usual. A held jog does not depend on repeats.
class RepeatFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Shortcut)
            return m_repeats && !ofOneView(watched);
        if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
            return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        m_repeats = key->isAutoRepeat();
        return m_repeats && event->type() == QEvent::KeyPress && triggers(watched, key->key());
    }

private:
    /// True for a key press that triggers something, rather than types or moves the focus.
    static bool triggers(const QObject* watched, int key) {
        if (key == Qt::Key_Return || key == Qt::Key_Enter)
            return true;
        const bool tab = key == Qt::Key_Tab || key == Qt::Key_Backtab;
        const auto* box = qobject_cast<const QComboBox*>(watched);
        return !tab && (qobject_cast<const QAbstractButton*>(watched) != nullptr ||
                        (box != nullptr && !box->isEditable()));
    }
    /// True for a shortcut of a single view, where it may repeat.
    static bool ofOneView(const QObject* watched) {
        const auto* action = qobject_cast<const QAction*>(watched);
        return action != nullptr && action->shortcutContext() == Qt::WidgetWithChildrenShortcut;
    }

    bool m_repeats = false;  ///< the last key event, which may become a shortcut, is a repeat
};

/// Watches for keys of commands by which fields edit on X11: Ctrl+U removes the line, Ctrl+K its rest, Ctrl+D
/// the next character, and Ctrl+E goes to its end. No field gets them, not even while the command is not
/// possible: a press that was meant to stop a motor would empty it.
class CommandKeyFilter : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
            return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool edits = key->key() == Qt::Key_U || key->key() == Qt::Key_K || key->key() == Qt::Key_D ||
                           key->key() == Qt::Key_E;
        if (!edits || key->modifiers() != Qt::ControlModifier || !takesText(watched))
            return false;
        event->ignore();
        return true;
    }

private:
    static bool takesText(const QObject* watched) {
        const auto* box = qobject_cast<const QComboBox*>(watched);
        return (box != nullptr && box->isEditable()) || qobject_cast<const QLineEdit*>(watched) != nullptr ||
               qobject_cast<const QTextEdit*>(watched) != nullptr ||
               qobject_cast<const QPlainTextEdit*>(watched) != nullptr;
    }
};

}  // namespace

void installInputFilters(QObject* parent) {
    // The last one receives events first: no repeat comes to the PromptFilter.
    for (QObject* filter :
         std::initializer_list<QObject*>{new WheelFilter(parent), new PromptFilter(parent),
                                         new CommandKeyFilter(parent), new RepeatFilter(parent)})
        QCoreApplication::instance()->installEventFilter(filter);
}

}  // namespace nmc
