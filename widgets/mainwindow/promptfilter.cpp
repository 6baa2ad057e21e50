// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/promptfilter.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QShortcutEvent>

namespace nmc {

PromptFilter::PromptFilter(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool PromptFilter::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Shortcut || static_cast<QShortcutEvent*>(event)->isAmbiguous())
        return false;
    auto* button = qobject_cast<QAbstractButton*>(watched);
    if (button == nullptr)
        return false;
    button->click();
    return true;
}

}  // namespace nmc
