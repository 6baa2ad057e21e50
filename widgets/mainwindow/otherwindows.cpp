// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/otherwindows.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace nmc {

OtherWindows::OtherWindows(QWidget* mainWindow) : QObject(mainWindow), m_mainWindow(mainWindow) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool OtherWindows::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (event->spontaneous() && type != QEvent::Close)
        return false;  // minimised or restored
    if (type != QEvent::Show && type != QEvent::Hide && type != QEvent::Close)
        return false;
    auto* window = qobject_cast<QWidget*>(watched);
    if (window == nullptr || !window->isWindow() || window == m_mainWindow ||
        window->windowType() == Qt::ToolTip)
        return false;
    if (type == QEvent::Close && m_blocked.values().contains(window)) {
        event->ignore();
        return true;
    }
    if (type == QEvent::Hide) {
        if (const QPointer<QWidget> waiting = m_blocked.take(window))
            waiting->setEnabled(true);
    } else if (type == QEvent::Show) {
        if (window->isModal())
            unblock(*window);
        emit opened();
    }
    return false;
}

/// This is in time: a window becomes modal only after its show event.
void OtherWindows::unblock(QWidget& window) {
    window.setWindowModality(Qt::NonModal);
    QWidget* asking = window.parentWidget() != nullptr ? window.parentWidget()->window() : nullptr;
    if (asking == nullptr || asking == m_mainWindow)
        return;
    asking->setEnabled(false);
    window.setEnabled(true);
    m_blocked.insert(&window, asking);
}

}  // namespace nmc
