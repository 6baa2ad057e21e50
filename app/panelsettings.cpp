// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panelsettings.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFile>
#include <QLockFile>
#include <QTimer>

namespace nmc {

namespace {

/// Writing takes some milliseconds: a panel that holds the lock for longer has died.
constexpr int kStale = 1'000;
constexpr int kLongest = 2 * kStale;
constexpr int kTryAgain = 300;

}  // namespace

void nameApplication() {
    QCoreApplication::setOrganizationName(QStringLiteral("nmcpanel"));
    QCoreApplication::setOrganizationDomain(QStringLiteral("nmcpanel.org"));
    QCoreApplication::setApplicationName(QStringLiteral("NMC Panel"));
    QCoreApplication::setApplicationVersion(QStringLiteral(NMC_VERSION));
}

PanelSettings::PanelSettings() {
    (void)isLocked(kLongest);
}

PanelSettings::PanelSettings(const QString& file) : QSettings(file, QSettings::IniFormat) {
    (void)isLocked(kLongest);
}

PanelSettings::~PanelSettings() {
    (void)isLocked(kLongest);
}

bool PanelSettings::event(QEvent* event) {
    if (event->type() != QEvent::UpdateRequest || !isLocked(0))
        return QSettings::event(event);
    QTimer::singleShot(kTryAgain, this,
                       [this] { QCoreApplication::postEvent(this, new QEvent(QEvent::UpdateRequest)); });
    return true;
}

bool PanelSettings::isLocked(int milliseconds) const {
    const QString name = fileName() + QStringLiteral(".lock");
    if (!QFile::exists(name))
        return false;
    QLockFile lock(name);
    lock.setStaleLockTime(kStale);
    return !lock.tryLock(milliseconds) && lock.error() == QLockFile::LockFailedError;
}

}  // namespace nmc
