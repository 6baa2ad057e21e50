// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>

namespace nmc {

/// One entry of the port list.
struct PortEntry {
    QString name;         ///< what is opened: "/dev/ttyUSB0", or kSimulatorPort
    QString description;  ///< "USB Serial Converter", may be empty
};

/// The name of the built-in simulator in the port list; a chain may follow after '='
/// ("simulator=servo,servo@1").
inline const QString kSimulatorPort = QStringLiteral("simulator");

/// Why a port cannot be used, or is no longer.
enum class PortProblem : std::uint8_t {
    NotFound,
    NoPermission,
    InUse,
    NotASerialPort,
    RateNotPossible,
    Gone,   ///< it was open: unplugged, or the other end closed
    Other,  ///< detail holds the system's own words
};

struct PortError {
    PortProblem problem = PortProblem::Other;
    QString port;
    QString group;         ///< NoPermission: the group that may use the port, where it is known
    QString user;          ///< NoPermission: the present user
    QString detail;        ///< the system's own words
    int movingMotors = 0;  ///< Gone: how many were moving at the last word
};

}  // namespace nmc
