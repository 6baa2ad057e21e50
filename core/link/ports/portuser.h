// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include "link/ports/porterror.h"

namespace nmc {

/// Where this machine says who uses a port; tests bring their own.
struct PortUserPlaces {
    /// Where QSerialPort looks for a folder of lock files, in its order; it takes the first it may write to.
    QStringList lockFolders{
        QStringLiteral("/var/lock"),         QStringLiteral("/etc/locks"), QStringLiteral("/var/spool/locks"),
        QStringLiteral("/var/spool/uucp"),   QStringLiteral("/tmp"),       QStringLiteral("/var/tmp"),
        QStringLiteral("/var/lock/lockdev"), QStringLiteral("/run/lock")};
    QString proc = QStringLiteral("/proc");
};

/// The file of a port that is named as QSerialPortInfo does, or by its path.
[[nodiscard]] QString devicePath(const QString& port);

/// Why a port that exists, and that this user may use, is not to be had: by its lock file, and by the open
/// files of those processes that this user may look into. InUse, with the program where it can be known,
/// StaleLock, or NoLockFolder. Tens of milliseconds on a busy machine.
[[nodiscard]] PortError whyBusy(const QString& port, const PortUserPlaces& places = {});

}  // namespace nmc
