// SPDX-License-Identifier: MIT
#include "bus/line.h"

#include <array>
#include <cassert>
#include <utility>

namespace nmc::bus {

namespace {

template <typename... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <typename... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

}  // namespace

void Line::begin(const Request& request, TimePoint now) {
    assert(idle());
    const PacketBytes packet = toPacket({request.address, request.payload});
    const TimePoint start = std::max(now, m_free);
    m_unread = 0;
    m_lastTimeout = m_timing.timeout(packet.size(), request.reply.length());
    m_pending = Pending{request.reply, packet.size(), now, latchTime(packet.size(), now), {}};
    m_deadline = start + m_lastTimeout;
    send(packet, now);
    ++m_statistics.exchanges;
}

void Line::run(Script script, TimePoint now) {
    assert(idle());
    m_scriptLatches.clear();
    m_script.assign(script.begin(), script.end());
    advanceScript(now);
}

void Line::abandon() {
    // The rest of the reply may still come; it is no surplus.
    if (m_pending)
        m_unread += m_pending->layout.length() - m_pending->received.size();
    m_pending.reset();
    m_script.clear();
    m_deadline.reset();
}

std::optional<ReplyEnd> Line::onBytes(ByteSpan bytes, TimePoint now) {
    if (!m_pending) {
        drop(bytes.size());
        return std::nullopt;
    }
    const std::size_t wanted = m_pending->layout.length() - m_pending->received.size();
    m_pending->received.append(bytes.first(std::min(wanted, bytes.size())));
    if (bytes.size() < wanted)
        return std::nullopt;
    m_statistics.surplusBytes += bytes.size() - wanted;
    return complete(now);
}

std::optional<ReplyEnd> Line::onDeadline(TimePoint now) {
    if (!m_deadline || now < *m_deadline)
        return std::nullopt;
    m_deadline.reset();
    if (m_pending) {
        ++m_statistics.timeouts;
        return finish(m_pending->received.empty() ? ReplyResult::Silent : ReplyResult::Partial);
    }
    advanceScript(now);
    return std::nullopt;
}

TimePoint Line::latchTime(std::size_t txBytes, TimePoint now) const {
    return std::max(now, m_free) + m_timing.bytes(txBytes) + kServoTick / 2;
}

std::vector<Output> Line::takeOutput() {
    return std::exchange(m_output, {});
}

void Line::send(ByteSpan bytes, TimePoint now) {
    m_free = std::max(now, m_free) + m_timing.bytes(bytes.size());
    m_output.emplace_back(Send{{bytes.begin(), bytes.end()}});
}

void Line::advanceScript(TimePoint now) {
    while (!m_script.empty() && !m_deadline) {
        const Action action = m_script.front();
        m_script.pop_front();
        perform(action, now);
    }
}

void Line::perform(const Action& action, TimePoint now) {
    static constexpr std::array<std::uint8_t, kNullCount> kNulls{};
    std::visit(Overloaded{
                   [&](const SetHostBaud& rate) {
                       m_timing.byteTime = byteTimeAtBaud(rate.baud);
                       m_output.emplace_back(rate);
                   },
                   [&](const DiscardInput& discard) {
                       m_unread = 0;
                       m_output.emplace_back(discard);
                   },
                   [&](const Nulls&) { send(kNulls, now); },
                   [&](const Gap&) { waitUntil(m_free + kTurnaround, now); },
                   [&](const Pause& pause) { waitUntil(std::max(now, m_free) + pause.time, now); },
                   [&](const Packet& packet) {
                       m_unread += packet.replyBytes;
                       m_scriptLatches.push_back(latchTime(packet.bytes.size(), now));
                       send(packet.bytes, now);
                   },
               },
               action);
}

void Line::waitUntil(TimePoint until, TimePoint now) {
    if (until > now)
        m_deadline = until;
}

ReplyEnd Line::finish(ReplyResult result, StatusReport report) {
    ReplyEnd end{result, std::move(report), m_pending->latched};
    m_pending.reset();
    m_deadline.reset();
    return end;
}

ReplyEnd Line::complete(TimePoint now) {
    Pending& pending = *m_pending;
    // The module has heard the whole command, so it has left, whatever the reckoning says.
    m_free = std::min(m_free, now);
    pending.latched = std::min(pending.latched, now);
    const auto report = decodeStatus(pending.layout.type, pending.layout.items, pending.received);
    if (!report) {
        ++m_statistics.badChecksum;
        return finish(ReplyResult::BadChecksum);
    }
    if (report->commandRefused()) {
        ++m_statistics.refused;
        return finish(ReplyResult::Refused, *report);
    }
    ++m_statistics.answered;
    m_statistics.roundTripSum += now - pending.sent;
    m_statistics.roundTripMax = std::max(m_statistics.roundTripMax, now - pending.sent);
    m_statistics.wireTime += m_timing.wireTime(pending.txBytes, pending.layout.length());
    return finish(ReplyResult::Accepted, *report);
}

void Line::drop(std::size_t count) {
    const std::size_t expected = std::min(count, m_unread);
    m_unread -= expected;
    m_statistics.surplusBytes += count - expected;
}

}  // namespace nmc::bus
