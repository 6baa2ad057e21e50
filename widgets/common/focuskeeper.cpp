// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/focuskeeper.h"

#include <QEvent>
#include <QTabBar>
#include <QTabWidget>

namespace nmc {

FocusKeeper::FocusKeeper(QWidget& window) : QObject(&window), m_window(window) {}

bool FocusKeeper::leave() {
    QWidget* focused = m_window.focusWidget();
    if (focused == nullptr || (focused->isEnabled() && focused->isVisible()))
        return false;
    if (m_left != nullptr)
        m_left->removeEventFilter(this);
    m_left = focused;
    m_left->installEventFilter(this);
    focused->clearFocus();
    return true;
}

bool FocusKeeper::resume(bool forward) {
    if (m_window.focusWidget() != nullptr || m_left == nullptr || m_left->window() != &m_window)
        return false;
    const auto step = [forward](const QWidget* widget) {
        return forward ? widget->nextInFocusChain() : widget->previousInFocusChain();
    };
    for (QWidget* next = step(m_left); next != m_left; next = step(next))
        if ((next->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && next->isEnabled() && next->isVisible() &&
            next->focusProxy() == nullptr) {
            next->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
            return true;
        }
    return false;
}

bool FocusKeeper::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::EnabledChange && watched == m_left && m_left->isEnabled() &&
        m_left->isVisible() && m_window.focusWidget() == nullptr)
        m_left->setFocus(Qt::OtherFocusReason);
    return false;
}

void keepFocusOnTabs(QTabWidget& pages) {
    QObject::connect(&pages, &QTabWidget::currentChanged, &pages, [&pages] {
        QWidget* focused = pages.window()->focusWidget();
        if (focused == nullptr || !pages.isAncestorOf(focused))
            return;
        if (pages.tabBar()->isHidden())
            focused->clearFocus();
        else
            pages.tabBar()->setFocus(Qt::OtherFocusReason);
    });
}

}  // namespace nmc
