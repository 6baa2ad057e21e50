// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/pressfilter.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTouchEvent>
#include <QWidget>
#include <QWindow>
#include <algorithm>

namespace nmc {

namespace {

void closePopups() {
    while (QWidget* popup = QApplication::activePopupWidget())
        if (!popup->close())
            return;
}

}  // namespace

PressFilter::PressFilter(const QWidget& button, QObject* parent) : QObject(parent), m_button(button) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool PressFilter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress) {
        const QPoint at = static_cast<QMouseEvent*>(event)->globalPosition().toPoint();
        if (!isOnButton(at) || comesByItself(watched))
            return false;
        closePopups();
        emit pressed();
        return true;
    }
    if (event->type() == QEvent::TouchUpdate && watched->isWindowType()) {
        // For widgets that do not handle touch, Qt turns the first finger into a mouse and ignores further
        // fingers.
        for (const QEventPoint& finger : static_cast<QTouchEvent*>(event)->points())
            if (finger.state() == QEventPoint::Pressed && isOnButton(finger.globalPosition().toPoint()))
                emit pressed();
    }
    return false;
}

/// True if the button will receive the press, or already has.
bool PressFilter::comesByItself(const QObject* watched) const {
    const bool ours = watched == &m_button || watched == m_button.window()->windowHandle();
    return ours && QApplication::activePopupWidget() == nullptr;
}

bool PressFilter::isOnButton(const QPoint& global) const {
    const QWidget* window = m_button.window();
    if (!m_button.isVisible() || !m_button.isEnabled() || window->isMinimized() ||
        !m_button.rect().contains(m_button.mapFromGlobal(global)))
        return false;
    const QWidgetList windows = QApplication::topLevelWidgets();
    return std::ranges::none_of(windows, [&](const QWidget* other) {
        return other != window && other->isVisible() && other->windowType() != Qt::ToolTip &&
               other->frameGeometry().contains(global);
    });
}

}  // namespace nmc
