// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/repeatfilter.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>

namespace nmc {

namespace {

/// True for a key press that triggers something, rather than types or moves the focus.
bool triggers(const QObject* watched, int key) {
    if (key == Qt::Key_Return || key == Qt::Key_Enter)
        return true;
    const bool tab = key == Qt::Key_Tab || key == Qt::Key_Backtab;
    const auto* box = qobject_cast<const QComboBox*>(watched);
    return !tab && (qobject_cast<const QAbstractButton*>(watched) != nullptr ||
                    (box != nullptr && !box->isEditable()));
}

/// True for a shortcut of a single view, where it may repeat.
bool ofOneView(const QObject* watched) {
    const auto* action = qobject_cast<const QAction*>(watched);
    return action != nullptr && action->shortcutContext() == Qt::WidgetWithChildrenShortcut;
}

}  // namespace

RepeatFilter::RepeatFilter(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool RepeatFilter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Shortcut)
        return m_repeats && !ofOneView(watched);
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    m_repeats = key->isAutoRepeat();
    return m_repeats && event->type() == QEvent::KeyPress && triggers(watched, key->key());
}

}  // namespace nmc
