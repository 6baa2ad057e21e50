// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "bus/exchange.h"
#include "tests/bus/scriptedbus.h"

/// Replies composed by hand, byte by byte as the data sheets describe them (DS-V 5.3, DS-S 5.2).
namespace nmc::test {

// Items of a reply: all of them; position, A/D, velocity and aux; or the position alone.
inline constexpr std::uint8_t kLong = 0x3F;
inline constexpr std::uint8_t kShort = 0x0F;
inline constexpr std::uint8_t kBrief = 0x01;

/// A reply of a servo that is off, at 0: status, position, A/D, aux and the sum.
inline constexpr const char* kReply = "19 00 00 00 00 00 00 19 ";

/// A PIC-SERVO that holds: move_done and power_on, servo_on.
struct ServoState {
    std::uint8_t status = 0x09;
    std::int32_t position = 0;
    std::uint8_t analog = 0;
    std::int16_t velocity = 0;  ///< counts per tick; its negative is sent
    std::uint8_t aux = 0x04;
    std::int32_t home = 0;
    std::uint8_t type = 0;
    std::uint8_t version = 4;
};

/// A PIC-STEP at rest: amplifier and power on.
struct StepperState {
    std::uint8_t status = 0x0C;
    std::int32_t position = 0;
    std::uint8_t analog = 255;
    std::uint16_t timer = 0;
    std::uint8_t inputs = 0;
    std::int32_t home = 0;
    std::uint8_t type = 3;
    std::uint8_t version = 1;
};

[[nodiscard]] inline std::vector<std::uint8_t> replyBytes(std::uint8_t items, std::uint8_t status,
                                                          std::int32_t position, std::uint8_t analog,
                                                          std::uint16_t word, std::uint8_t aux,
                                                          std::int32_t home, std::uint8_t type,
                                                          std::uint8_t version) {
    std::vector<std::uint8_t> bytes{status};
    const auto add = [&](std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    if ((items & 0x01) != 0)
        add(static_cast<std::uint32_t>(position), 4);
    if ((items & 0x02) != 0)
        add(analog, 1);
    if ((items & 0x04) != 0)
        add(word, 2);
    if ((items & 0x08) != 0)
        add(aux, 1);
    if ((items & 0x10) != 0)
        add(static_cast<std::uint32_t>(home), 4);
    if ((items & 0x20) != 0) {
        add(type, 1);
        add(version, 1);
    }
    return withSum(bytes);
}

[[nodiscard]] inline std::vector<std::uint8_t> bytesOf(const ServoState& s, std::uint8_t items) {
    return replyBytes(items, s.status, s.position, s.analog, static_cast<std::uint16_t>(-s.velocity), s.aux,
                      s.home, s.type, s.version);
}
[[nodiscard]] inline std::vector<std::uint8_t> bytesOf(const StepperState& s, std::uint8_t items) {
    return replyBytes(items, s.status, s.position, s.analog, s.timer, s.inputs, s.home, s.type, s.version);
}

/// The end that the line reports for bytes with a correct sum.
[[nodiscard]] inline bus::ReplyEnd accepted(ModuleType type, std::uint8_t items,
                                            const std::vector<std::uint8_t>& bytes, TimePoint latched) {
    bus::ReplyEnd end;
    const auto report = decodeStatus({type, 1}, StatusItems(items), bytes);
    end.result = report ? bus::ReplyResult::Accepted : bus::ReplyResult::BadChecksum;
    if (report)
        end.report = *report;
    end.latched = latched;
    end.latchedBy = latched + std::chrono::microseconds(500);
    end.bytes = bus::ReplyBytes(ByteSpan(bytes));
    return end;
}

}  // namespace nmc::test
