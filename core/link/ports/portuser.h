// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

#include "link/ports/porterror.h"

namespace nmc {

/// Where this machine shows who uses a port; tests substitute their own places.
struct PortUserPlaces {
    /// The folders in which QSerialPort tries to create lock files, in its order; it uses the first that is
    /// writable.
    QStringList lockFolders{
        QStringLiteral("/var/lock"),         QStringLiteral("/etc/locks"), QStringLiteral("/var/spool/locks"),
        QStringLiteral("/var/spool/uucp"),   QStringLiteral("/tmp"),       QStringLiteral("/var/tmp"),
        QStringLiteral("/var/lock/lockdev"), QStringLiteral("/run/lock")};
    QString proc = QStringLiteral("/proc");
};

/// The device file of a port named by QSerialPortInfo or by its path.
[[nodiscard]] QString devicePath(const QString& port);

/// Finds out why a port that exists, and that this user may use, cannot be opened, from its lock file and
/// from the open files of those processes that this user may inspect. The result is InUse, with the program
/// if known, StaleLock, or NoLockFolder. Takes tens of milliseconds on a busy machine.
[[nodiscard]] PortError whyBusy(const QString& port, const PortUserPlaces& places = {});

}  // namespace nmc
