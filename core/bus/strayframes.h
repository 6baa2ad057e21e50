// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "base/bytes.h"
#include "base/time.h"
#include "bus/exchange.h"

namespace nmc::bus {

/// Answers that nobody here has asked for: another host is on the line (faults.md F-45). Its commands are not
/// heard, since modules have a line of their own to answer on; what they answer is. Pure.
///
/// A run of bytes that came while no answer was waited for is a stray frame when it has the length and the
/// sum of a reply, and is not the end of what was sent. A late answer is no stray: each answer that stayed
/// away pays for one, for as long as kLatest. Three strays within ten seconds are somebody else, where at
/// least every fourth run is one. Noise does not bring that about: of its runs of four bytes and more one in
/// 256 has a right sum, so that three of twelve have by chance once in 256^3 / 220, some 76 000 times; and
/// it mostly comes as single bytes, which count against it.
///
/// What it cannot tell: a host that asks a few times a second, while this one polls without a pause. Its
/// answers fall into exchanges and damage them; that shows as a doubtful link.
class StrayFrames {
public:
    /// Shorter ones have a right sum too often: an adapter that returns the end of a command, say.
    static constexpr std::size_t kShortest = 4;
    static constexpr std::size_t kEnough = 3;
    static constexpr std::size_t kRunsPerFrame = 4;
    static constexpr Duration kWithin = std::chrono::seconds(10);
    /// Longer than any quarantine.
    static constexpr Duration kLatest = std::chrono::seconds(1);

    /// A command goes out.
    void onSent(const PacketBytes& command) { m_command = command; }
    /// An answer stayed away, or was not waited for.
    void onMissed(TimePoint now);
    /// `bytes` came that nobody waits for; `now`: the last of them.
    void hear(ByteSpan bytes, TimePoint now, Duration byteTime);
    /// Somebody else is on the line. Once, until none of his answers has been heard for ten seconds.
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
    ByteBuffer<kMaxReply + 1> m_bytes;  ///< of the present run; full: it is longer than any reply
    TimePoint m_last;
    TimePoint m_over;  ///< a byte after that begins another run
    std::deque<TimePoint> m_missed;
    std::deque<Burst> m_bursts;
    bool m_reported = false;  ///< until none was heard for kWithin
};

}  // namespace nmc::bus
