// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>

namespace nmc {

/// One entry of the port list.
struct PortEntry {
    QString name;              ///< what is opened: "/dev/ttyUSB0", or kSimulatorPort
    QString description;       ///< "USB Serial Converter", may be empty
    QString serialNumber{};    ///< of a USB adapter, where it has one
    std::uint16_t vendor = 0;  ///< of a USB adapter, otherwise 0
    std::uint16_t product = 0;
    bool operator==(const PortEntry&) const = default;
};

/// The name of the built-in simulator in the port list; a chain may follow after '='
/// ("simulator=servo,servo@1").
inline const QString kSimulatorPort = QStringLiteral("simulator");

/// Why a port cannot be used, or is no longer.
enum class PortProblem : std::uint8_t {
    NotFound,
    NoPermission,
    InUse,
    StaleLock,     ///< a program that is gone has left its lock file, and it is another user's
    NoLockFolder,  ///< no lock file can be made, and the serial port library insists on one
    NotASerialPort,
    RateNotPossible,
    TooManyFiles,  ///< this program has no file descriptor left
    Gone,          ///< it was open: unplugged, or the other end closed
    Other,         ///< detail holds the system's own words
};

struct PortError {
    PortProblem problem = PortProblem::Other;
    QString port;
    QString group;         ///< NoPermission: the group that may use the port, where it is known
    QString user;          ///< NoPermission: the present user; StaleLock: the owner of the lock file
    QString detail;        ///< the system's own words
    int movingMotors = 0;  ///< Gone: how many were moving at the last word
    QString program{};     ///< InUse: who uses it, where that can be known
    qint64 pid = 0;        ///< InUse: the same; 0 where it cannot be known
    QString lockFile{};    ///< StaleLock: to be removed; NoLockFolder: the folder it should be in
};

}  // namespace nmc
