// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panelsettings.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLockFile>
#include <QTimer>

namespace nmc {

namespace {

/// Writing takes some milliseconds: whoever holds the lock for longer has died.
constexpr int kStale = 1'000;
constexpr int kLongest = 2 * kStale;
constexpr int kTryAgain = 300;

}  // namespace

PanelSettings::PanelSettings() {
    (void)isFree(kLongest);
}

PanelSettings::PanelSettings(const QString& file) : QSettings(file, QSettings::IniFormat) {
    (void)isFree(kLongest);
}

PanelSettings::~PanelSettings() {
    (void)isFree(kLongest);
}

bool PanelSettings::event(QEvent* event) {
    if (event->type() != QEvent::UpdateRequest || isFree(0))
        return QSettings::event(event);
    QTimer::singleShot(kTryAgain, this,
                       [this] { QCoreApplication::postEvent(this, new QEvent(QEvent::UpdateRequest)); });
    return true;
}

bool PanelSettings::isFree(int milliseconds) const {
    QLockFile lock(fileName() + QStringLiteral(".lock"));
    lock.setStaleLockTime(kStale);
    return lock.tryLock(milliseconds);
}

}  // namespace nmc
