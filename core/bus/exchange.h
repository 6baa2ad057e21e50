// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/bytes.h"
#include "base/strong.h"
#include "base/time.h"
#include "bus/rejection.h"
#include "protocol/baud.h"
#include "protocol/frame.h"
#include "protocol/status.h"

/// A command and its reply: the request, the length of the reply, and how long to wait for it.
namespace nmc::bus {

/// Longest time from a command's last byte to its execution, and the shortest gap before the next command
/// when there is no answer (DS-V 4.1: 0.51 ms, one servo tick).
inline constexpr Duration kTurnaround = kServoTick;
/// Number of nulls that take at least this long on the line: sending them enforces the wait, even if an
/// adapter merges packets.
[[nodiscard]] constexpr std::size_t nullsForTurnaround(Duration byteTime) {
    return static_cast<std::size_t>(kTurnaround / byteTime) + 1;
}
/// Lowest adapter latency to allow for (link.md 2.1).
inline constexpr Duration kMinLatency = std::chrono::milliseconds(4);
/// Surplus bytes within this many character times after a reply still belong to it (link.md 2.2).
inline constexpr int kSurplusCharacters = 2;
/// Shortest quarantine (link.md 2.1).
inline constexpr Duration kMinQuarantine = std::chrono::milliseconds(100);

/// How much later than usual a process at either end of the line may act on a busy computer.
inline constexpr Duration kSchedulingDelay = std::chrono::milliseconds(50);
/// Number of rounds of queries for missing modules, each of them in doubt because answers were late or wrong,
/// after which a search gives up.
inline constexpr unsigned kMostRounds = 10;

/// Items of every reply, by Define Status: position, A/D value, velocity (PIC-STEP: timer count), auxiliary
/// status (PIC-STEP: inputs). Every second poll requests all items.
inline constexpr StatusItems kStandingItems{StatusItems::Position | StatusItems::Analog |
                                            StatusItems::Velocity | StatusItems::Aux};
/// Group address of every module that no host has put into another group (DS-V 4.1).
inline constexpr BusAddress kEverybody{0xFF};
/// The address of a module after power-up, until a host assigns one (DS-V 4.1).
inline constexpr BusAddress kUnaddressed{0x00};
/// Addresses from here on are those of groups (DS-V 4.1).
inline constexpr std::uint8_t kFirstGroup = 0x80;
/// Time for a command to show in a reply, after it was latched.
inline constexpr Duration kTakesEffect = 4 * kServoTick;

/// All items. On a PIC-I/O, the standing bits select its pins and its three A/D values; this adds its
/// counter, which is everything except what Synch Input has latched.
inline constexpr StatusItems kAllItems{StatusItems::All};

/// The standing items of a module: one that reports its position error does so in every reply.
[[nodiscard]] constexpr StatusItems standingItems(const ModuleIdentity& module) {
    return hasPathBuffer(module) ? kStandingItems | StatusItems(StatusItems::PositionError) : kStandingItems;
}
/// The items requested by every second poll.
[[nodiscard]] constexpr StatusItems fullItems(const ModuleIdentity& module) {
    return kAllItems | standingItems(module);
}
/// The items of every second poll of a module in focus: its position, and its position error if it reports
/// one. Alternating with the standing items, they make two lengths (link.md 2.2).
[[nodiscard]] constexpr StatusItems briefItems(const ModuleIdentity& module) {
    const StatusItems position{StatusItems::Position};
    return hasPathBuffer(module) ? position | StatusItems(StatusItems::PositionError) : position;
}
inline constexpr StatusItems kIdentityItems{StatusItems::Identity};

/// The layout of a reply, which is determined by the request and the module's defined items: the reply does
/// not contain its length.
struct ReplyLayout {
    ModuleIdentity module;
    StatusItems items;
    [[nodiscard]] std::size_t length() const { return replyLength(module, items); }
    bool operator==(const ReplyLayout&) const = default;
};

/// Number of bytes beyond a reply that are still examined.
inline constexpr std::size_t kMaxSurplus = 8;
/// A reply as received, including the bytes that followed it.
using ReplyBytes = ByteBuffer<kMaxReply + kMaxSurplus>;

/// How a reply is awaited.
enum class Framing : std::uint8_t {
    Settled,    ///< the length is known; nothing else begins until no surplus byte can arrive any more
    Pipelined,  ///< the length is known; the next command may be sent at once, and surplus bytes count
                ///< against the previous reply (a module's answer cannot begin before its command has been
                ///< sent)
    Open,       ///< the length is unknown: the reply ends with silence
};

struct Request {
    BusAddress address;
    Payload payload;
    ReplyLayout reply;
    Framing framing = Framing::Settled;
    Duration patience{};  ///< how much longer than usual to wait for the reply
};

/// The result of a request.
enum class ReplyResult : std::uint8_t {
    Accepted,
    Refused,       ///< the communication-error bit: certainly not carried out
    Unresponsive,  ///< not one byte
    Partial,       ///< fewer bytes than in the layout
    BadChecksum,   ///< enough bytes, but the sum is wrong
    Rejected,      ///< the sum is right, but the reply is implausible (link.md 2.4): see `rejection`
    // Only in an ExchangeRecord:
    Abandoned,  ///< overtaken by a stop
    NotAsked,   ///< no reply was expected; `reply` holds any bytes that arrived
};

/// All bytes are 00 or all FF: the line is held at one level. The sum of such a reply is right.
[[nodiscard]] constexpr bool uniform(ByteSpan bytes) {
    if (bytes.empty() || (bytes.front() != 0x00 && bytes.front() != 0xFF))
        return false;
    return std::ranges::all_of(bytes, [&](std::uint8_t b) { return b == bytes.front(); });
}

/// It is unknown whether the command was carried out.
[[nodiscard]] constexpr bool unanswered(ReplyResult result) {
    return result != ReplyResult::Accepted && result != ReplyResult::Refused;
}

struct ReplyEnd {
    ReplyResult result = ReplyResult::Unresponsive;
    std::optional<Rejection> rejection;
    StatusReport report;  ///< for Accepted and Refused; for an SC in the terms of DS-V 5.3 (toAuxByte)
    TimePoint latched;    ///< when the module latched it: end of the command on the line plus half a tick
    TimePoint latchedBy;  ///< upper bound, however late this computer was
    Duration late{};      ///< as in Sample
    ReplyBytes bytes;
    TimePoint sent;
    TimePoint arrived;    ///< when its last byte arrived, or it was given up
    Duration wireTime{};  ///< duration of the exchange on an undisturbed line
};

/// The arithmetic of link.md 2.1.
struct LineTiming {
    Duration byteTime = byteTimeAtBaud(kPowerUpBaud);
    Duration latency = kMinLatency;
    Duration margin{};

