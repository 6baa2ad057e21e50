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
    TimePoint due;  ///< end of its stop bit, when the modules receive it
    std::uint32_t baud = kPowerUpBaud;
    std::uint8_t value = 0;
    bool foreign = false;  ///< sent by another host
};

/// Position of the command byte in a command packet.
inline constexpr std::size_t kCommandByteAt = 2;

/// Length of a command packet, computed from its command byte.
[[nodiscard]] constexpr std::size_t packetLength(std::uint8_t commandByte) {
    return 4U + (commandByte >> 4U);
}

/// The command line: bytes given to the host's port are sent back to back at the host's rate.
class HostLine {
public:
    /// More than any program writes at once; bytes that do not fit are lost and counted.
    static constexpr std::size_t kCapacity = 65'536;

    void setBaud(std::uint32_t baud) { m_baud = baud; }
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }
    void send(ByteSpan bytes, TimePoint now, bool foreign = false);
    [[nodiscard]] std::optional<TimePoint> nextDue() const;
    /// The time at which the last byte leaves the line, or left it.
    [[nodiscard]] TimePoint freeAt() const { return m_freeAt; }
    /// Removes and returns the first byte on the line; there must be one.
    LineByte take();
    /// Returns the packet that begins with `header`, as far as its bytes are already on the line.
    [[nodiscard]] PacketBytes packetBehind(std::uint8_t header) const;
    [[nodiscard]] std::uint64_t lost() const { return m_lost; }
    void forgetLost() { m_lost = 0; }

private:
    std::deque<LineByte> m_bytes;
    TimePoint m_freeAt;
    std::uint32_t m_baud = kPowerUpBaud;
    std::uint64_t m_lost = 0;
};

// A UART takes 16 samples per bit and resynchronizes with every byte, so a mismatch of the rates adds up
// until the stop bit, whose middle is 9.5 bit times after the edge of the start bit. The tolerance there is
// half a bit. The position of the edge may take up one sample of it, and the outer one of the three samples
// that decide a bit another: simulator.md.
inline constexpr double kStopBitMiddle = 9.5;
inline constexpr double kSampling = 2.0 / 16 / kStopBitMiddle;
/// The greatest mismatch at which every byte is received correctly on a clean line: 3.9 %.
inline constexpr double kCleanLineMargin = 0.5 / kStopBitMiddle - kSampling;

/// An SC's divisor for 230 400 Bd, its fastest rate.
inline constexpr std::uint8_t kScFastestBrd = 5;

/// The rate of a module's UART in bits per second at a divisor (for an SC, see docs/family.md).
[[nodiscard]] double uartRate(const ModuleIdentity& module, std::uint8_t brd);

/// The probability that a byte is received wrong between a UART at `rate` and one at `baud`: 0 up to the
/// margin, and 1 from kSampling beyond it, which is 5.3 % on a clean line. In between it depends on where the
/// edge falls between two samples, which is random.
[[nodiscard]] double garbleProbability(double rate, std::uint32_t baud, double margin = kCleanLineMargin);

/// The value received instead of `value`: any other byte.
[[nodiscard]] std::uint8_t garbled(std::uint8_t value, Random& random);

}  // namespace nmc::sim
