// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "bus/echo.h"
#include "bus/exchange.h"
#include "bus/strayframes.h"
#include "bus/types.h"

namespace nmc::bus {

/// Host bytes that flush a command buffer which a lost byte left half full (DS-V 4.1).
inline constexpr std::size_t kNullCount = 16;
/// Status byte and sum.
inline constexpr std::size_t kMinReply = 2;
/// A longer pause within a reply is none: what comes so late is something else.
inline constexpr Duration kLongestReplyGap = std::chrono::milliseconds(90);
/// Wait after the nulls before the input is discarded (DS-V 4.1).
inline constexpr Duration kAfterNulls = std::chrono::milliseconds(1);

/// The wire as the host sees it: at most one exchange in flight, or a script of pauses and bytes that nobody
/// answers. Knows when the last byte will have left, so that every time is reckoned from the wire, not from
/// the call. Whatever arrives outside an exchange is counted and dropped; right behind a reply it invalidates
/// that reply. An adapter that returns what is sent is recognised, and then nothing is an answer that does
/// not come behind the exact echo of its command (echo.h).
class Line {
public:
    struct Nulls {};
    /// Until another packet may follow the last byte that was sent; nothing when that is long past.
    struct Gap {};
    /// The same behind a packet that nobody answers, made of nulls: an adapter that holds bytes back puts
    /// packets together that were written apart, and the second would take the place of the first (DS-V 4.1).
    struct Spacer {};
    /// From now, or from when the last byte has left if that is later.
    struct Pause {
        Duration time;
    };
    /// The same, and as long as the adapter may hold bytes back.
    struct Lag {
        Duration time{};
    };
    /// A packet whose reply, of `replyBytes`, is not read: it is dropped without being counted as surplus.
    struct Packet {
        PacketBytes bytes;
        std::size_t replyBytes = 0;
    };
    using Action = std::variant<SetHostBaud, DiscardInput, Nulls, Gap, Spacer, Pause, Lag, Packet>;
    using Script = std::vector<Action>;
    /// What a script sent, and when.
    struct Unanswered {
        TimePoint sent;
        std::vector<std::uint8_t> bytes;
    };

    /// Both ends of the line go on at another rate: the port changes when its own buffer has run empty, and a
    /// module that heard half of something forgets it.
    [[nodiscard]] static Script toRate(std::uint32_t baud);

    Line(Duration latency, Duration margin) { m_timing.latency = latency, m_timing.margin = margin; }

    /// What may leave, nulls always. Everything passes here, so this is where a read-only connection keeps
    /// its word (EngineConfig::readOnly): any other packet is dropped, and its exchange ends in silence.
    enum class Permit : std::uint8_t {
        Everything,
        Questions,         ///< No Operation and Read Status, which change nothing
        QuestionsAndStops  ///< and Stop Motor, and `stops`
    };
    /// `stops`: packets that stop a module which has no Stop Motor, byte for byte. The codes of a PIC-I/O's
    /// are those of Set Gain and Load Trajectory on a PIC-SERVO.
    void permit(Permit what, std::vector<PacketBytes> stops = {}) {
        m_permit = what;
        m_permittedStops = std::move(stops);
    }

    /// The line must be ready for these two.
    void begin(const Request& request, TimePoint now);
    void run(Script script, TimePoint now);
    /// Forgets the exchanges whose end has not been taken, or the rest of the script. What was sent is still
    /// leaving.
    void abandon(TimePoint now);

    /// False when nothing else came than what was sent.
    bool onBytes(ByteSpan bytes, TimePoint now);
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> deadline() const;
    /// The exchanges that have ended, in the order in which they began.
    [[nodiscard]] std::optional<ReplyEnd> takeEnd();