    [[nodiscard]] Duration bytes(std::size_t count) const {
        return byteTime * static_cast<Duration::rep>(count);
    }
    /// The shortest time in which a chip may send this many bytes: its rate is up to 2 % off (protocol.md 1);
    /// the rate it starts with is 1.7 % above 19 200 Bd.
    [[nodiscard]] Duration shortest(std::size_t count) const { return bytes(count) * 98 / 100; }
    [[nodiscard]] Duration adapter() const { return std::max(latency, kMinLatency); }
    /// The known part of the adapter latency: the minimum to allow for is only an allowance, and explains
    /// nothing.
    [[nodiscard]] Duration knownAdapter() const { return latency > kMinLatency ? latency : Duration{}; }
    /// From the first byte of the command to giving up.
    [[nodiscard]] Duration timeout(std::size_t txBytes, std::size_t rxBytes) const {
        return bytes(txBytes) + kTurnaround + bytes(rxBytes) + adapter() + margin;
    }
    /// Duration of an exchange on an undisturbed line, including half a tick of waiting on average.
    [[nodiscard]] Duration wireTime(std::size_t txBytes, std::size_t rxBytes) const {
        return bytes(txBytes + rxBytes) + kServoTick / 2;
    }
    [[nodiscard]] static Duration quarantine(Duration timeout) {
        return std::max<Duration>(5 * timeout, kMinQuarantine);
    }
};

}  // namespace nmc::bus
