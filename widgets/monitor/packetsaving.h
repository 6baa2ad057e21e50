// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <tl/expected.hpp>

#include "model/packets/packetlog.h"

namespace nmc {

/// How a name of a replayable log (model/packets/packetfile.h) ends; any other name makes a text for people.
inline const QString kPacketLogSuffix = QStringLiteral(".nmclog");

/// Writes the whole log, whatever the filter shows; a file that cannot be written whole is left as it was.
/// The error is the system's reason.
[[nodiscard]] tl::expected<void, QString> savePackets(const PacketLog& log, const QString& path);

}  // namespace nmc
