// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"
#include "protocol/commandcode.h"

namespace nmc::test {

/// A packet that the engine gave to its port, or the nulls between two packets.
struct WireItem {
    TimePoint time;
    std::uint32_t baud = 0;            ///< rate of the port
    std::vector<std::uint8_t> packet;  ///< empty for nulls
    std::size_t nulls = 0;
    std::uint32_t places = 0;  ///< of a stop: a bit for each module that has its address or is in its group

    [[nodiscard]] std::optional<CommandCode> code() const;
    [[nodiscard]] bool isStop() const { return code() == CommandCode::StopMotor; }
    [[nodiscard]] bool isStopFor(std::uint8_t place) const { return (places >> place & 1U) != 0; }
    /// True if there are enough nulls to empty a partly filled command buffer (DS-V 4.1).
    [[nodiscard]] bool isFlush() const { return packet.empty() && nulls >= 16; }
    /// Only meaningful for a packet: an individual address, or that of a group, from 0x80 on.
    [[nodiscard]] std::uint8_t address() const { return packet[1]; }
    /// The first data byte, or 0 if there is none.
    [[nodiscard]] std::uint8_t control() const { return packet.size() > 4 ? packet[3] : std::uint8_t{0}; }
};

/// Splits one write to the port into its items. Written from the data sheet's frame (DS-V 4.1), without the
/// encoder.
[[nodiscard]] std::vector<WireItem> itemsOf(ByteSpan bytes, TimePoint time, std::uint32_t baud);

}  // namespace nmc::test
