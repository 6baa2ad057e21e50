// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "bus/echo.h"
#include "bus/exchange.h"
#include "bus/strayframes.h"
#include "bus/types.h"

namespace nmc::bus {

/// Number of nulls that flush a command buffer left partly filled by a lost byte (DS-V 4.1).
inline constexpr std::size_t kNullCount = 16;
/// Status byte and sum.
inline constexpr std::size_t kMinReply = 2;
/// The longest pause within a reply; bytes that arrive later are something else.
inline constexpr Duration kLongestReplyGap = std::chrono::milliseconds(90);
/// Wait after the nulls before the input is discarded (DS-V 4.1).
inline constexpr Duration kAfterNulls = std::chrono::milliseconds(1);

/// The line as the host sees it: at most one exchange in flight, or a script of pauses and bytes without
/// replies. It calculates when the last byte has been sent, so that all times are measured on the line and
/// not from the call. Bytes that arrive outside an exchange are counted and dropped; directly after a reply,
/// they invalidate it. An adapter that returns what is sent is recognised, and then only what follows the
/// exact echo of a command counts as its answer (echo.h).
class Line {
public:
    struct Nulls {};
    /// Waits until another packet may follow the last byte sent; no wait if that is long past.
    struct Gap {};
    /// The same gap after a packet without a reply, made of nulls: an adapter that holds bytes back merges
    /// packets that were written separately, and the second would replace the first (DS-V 4.1).
    struct Spacer {};
    /// Waits from now, or from when the last byte has been sent if that is later.
    struct Pause {
        Duration time;
    };
    /// Waits like Pause, and additionally as long as the adapter may hold bytes back.
    struct Lag {
        Duration time{};
    };
    /// A packet whose reply, of `replyBytes`, is not read: it is dropped without counting as surplus.
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

    /// Switches both ends of the line to another rate: the port changes when its own buffer is empty, and a
    /// module that received part of a command discards it.
    [[nodiscard]] static Script toRate(std::uint32_t baud);

    Line(Duration latency, Duration margin) { m_timing.latency = latency, m_timing.margin = margin; }

    /// What may be sent; nulls always may. Everything passes through here, so this is where a read-only
    /// connection is enforced (EngineConfig::readOnly): any other packet is dropped, and its exchange ends in
    /// silence.
    enum class Permit : std::uint8_t {
        Everything,
        Questions,         ///< No Operation and Read Status, which change nothing
        QuestionsAndStops  ///< also Stop Motor, and `stops`
    };
    /// `stops`: packets that stop a module that has no Stop Motor, byte for byte. The codes of a PIC-I/O's
    /// commands are those of Set Gain and Load Trajectory on a PIC-SERVO.
    void permit(Permit what, std::vector<PacketBytes> stops = {}) {
        m_permit = what;
        m_permittedStops = std::move(stops);
    }

    /// begin() and run() require that the line is ready.
    void begin(const Request& request, TimePoint now);
    void run(Script script, TimePoint now);
    /// Discards the exchanges whose end has not been taken, or the rest of the script. What was sent is still
    /// being transmitted.
    void abandon(TimePoint now);

    // For another host whose bytes pass through here (lending.h); nothing may be in progress but its
    // exchanges.

    /// Its bytes, and its rate. Returns when the last of these bytes has been sent.
    TimePoint pass(ByteSpan bytes, TimePoint now);
    void passRate(std::uint32_t baud);
    /// What is awaited is over: the host has sent something else.
    void conclude(TimePoint now);
    /// `packet`, whose first byte is sent at `start`, begins an exchange like begin(). Call conclude() first.
    void overhear(const Request& request, const PacketBytes& packet, TimePoint start, TimePoint now);
    /// These bytes have passed, and are not answered.
    void overlook(ByteSpan bytes, TimePoint now);

    /// Returns false if nothing arrived other than what was sent.
    bool onBytes(ByteSpan bytes, TimePoint now);
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> deadline() const;
    /// Returns the exchanges that have ended, in the order in which they began.
    [[nodiscard]] std::optional<ReplyEnd> takeEnd();

