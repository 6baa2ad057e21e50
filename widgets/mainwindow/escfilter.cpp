// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/escfilter.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMetaObject>

namespace nmc {

EscFilter::EscFilter(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool EscFilter::eventFilter(QObject* /*watched*/, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::ShortcutOverride && type != QEvent::KeyPress && type != QEvent::KeyRelease)
        return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != Qt::Key_Escape || key->isAutoRepeat())
        return false;
    if (type == QEvent::KeyRelease) {
        m_told = false;
        return false;
    }
    if (m_told)
        return false;
    m_told = true;
    // The release must not be all that ends this press: if it goes elsewhere, the next press would be
    // ignored.
    QMetaObject::invokeMethod(
        this, [this] { m_told = false; }, Qt::QueuedConnection);
    emit pressed();
    return false;
}

}  // namespace nmc
