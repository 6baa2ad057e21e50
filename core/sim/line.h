// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "base/bytes.h"
#include "base/time.h"
#include "protocol/baud.h"
#include "protocol/frame.h"
#include "protocol/moduletype.h"
#include "sim/random.h"

namespace nmc::sim {

/// A byte on its way from the host to the modules.
struct LineByte {
    TimePoint due;  ///< end of its stop bit, when the modules have it
    std::uint32_t baud = kPowerUpBaud;
    std::uint8_t value = 0;
    bool foreign = false;  ///< another host's
};

/// Where a command packet has its command byte.
inline constexpr std::size_t kCommandByteAt = 2;

/// Of a command packet, by its command byte.
[[nodiscard]] constexpr std::size_t packetLength(std::uint8_t commandByte) {
    return 4U + (commandByte >> 4U);
}

/// The command line: what the host's port has been given leaves back to back at the host's rate.
class HostLine {
public:
    /// More than any program writes at once; what finds no room is lost and counted.
    static constexpr std::size_t kCapacity = 65'536;

    void setBaud(std::uint32_t baud) { m_baud = baud; }
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }
    void send(ByteSpan bytes, TimePoint now, bool foreign = false);
    [[nodiscard]] std::optional<TimePoint> nextDue() const;
    /// When the last of it has left, or had.
    [[nodiscard]] TimePoint freeAt() const { return m_freeAt; }
    /// The first byte on the line; there must be one.
    LineByte take();
    /// The packet that begins with `header`, as far as it is on the line behind it.
    [[nodiscard]] PacketBytes packetBehind(std::uint8_t header) const;
    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    void forgetLost() { m_lost = 0; }

private:
    std::deque<LineByte> m_bytes;
    TimePoint m_freeAt;
    std::uint32_t m_baud = kPowerUpBaud;
    std::uint64_t m_lost = 0;
};

// A UART takes 16 samples a bit and starts over with every byte, so a mismatch of the rates adds up to the
// stop bit, whose middle is 9.5 bit times behind the edge of the start bit. There half a bit is left, of
// which the edge may take one sample, and the outer one of the three that decide a bit another: simulator.md.
inline constexpr double kStopBitMiddle = 9.5;
inline constexpr double kSampling = 2.0 / 16 / kStopBitMiddle;
/// On a clean line the greatest mismatch at which every byte is heard rightly: 3.9 %.
inline constexpr double kCleanLineMargin = 0.5 / kStopBitMiddle - kSampling;

/// Divisor of an SC for 230 400 Bd, its fastest.
inline constexpr std::uint8_t kScFastestBrd = 5;

/// The rate of a module's UART, bits per second, at a divisor (docs/family.md has that of an SC).
[[nodiscard]] double uartRate(const ModuleIdentity& module, std::uint8_t brd);

/// How likely a byte is heard wrong between a UART at `rate` and one at `baud`: 0 up to the margin,
/// 1 from kSampling beyond it, on a clean line 5.3 %. In between where the edge falls decides, and it falls
/// anywhere.
[[nodiscard]] double garbleProbability(double rate, std::uint32_t baud, double margin = kCleanLineMargin);

/// What is heard instead of `value`: any other byte.
[[nodiscard]] std::uint8_t garbled(std::uint8_t value, Random& random);

}  // namespace nmc::sim
