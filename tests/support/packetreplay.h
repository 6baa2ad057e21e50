// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "model/packets/packetfile.h"
#include "sim/chain.h"

namespace nmc::test {

/// Sends the commands of a log again, at their times and rates, and returns what came back for each:
/// everything that arrived before the next one was sent.
[[nodiscard]] inline std::vector<std::vector<std::uint8_t>> replay(const PacketFile& file,
                                                                   sim::Chain& chain) {
    std::vector<std::vector<std::uint8_t>> replies(file.entries.size());
    for (std::size_t i = 0; i < file.entries.size(); ++i) {
        const bus::ExchangeRecord& record = file.entries[i].record;
        chain.advanceTo(record.sent);
        (void)chain.takeHostBytes();
        chain.setHostBaud(record.baud);
        chain.hostSends(record.command, record.sent);
        const bool last = i + 1 == file.entries.size();
        chain.advanceTo(last ? record.ended : file.entries[i + 1].record.sent);
        for (const sim::HostByte& byte : chain.takeHostBytes())
            replies[i].push_back(byte.value);
    }
    return replies;
}

}  // namespace nmc::test
