// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "model/packets/packetlog.h"
#include "widgets/common/filedialog.h"

namespace nmc {

/// The end of the name of a replayable log (model/packets/packetfile.h); any other name stands for text for
/// people.
inline const QString kPacketLogSuffix = QStringLiteral(".nmclog");

/// The whole log, in the format that the name of the file requires.
[[nodiscard]] FileContent packetFile(PacketLog log, const QString& path);
/// The last packets, at most `most`, as text for people; empty if there are none.
[[nodiscard]] std::string lastPackets(const PacketLog& log, std::uint64_t most);

}  // namespace nmc
