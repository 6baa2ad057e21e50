// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "base/bytes.h"
#include "base/time.h"
#include "bus/exchange.h"

namespace nmc::bus {

/// Detects answers that were not requested here: another host is on the line (faults.md F-45). Its commands
/// are not heard, because modules answer on a line of their own, but the answers to them are. Pure.
///
/// A run of bytes received while no answer was awaited is a stray frame if it has the length and sum of a
/// reply, and is not the end of what was sent. A late answer does not count: each missing answer accounts for
/// one frame, for up to kLatest. Three stray frames within ten seconds mean another host, if at least every
/// fourth run is one. Noise does not cause this: of its runs of four bytes and more, one in 256 has a right
/// sum, so three of twelve occur by chance once in 256^3 / 220, some 76 000 times; and most noise consists of
/// single bytes, which count against it.
///
/// Not detected: a host that sends a few queries per second while this one polls without a pause. Its answers
/// fall into exchanges and damage them, which shows as a doubtful link.
class StrayFrames {
public:
    /// Shorter frames have a right sum too often, for example from an adapter that returns the end of a
    /// command.
    static constexpr std::size_t kShortest = 4;
    static constexpr std::size_t kEnough = 3;
    static constexpr std::size_t kRunsPerFrame = 4;
    static constexpr Duration kWithin = std::chrono::seconds(10);
    /// Longer than any quarantine.
    static constexpr Duration kLatest = std::chrono::seconds(1);

    /// A command is sent.
    void onSent(const PacketBytes& command) { m_command = command; }
    /// An answer is missing, or was not awaited.
    void onMissed(TimePoint now);
    /// `bytes` arrived unexpectedly; `now`: arrival of the last one.
    void hear(ByteSpan bytes, TimePoint now, Duration byteTime);
    /// Another host is on the line. Returned once, until none of its answers has been heard for ten seconds.
    [[nodiscard]] bool takeForeign(TimePoint now);

private:
    struct Burst {
        TimePoint time;
        bool frame;
    };
    void endBurst();
    [[nodiscard]] bool isFrame() const;
    [[nodiscard]] bool paidFor();

    PacketBytes m_command;
    ByteBuffer<kMaxReply + 1> m_bytes;  ///< of the present run; if full, it is longer than any reply
    TimePoint m_last;
    TimePoint m_over;  ///< a byte after this time begins another run
    std::deque<TimePoint> m_missed;
    std::deque<Burst> m_bursts;
    bool m_reported = false;  ///< until none was heard for kWithin
};

}  // namespace nmc::bus
