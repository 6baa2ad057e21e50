// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/wheelfilter.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QLineEdit>
#include <QScrollBar>

namespace nmc {

namespace {

/// Returns the widget if it has a value that the wheel would change, otherwise null.
QWidget* widgetWithValue(QObject* watched) {
    const bool slider =
        qobject_cast<QAbstractSlider*>(watched) != nullptr && qobject_cast<QScrollBar*>(watched) == nullptr;
    const bool value = slider || qobject_cast<QComboBox*>(watched) != nullptr ||
                       qobject_cast<QAbstractSpinBox*>(watched) != nullptr ||
                       qobject_cast<QLineEdit*>(watched) != nullptr;
    return value ? static_cast<QWidget*>(watched) : nullptr;
}

}  // namespace

WheelFilter::WheelFilter(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool WheelFilter::eventFilter(QObject* watched, QEvent* event) {
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

}  // namespace nmc
