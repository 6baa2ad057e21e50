// SPDX-License-Identifier: MIT
#include "bus/line.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "base/overloaded.h"

namespace nmc::bus {

Line::Script Line::toRate(std::uint32_t baud) {
    return {Gap{}, Lag{}, DiscardInput{}, SetHostBaud{baud}, Nulls{}, Lag{kAfterNulls}, DiscardInput{}};
}

void Line::begin(const Request& request, TimePoint now) {
    const PacketBytes packet = toPacket({request.address, request.payload});
    overhear(request, packet, std::max(now, m_free), now);
    send(packet, now);
}

void Line::overhear(const Request& request, const PacketBytes& packet, TimePoint start, TimePoint now) {
    assert(ready());
    m_torn.reset();
    m_echo.begin(packet);
    m_strays.onSent(packet);
    if (!m_echo.expected())
        m_unread = 0;
    Pending pending{request.reply, request.framing, packet.size(), now, {}, {}, {}, {}};
    // For an open reply, the first bytes must arrive in time; it then lasts as long as bytes arrive.
    const std::size_t first = request.framing == Framing::Open ? kMinReply : pending.wanted();
    m_lastTimeout = m_timing.timeout(packet.size(), first) + request.patience;
    pending.left = start + m_timing.bytes(packet.size());
    pending.deadline = start + m_lastTimeout;
    m_pending = pending;
    ++m_statistics.exchanges;
}

TimePoint Line::pass(ByteSpan bytes, TimePoint now) {
    m_free = std::max(now, m_free) + m_timing.bytes(bytes.size());
    m_output.emplace_back(Send{{bytes.begin(), bytes.end()}});
    return m_free;
}

void Line::passRate(std::uint32_t baud) {
    perform(SetHostBaud{baud}, {});
}

void Line::conclude(TimePoint now) {
    settle();
    if (m_pending)
        expire(now);
}

void Line::overlook(ByteSpan bytes, TimePoint now) {
    if (m_recording && !bytes.empty())
        m_unanswered.push_back({now, {bytes.begin(), bytes.end()}});
}

void Line::run(Script script, TimePoint now) {
    assert(ready());
    settle();
    m_scriptLatches.clear();
    m_script.assign(script.begin(), script.end());
    advanceScript(now);
}

void Line::abandon(TimePoint now) {
    // The rest of the reply may still arrive, and does not count as surplus.
    if (m_pending && m_pending->framing != Framing::Open)
        m_unread += m_pending->wanted() - m_pending->received.size();
    if (m_pending) {
        m_unread += m_echo.missing();
        m_strays.onMissed(now);
    }
    m_pending.reset();
    m_done.reset();
    m_ends.clear();
    m_script.clear();
    m_wait.reset();
}

bool Line::ready() const {
    if (busy())
        return false;
    return !m_done || m_done->framing == Framing::Pipelined;
}

bool Line::onBytes(ByteSpan bytes, TimePoint now) {
    if (!m_echo.expected()) {
        for (const std::uint8_t byte : bytes)
            m_echo.take(byte);
        hear(bytes, now);
        return true;
    }
    if (!m_pending) {
        const bool others = bytes.size() > m_unread;
        hear(bytes, now);
        return others;
    }
    for (; !bytes.empty() && !m_echo.whole(); bytes = bytes.subspan(1))
        passBy(bytes.front(), now);
    if (!bytes.empty())
        hear(bytes, now);
    return !bytes.empty();
}

/// Handles a byte that arrives before the echo of the command is complete: part of it, or an earlier byte.
void Line::passBy(std::uint8_t byte, TimePoint now) {
    if (!m_echo.take(byte)) {
        if (m_done && now < m_pending->left)
            return invalidate({&byte, 1});
        settle();
        drop({&byte, 1}, now);
    }
    m_pending->early.appendWhatFits({&byte, 1});
}

void Line::hear(ByteSpan bytes, TimePoint now) {
    if (!m_pending) {
        if (m_done)
            return invalidate(bytes);
        return drop(bytes, now);
    }
    // No module answers before it has received the whole command.
    if (m_pending->received.empty() && now < m_pending->left) {
        if (m_done)
            return invalidate(bytes);
        m_pending->early.appendWhatFits(bytes);
        return drop(bytes, now);
    }
    settle();
    take(bytes, now);
}

void Line::onDeadline(TimePoint now) {
    if (m_pending && now >= m_pending->deadline) {
        settle();
        return expire(now);
    }
    if (m_done && now >= m_done->until)
        settle();
    if (m_wait && now >= *m_wait) {
        m_wait.reset();
        advanceScript(now);
    }
}

std::optional<TimePoint> Line::deadline() const {
    if (m_pending)
        return m_pending->deadline;  // by then, the previous reply has long settled
    if (m_done)
        return m_done->until;
    return m_wait;
}

std::optional<ReplyEnd> Line::takeEnd() {
    if (m_ends.empty())
        return std::nullopt;
    ReplyEnd end = m_ends.front();
    m_ends.pop_front();
    return end;
}

TimePoint Line::latchTime(std::size_t txBytes, TimePoint now) const {
    return std::max(now, m_free) + m_timing.bytes(txBytes) + kServoTick / 2;
}

void Line::setRecording(bool record) {
    m_recording = record;
    m_unanswered.clear();
}

bool Line::mayLeave(ByteSpan bytes) const {
    const auto frame = parsePacket(bytes);
    if (m_permit == Permit::Everything || !frame)
        return true;  // anything that is not a packet is nulls
    const CommandCode code = frame->payload.code;
    if (code == CommandCode::Nop || code == CommandCode::ReadStatus)
        return true;
    const auto same = [&](const PacketBytes& stop) { return std::ranges::equal(stop, bytes); };
    return m_permit == Permit::QuestionsAndStops &&
           (code == CommandCode::StopMotor || std::ranges::any_of(m_permittedStops, same));
}

void Line::send(ByteSpan bytes, TimePoint now) {
    if (!mayLeave(bytes))
        return;
    m_free = std::max(now, m_free) + m_timing.bytes(bytes.size());
    m_output.emplace_back(Send{{bytes.begin(), bytes.end()}});
    if (!m_pending && m_echo.expected())
        m_unread += bytes.size();
    if (m_recording && !m_pending)
        m_unanswered.push_back({now, {bytes.begin(), bytes.end()}});
}

void Line::advanceScript(TimePoint now) {
    while (!m_script.empty() && !m_wait) {
        const Action action = m_script.front();
        m_script.pop_front();
        perform(action, now);
    }
}

void Line::perform(const Action& action, TimePoint now) {
    static constexpr std::array<std::uint8_t, kNullCount> kNulls{};
    std::visit(
        Overloaded{
            [&](const SetHostBaud& rate) {
                m_baud = rate.baud;
                m_timing.byteTime = byteTimeAtBaud(rate.baud);
                m_output.emplace_back(rate);
            },
            [&](const DiscardInput& discard) {
                m_unread = 0;
                m_output.emplace_back(discard);
            },
            [&](const Nulls&) { send(kNulls, now); },
            [&](const Spacer&) {
                send(std::vector<std::uint8_t>(nullsForTurnaround(m_timing.byteTime)), now);
                waitUntil(m_free, now);  // otherwise a stop would be queued behind many bytes
            },
            [&](const Gap&) { waitUntil(m_free + kTurnaround, now); },
            [&](const Pause& pause) { waitUntil(std::max(now, m_free) + pause.time, now); },
            [&](const Lag& lag) { waitUntil(std::max(now, m_free) + lag.time + m_timing.adapter(), now); },
            [&](const Packet& packet) {
                m_unread += packet.replyBytes;
                if (packet.replyBytes > 0)
                    m_strays.onMissed(now);
                m_scriptLatches.push_back(latchTime(packet.bytes.size(), now));
                send(packet.bytes, now);
            },
        },
        action);
}

void Line::waitUntil(TimePoint until, TimePoint now) {
    if (until > now)
        m_wait = until;
}

void Line::take(ByteSpan bytes, TimePoint now) {
    Pending& pending = *m_pending;
    pending.received.appendWhatFits(bytes);
    m_lastByte = now;
    const std::size_t wanted = pending.wanted();
    if (pending.framing == Framing::Open && pending.received.size() <= wanted) {
        // The reply is complete when nothing more arrives for a while.
        pending.deadline = now + m_timing.bytes(kSurplusCharacters) + m_timing.adapter();
        return;
    }
    if (pending.received.size() >= wanted)
        complete(now);
}

void Line::complete(TimePoint now) {
    const Pending pending = *std::exchange(m_pending, std::nullopt);
    // The module has received the whole command, so it has been sent, whatever the calculation says.
    m_free = std::min(m_free, now);
    const std::size_t wanted = pending.wanted();
    if (!m_echo.expected() && m_echo.begun())
        return endWithoutEcho(pending, now);
    if (pending.received.size() > wanted) {
        m_statistics.surplusBytes += pending.received.size() - wanted;
        m_ends.push_back(endOf(pending, ReplyResult::Rejected, now));
        m_ends.back().rejection = Rejection::Surplus;
        return;
    }
    ReplyEnd end = endOf(pending, ReplyResult::Accepted, now);
    const auto report = decodeStatus(pending.layout.module, pending.layout.items, pending.received);
    if (!report) {
        end.result = ReplyResult::BadChecksum;
        m_ends.push_back(end);
        return;
    }
    end.report = *report;
    if (isSc(pending.layout.module) && report->aux)
        end.report.aux = servo::toAuxByte(*report->aux).bits;
    if (report->commandRefused())
        end.result = ReplyResult::Refused;
    m_done = Done{end, pending.framing, now + m_timing.bytes(kSurplusCharacters)};
}

/// Handles the timeout: too few bytes, or an open reply that ended with silence.
void Line::expire(TimePoint now) {
    const Pending pending = *std::exchange(m_pending, std::nullopt);
    const ReplyBytes& bytes = pending.received;
    if (m_echo.expected() != m_echo.whole() && !(bytes.empty() && pending.early.empty()))
        return endWithoutEcho(pending, now);
    if (bytes.empty()) {
        m_strays.onMissed(now);
        m_ends.push_back(endOf(pending, ReplyResult::Unresponsive, now));
        return;
    }
    const Torn torn{pending, m_lastByte};
    if (pending.framing != Framing::Open) {
        m_torn = torn;
        m_strays.onMissed(now);
        m_ends.push_back(endOf(pending, ReplyResult::Partial, now));
        return;
    }
    ReplyEnd end = endOf(pending, ReplyResult::Accepted, now);
    if (bytes.size() < kMinReply)
        end.result = ReplyResult::Partial;
    else if (!isWhole(pending, bytes))
        end.result = ReplyResult::BadChecksum;
    else if ((end.report.status = bytes[0], end.report.commandRefused()))
        end.result = ReplyResult::Refused;
    if (unanswered(end.result))
        m_torn = torn;
    m_ends.push_back(end);
}

/// Adds the rest of a reply that was considered over. A correct sum of the whole distinguishes it from noise.
void Line::join(ByteSpan bytes, TimePoint now) {
    ReplyBytes& received = m_torn->pending.received;
    const Duration gap = now - m_torn->last;
    received.appendWhatFits(bytes);
    if (gap > kLongestReplyGap)
        return m_torn.reset();
    if (!isWhole(m_torn->pending, received))
        return;
    m_torn.reset();
    m_replyGap = std::max(m_replyGap, gap);
    m_timing.latency = std::max(m_timing.latency, m_replyGap + kMinLatency);
}

bool Line::isWhole(const Pending& pending, ByteSpan all) {
    if (pending.framing != Framing::Open)
        return decodeStatus(pending.layout.module, pending.layout.items, all).has_value();
    return all.size() >= kMinReply && sum8(all.first(all.size() - 1)) == all.back();
}

/// The echo is not as expected: damaged, missing, or present although none was expected.
void Line::endWithoutEcho(const Pending& pending, TimePoint now) {
    m_strays.onMissed(now);
    ReplyEnd end = endOf(pending, ReplyResult::Rejected, now);
    end.rejection = Rejection::Echo;
    end.bytes = pending.early;
    end.bytes.appendWhatFits(pending.received);
    if (m_echo.expected() && !m_echo.begun() && isWhole(pending, end.bytes))
        m_echo.cease();
    m_ends.push_back(end);
}

/// More bytes arrived than the previous reply has.
void Line::invalidate(ByteSpan surplus) {
    m_statistics.surplusBytes += surplus.size();
    m_done->end.bytes.appendWhatFits(surplus);
    m_done->end.result = ReplyResult::Rejected;
    m_done->end.rejection = Rejection::Surplus;
    settle();
}

void Line::settle() {
    if (!m_done)
        return;
    m_ends.push_back(m_done->end);
    m_done.reset();
}

ReplyEnd Line::endOf(const Pending& pending, ReplyResult result, TimePoint now) const {
    ReplyEnd end;
    end.result = result;
    end.bytes = pending.received;
    end.latched = std::min(pending.left + kServoTick / 2, now);
    end.latchedBy = std::max(end.latched, now - m_timing.shortest(pending.received.size()));
    // Measured from the latest time at which a prompt reply can arrive. A known adapter latency explains a
    // later reply, but does not make a reply early.
    const Duration late = end.latchedBy - pending.left - kServoTick - kPromptWithin;
    end.late = late < Duration{} ? late : std::max(Duration{}, late - m_timing.knownAdapter());
    end.sent = pending.sent;
    end.arrived = now;
    end.wireTime = m_timing.wireTime(pending.txBytes, pending.wanted());
    return end;
}

/// Bytes that are not expected may be meant for another host.
void Line::drop(ByteSpan bytes, TimePoint now) {
    if (m_torn && !m_pending)
        join(bytes, now);
    const std::size_t expected = std::min(bytes.size(), m_unread);
    m_unread -= expected;
    const ByteSpan strays = bytes.subspan(expected);
    m_statistics.surplusBytes += strays.size();
    m_statistics.staleBytes += strays.size();
    if (!strays.empty())
        m_strays.hear(strays, now, m_timing.byteTime);
}

}  // namespace nmc::bus