    /// Nothing is in progress.
    [[nodiscard]] bool idle() const { return !m_pending && !m_done && m_script.empty() && !m_wait; }
    /// Something can begin: nothing is in progress, or only the surplus bytes of a pipelined reply are
    /// awaited.
    [[nodiscard]] bool ready() const;
    /// When a packet of that length, sent now, is latched by its module.
    [[nodiscard]] TimePoint latchTime(std::size_t txBytes, TimePoint now) const;
    [[nodiscard]] const LineTiming& timing() const { return m_timing; }
    /// Nominal rate of the port.
    [[nodiscard]] std::uint32_t baud() const { return m_baud; }
    /// An answer is awaited, or a script is running.
    [[nodiscard]] bool busy() const { return m_pending || m_wait || !m_script.empty(); }
    /// When the packets of the last script are latched by their modules, in order.
    [[nodiscard]] const std::vector<TimePoint>& scriptLatches() const { return m_scriptLatches; }
    /// Timeout of the last exchange begun.
    [[nodiscard]] Duration lastTimeout() const { return m_lastTimeout; }
    /// The longest pause within a reply seen so far, made by an adapter, a USB hub or a device server, for
    /// which later exchanges wait; 0: none. Detected when bytes after an exchange that ended too soon
    /// complete its reply.
    [[nodiscard]] Duration replyGap() const { return m_replyGap; }
    /// The adapter returns what is sent to it.
    [[nodiscard]] bool echoes() const { return m_echo.expected(); }
    /// Modules answer another host (strayframes.h). Returned only once in a while.
    [[nodiscard]] bool takeForeign(TimePoint now) { return m_strays.takeForeign(now); }

    [[nodiscard]] std::vector<Output> takeOutput() { return std::exchange(m_output, {}); }
    /// For the packet monitor: what was collected while recording was on.
    void setRecording(bool record);
    [[nodiscard]] std::vector<Unanswered> takeUnanswered() { return std::exchange(m_unanswered, {}); }
    [[nodiscard]] LinkStatistics& statistics() { return m_statistics; }
    [[nodiscard]] const LinkStatistics& statistics() const { return m_statistics; }

private:
    struct Pending {
        ReplyLayout layout;
        Framing framing = Framing::Settled;
        std::size_t txBytes = 0;
        TimePoint sent;
        TimePoint left;  ///< when the command's last byte has been sent
        TimePoint deadline;
        ReplyBytes received;
        ReplyBytes early;  ///< before the command was sent, or before its echo was complete: no answer
        [[nodiscard]] std::size_t wanted() const {
            return framing == Framing::Open ? kMaxReply : layout.length();
        }
    };
    /// A complete reply, after which surplus bytes may still arrive.
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
    [[nodiscard]] static bool isWhole(const Pending& pending, ByteSpan all);
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
    std::vector<PacketBytes> m_permittedStops;  ///< in addition to Stop Motor
    std::uint32_t m_baud = kPowerUpBaud;
    TimePoint m_free;  ///< when the last byte passed on has been sent
    std::optional<Done> m_done;
    std::optional<Pending> m_pending;
    TimePoint m_lastByte;        ///< of the reply being received
    std::optional<Torn> m_torn;  ///< until the next exchange begins
    Duration m_replyGap{};
    std::deque<ReplyEnd> m_ends;
    std::deque<Action> m_script;
    std::vector<TimePoint> m_scriptLatches;
    std::optional<TimePoint> m_wait;  ///< wait of the script
    std::size_t m_unread = 0;         ///< bytes that are expected but not wanted
    Echo m_echo;                      ///< of the last exchange begun
    StrayFrames m_strays;
    Duration m_lastTimeout{};
    std::vector<Output> m_output;
    bool m_recording = false;  ///< m_unanswered is filled only while set
    std::vector<Unanswered> m_unanswered;
    LinkStatistics m_statistics;
};

}  // namespace nmc::bus
