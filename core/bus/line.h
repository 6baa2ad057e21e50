// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "base/bytes.h"
#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// Host bytes that flush a command buffer which a lost byte left half full (DS-V 4.1).
inline constexpr std::size_t kNullCount = 16;
/// Wait after the nulls before the input is discarded (DS-V 4.1).
inline constexpr Duration kAfterNulls = std::chrono::milliseconds(1);

/// The wire as the host sees it: at most one exchange in flight, or a script of pauses and bytes that nobody
/// answers. Knows when the last byte will have left, so that every time is reckoned from the wire, not from
/// the call. Whatever arrives outside an exchange is counted and dropped.
class Line {
public:
    struct Nulls {};
    /// Until another packet may follow the last byte that was sent; nothing when that is long past.
    struct Gap {};
    /// From now, or from when the last byte has left if that is later.
    struct Pause {
        Duration time;
    };
    /// A packet whose reply, of `replyBytes`, is not read: it is dropped without being counted as surplus.
    struct Packet {
        PacketBytes bytes;
        std::size_t replyBytes = 0;
    };
    using Action = std::variant<SetHostBaud, DiscardInput, Nulls, Gap, Pause, Packet>;
    using Script = std::vector<Action>;

    Line(Duration latency, Duration margin) { m_timing.latency = latency, m_timing.margin = margin; }

    /// The line must be idle for these two.
    void begin(const Request& request, TimePoint now);
    void run(Script script, TimePoint now);
    /// Forgets the exchange in flight, or the rest of the script. What was sent is still leaving.
    void abandon();

    [[nodiscard]] std::optional<ReplyEnd> onBytes(ByteSpan bytes, TimePoint now);
    [[nodiscard]] std::optional<ReplyEnd> onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> deadline() const { return m_deadline; }

    [[nodiscard]] bool idle() const { return !m_pending && m_script.empty() && !m_deadline; }
    /// When a packet of that length, sent now, is latched by its module.
    [[nodiscard]] TimePoint latchTime(std::size_t txBytes, TimePoint now) const;
    [[nodiscard]] const LineTiming& timing() const { return m_timing; }
    /// When the packets of the last script are latched by their modules, in their order.
    [[nodiscard]] const std::vector<TimePoint>& scriptLatches() const { return m_scriptLatches; }
    /// Of the exchange that began last.
    [[nodiscard]] Duration lastTimeout() const { return m_lastTimeout; }

    [[nodiscard]] std::vector<Output> takeOutput();
    [[nodiscard]] LinkStatistics& statistics() { return m_statistics; }
    [[nodiscard]] const LinkStatistics& statistics() const { return m_statistics; }

private:
    struct Pending {
        ReplyLayout layout;
        std::size_t txBytes = 0;
        TimePoint sent;
        TimePoint latched;
        ByteBuffer<kMaxReply> received;
    };

    void send(ByteSpan bytes, TimePoint now);
    void advanceScript(TimePoint now);
    void perform(const Action& action, TimePoint now);
    void waitUntil(TimePoint until, TimePoint now);
    [[nodiscard]] ReplyEnd finish(ReplyResult result, StatusReport report = {});
    [[nodiscard]] ReplyEnd complete(TimePoint now);
    void drop(std::size_t count);

    LineTiming m_timing;
    TimePoint m_free;  ///< when the last byte handed over has left
    std::optional<Pending> m_pending;
    std::deque<Action> m_script;
    std::vector<TimePoint> m_scriptLatches;
    std::optional<TimePoint> m_deadline;
    std::size_t m_unread = 0;  ///< reply bytes that are expected but not wanted
    Duration m_lastTimeout{};
    std::vector<Output> m_output;
    LinkStatistics m_statistics;
};

}  // namespace nmc::bus
