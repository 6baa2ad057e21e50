// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"
#include "protocol/commandcode.h"

namespace nmc::test {

/// A packet that the engine gave to its port, or the nulls between two.
struct WireItem {
    TimePoint time;
    std::uint32_t baud = 0;            ///< what the port was set to
    std::vector<std::uint8_t> packet;  ///< empty: nulls
    std::size_t nulls = 0;
    std::uint32_t places = 0;  ///< of a stop: a bit for each module that has that address or is in that group

    [[nodiscard]] std::optional<CommandCode> code() const;
    [[nodiscard]] bool isStop() const { return code() == CommandCode::StopMotor; }
    [[nodiscard]] bool isStopFor(std::uint8_t place) const { return (places >> place & 1U) != 0; }
    /// As many as empty a command buffer that is filled in part (DS-V 4.1).
    [[nodiscard]] bool isFlush() const { return packet.empty() && nulls >= 16; }
    /// Meaningful for a packet only: an individual address, or a group's from 0x80 on.
    [[nodiscard]] std::uint8_t address() const { return packet[1]; }
    /// The first data byte; 0 without any.
    [[nodiscard]] std::uint8_t control() const { return packet.size() > 4 ? packet[3] : std::uint8_t{0}; }
};

/// What one write to the port holds. Written from the data sheet's frame (DS-V 4.1), not with the encoder.
[[nodiscard]] std::vector<WireItem> itemsOf(ByteSpan bytes, TimePoint time, std::uint32_t baud);

}  // namespace nmc::test