    /// Nothing is going on.
    [[nodiscard]] bool idle() const { return !m_pending && !m_done && m_script.empty() && !m_wait; }
    /// Something can begin: nothing is going on, or only the surplus bytes of a pipelined reply are waited
    /// for.
    [[nodiscard]] bool ready() const;
    /// When a packet of that length, sent now, is latched by its module.
    [[nodiscard]] TimePoint latchTime(std::size_t txBytes, TimePoint now) const;
    [[nodiscard]] const LineTiming& timing() const { return m_timing; }
    /// Nominal rate of the port.
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }
    /// An answer is waited for, or a script runs.
    [[nodiscard]] bool busy() const { return m_pending || m_wait || !m_script.empty(); }
    /// When the packets of the last script are latched by their modules, in their order.
    [[nodiscard]] const std::vector<TimePoint>& scriptLatches() const { return m_scriptLatches; }
    /// Of the exchange that began last.
    [[nodiscard]] Duration lastTimeout() const { return m_lastTimeout; }
    /// The longest pause within a reply so far that an adapter, a USB hub or a device server was seen to
    /// make, and that later exchanges wait for; 0: none. Learned where what comes behind an exchange that
    /// ended too soon makes its reply whole.
    [[nodiscard]] Duration replyGap() const { return m_replyGap; }
    /// The adapter returns what is sent to it.
    [[nodiscard]] bool echoes() const { return m_echo.expected(); }
    /// Modules answer somebody else (strayframes.h). Once in a while.
    [[nodiscard]] bool takeForeign(TimePoint now) { return m_strays.takeForeign(now); }

    [[nodiscard]] std::vector<Output> takeOutput();
    /// For the packet monitor: collected while `record` was on.
    void setRecording(bool record);
    [[nodiscard]] std::vector<Unanswered> takeUnanswered();
    [[nodiscard]] LinkStatistics& statistics() { return m_statistics; }
    [[nodiscard]] const LinkStatistics& statistics() const { return m_statistics; }

private:
    struct Pending {
        ReplyLayout layout;
        Framing framing = Framing::Settled;
        std::size_t txBytes = 0;
        TimePoint sent;
        TimePoint left;  ///< when the command's last byte has left
        TimePoint deadline;
        ReplyBytes received;
        ReplyBytes early;  ///< before the command had left, or before its echo was whole: no answer
        [[nodiscard]] std::size_t wanted() const {
            return framing == Framing::Open ? kMaxReply : layout.length();
        }
    };
    /// A whole reply, behind which surplus bytes may still come.
    struct Done {
        ReplyEnd end;
        Framing framing = Framing::Settled;
        TimePoint until;
    };

    /// A reply that ended too soon.
    struct Torn {
        Pending pending;
        TimePoint last;  ///< its last byte so far
    };

    void join(ByteSpan bytes, TimePoint now);
    [[nodiscard]] static bool isWhole(const Pending& pending);
    [[nodiscard]] bool mayLeave(ByteSpan bytes) const;
    void send(ByteSpan bytes, TimePoint now);
    void advanceScript(TimePoint now);
    void perform(const Action& action, TimePoint now);
    void waitUntil(TimePoint until, TimePoint now);
    void hear(ByteSpan bytes, TimePoint now);
    void passBy(std::uint8_t byte, TimePoint now);
    void endWithoutEcho(const Pending& pending, TimePoint now);
    void take(ByteSpan bytes, TimePoint now);
    void complete(TimePoint now);
    void expire(TimePoint now);
    void invalidate(ByteSpan surplus);
    void settle();
    [[nodiscard]] ReplyEnd endOf(const Pending& pending, ReplyResult result, TimePoint now) const;
    void drop(ByteSpan bytes, TimePoint now);

    LineTiming m_timing;
    Permit m_permit = Permit::Everything;
    std::vector<PacketBytes> m_permittedStops;  ///< beside Stop Motor
    std::uint32_t m_baud = kPowerUpBaud;
    TimePoint m_free;  ///< when the last byte handed over has left
    std::optional<Done> m_done;
    std::optional<Pending> m_pending;
    TimePoint m_lastByte;        ///< of the reply that is coming in
    std::optional<Torn> m_torn;  ///< until the next exchange begins
    Duration m_replyGap{};
    std::deque<ReplyEnd> m_ends;
    std::deque<Action> m_script;
    std::vector<TimePoint> m_scriptLatches;
    std::optional<TimePoint> m_wait;  ///< of the script
    std::size_t m_unread = 0;         ///< bytes that are expected but not wanted
    Echo m_echo;                      ///< of the exchange that began last
    StrayFrames m_strays;
    Duration m_lastTimeout{};
    std::vector<Output> m_output;
    bool m_recording = false;  ///< only then m_unanswered grows
    std::vector<Unanswered> m_unanswered;
    LinkStatistics m_statistics;
};

}  // namespace nmc::bus
