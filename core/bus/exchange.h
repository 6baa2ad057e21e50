// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/bytes.h"
#include "base/strong.h"
#include "base/time.h"
#include "protocol/baud.h"
#include "protocol/frame.h"
#include "protocol/status.h"

/// One command and its one answer: what is asked, how long the answer is, how long to wait for it.
namespace nmc::bus {

/// Longest time from a command's last byte to its execution, and the shortest gap before the next one when
/// nobody answers (DS-V 4.1: 0.51 ms, one servo tick).
inline constexpr Duration kTurnaround = kServoTick;
/// Nulls that take as long on the wire: whoever writes them waits, whatever an adapter puts together.
[[nodiscard]] constexpr std::size_t nullsForTurnaround(Duration byteTime) {
    return static_cast<std::size_t>(kTurnaround / byteTime) + 1;
}
/// Shortest adapter latency to count with (link.md 2.1).
inline constexpr Duration kMinLatency = std::chrono::milliseconds(4);
/// Surplus bytes this many character times after a reply still belong to it (link.md 2.2).
inline constexpr int kSurplusCharacters = 2;
/// Shortest quarantine (link.md 2.1).
inline constexpr Duration kMinQuarantine = std::chrono::milliseconds(100);

/// Items of every reply, by Define Status: position, A/D value, velocity (PIC-STEP: timer count), auxiliary
/// status (PIC-STEP: inputs). Every second poll asks for all there are.
inline constexpr StatusItems kStandingItems{StatusItems::Position | StatusItems::Analog |
                                            StatusItems::Velocity | StatusItems::Aux};
/// Every module that no host has put into another group (DS-V 4.1).
inline constexpr BusAddress kEverybody{0xFF};
/// The address of a module after power-up, until a host gives it one (DS-V 4.1).
inline constexpr BusAddress kUnaddressed{0x00};
/// Addresses from here on are those of groups (DS-V 4.1).
inline constexpr std::uint8_t kFirstGroup = 0x80;
/// Time for a command to show in a reply, after it was latched.
inline constexpr Duration kTakesEffect = 4 * kServoTick;

/// On a PIC-I/O the same bits are its pins and its three A/D values; all there are, but for what Synch Input
/// has latched, adds its counter.
inline constexpr StatusItems kAllItems{StatusItems::All};

/// The standing items of a module: one that reports its position error does so in every reply.
[[nodiscard]] constexpr StatusItems standingItems(const ModuleIdentity& module) {
    const unsigned more = hasPathBuffer(module) ? StatusItems::PositionError : 0U;
    return StatusItems(static_cast<std::uint8_t>(kStandingItems.mask() | more));
}
/// What every second poll asks for.
[[nodiscard]] constexpr StatusItems fullItems(const ModuleIdentity& module) {
    return StatusItems(static_cast<std::uint8_t>(kAllItems.mask() | standingItems(module).mask()));
}
/// Every second poll of a module in focus; with the standing items it makes two lengths (link.md 2.2).
inline constexpr StatusItems kBriefItems{StatusItems::Position};
inline constexpr StatusItems kIdentityItems{StatusItems::Identity};

/// The layout of a reply, which the request and the module's defined items determine: there is no length on
/// the wire.
struct ReplyLayout {
    ModuleIdentity module;
    StatusItems items;
    [[nodiscard]] std::size_t length() const { return replyLength(module, items); }
    bool operator==(const ReplyLayout&) const = default;
};

/// Bytes beyond a reply that are still looked at.
inline constexpr std::size_t kMaxSurplus = 8;
/// A reply as it came in, with what came behind it.
using ReplyBytes = ByteBuffer<kMaxReply + kMaxSurplus>;

/// How a reply is awaited.
enum class Framing : std::uint8_t {
    Settled,    ///< the length is known; nothing else begins until no surplus byte can come any more
    Pipelined,  ///< the length is known; the next command may leave at once, surplus bytes tell on the reply
                ///< before it (a module's answer cannot begin before its command has left)
    Open,       ///< the length is not known: it ends with silence
};

struct Request {
    BusAddress address;
    Payload payload;
    ReplyLayout reply;
    Framing framing = Framing::Settled;
};

/// What came of a request.
enum class ReplyResult : std::uint8_t {
    Accepted,
    Refused,       ///< the communication-error bit: certainly not carried out
    Unresponsive,  ///< not one byte
    Partial,       ///< fewer bytes than the layout has
    BadChecksum,   ///< as many, but the sum is wrong
    Surplus,       ///< more: the reply of something else, or noise
    Rejected,      ///< the sum is right, but it cannot be true (link.md 2.4)
    Echo,  ///< an adapter that echoes did not return the command as it was sent, or one does since now
};

/// All bytes 00 or all FF: a line that is held at one level. The sum of such a reply is right.
[[nodiscard]] constexpr bool uniform(ByteSpan bytes) {
    if (bytes.empty() || (bytes.front() != 0x00 && bytes.front() != 0xFF))
        return false;
    return std::all_of(bytes.begin(), bytes.end(), [&](std::uint8_t b) { return b == bytes.front(); });
}

/// Nothing is known about whether the command was carried out.
[[nodiscard]] constexpr bool unanswered(ReplyResult result) {
    return result != ReplyResult::Accepted && result != ReplyResult::Refused;
}

struct ReplyEnd {
    ReplyResult result = ReplyResult::Unresponsive;
    StatusReport report;  ///< of Accepted and Refused; that of an SC in the terms of DS-V 5.3 (toAuxByte)
    TimePoint latched;    ///< when the module latched it: command's end on the wire plus half a tick
    TimePoint latchedBy;  ///< not later than this, however late this machine was
    Duration late{};      ///< as in Sample
    ReplyBytes bytes;
    TimePoint sent;
    TimePoint arrived;    ///< the last byte of it, or when it was given up
    Duration wireTime{};  ///< what the exchange takes on a perfect line
};

/// The arithmetic of link.md 2.1.
struct LineTiming {
    Duration byteTime = byteTimeAtBaud(kPowerUpBaud);
    Duration latency = kMinLatency;
    Duration margin{};

    [[nodiscard]] Duration bytes(std::size_t count) const {
        return byteTime * static_cast<Duration::rep>(count);
    }
    /// What a chip may send these in: its rate is up to 2 % off (protocol.md 1); the one it starts with is
    /// 1.7 % above 19 200 Bd.
    [[nodiscard]] Duration shortest(std::size_t count) const { return bytes(count) * 98 / 100; }
    [[nodiscard]] Duration adapter() const { return std::max(latency, kMinLatency); }
    /// Of it, what is known of the adapter: the shortest one to count with is an allowance, and explains
    /// nothing.
    [[nodiscard]] Duration knownAdapter() const { return latency > kMinLatency ? latency : Duration{}; }
    /// From the first byte of the command to giving up.
    [[nodiscard]] Duration timeout(std::size_t txBytes, std::size_t rxBytes) const {
        return bytes(txBytes) + kTurnaround + bytes(rxBytes) + adapter() + margin;
    }
    /// What an exchange takes on a perfect line: half a tick of waiting on average.
    [[nodiscard]] Duration wireTime(std::size_t txBytes, std::size_t rxBytes) const {
        return bytes(txBytes + rxBytes) + kServoTick / 2;
    }
    [[nodiscard]] static Duration quarantine(Duration timeout) {
        return std::max<Duration>(5 * timeout, kMinQuarantine);
    }
};

}  // namespace nmc::bus
