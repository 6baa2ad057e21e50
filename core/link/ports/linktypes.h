// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <cstdint>

namespace nmc {

/// One entry of the port list.
struct PortEntry {
    QString name;              ///< name to open: "/dev/ttyUSB0", or kSimulatorPort
    QString description;       ///< "USB Serial Converter", may be empty
    QString serialNumber{};    ///< serial number of a USB adapter, where it has one
    std::uint16_t vendor = 0;  ///< vendor ID of a USB adapter, otherwise 0
    std::uint16_t product = 0;
    bool operator==(const PortEntry&) const = default;
};

/// The name of the built-in simulator in the port list; a chain may follow after '='
/// ("simulator=servo,servo@1").
inline const QString kSimulatorPort = QStringLiteral("simulator");

}  // namespace nmc
