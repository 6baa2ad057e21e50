// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/packets/packetlog.h"
#include "widgets/common/filedialog.h"

namespace nmc {

/// How a name of a replayable log (model/packets/packetfile.h) ends; any other name makes a text for people.
inline const QString kPacketLogSuffix = QStringLiteral(".nmclog");

/// The whole log as a file of that name has it.
[[nodiscard]] FileContent packetFile(PacketLog log, const QString& path);
/// At most so many, the last ones, as text for people; empty: there are none.
[[nodiscard]] std::string lastPackets(const PacketLog& log, std::uint64_t most);

}  // namespace nmc
