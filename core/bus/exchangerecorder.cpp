// SPDX-License-Identifier: MIT
#include "bus/exchangerecorder.h"

#include <algorithm>

namespace nmc::bus {

namespace {

[[nodiscard]] ExchangeEnd endFor(ReplyResult result) {
    switch (result) {
        case ReplyResult::Accepted:
            return ExchangeEnd::Accepted;
        case ReplyResult::Refused:
            return ExchangeEnd::Refused;
        case ReplyResult::Unresponsive:
            return ExchangeEnd::Unresponsive;
        case ReplyResult::Partial:
            return ExchangeEnd::Partial;
        case ReplyResult::BadChecksum:
            return ExchangeEnd::BadChecksum;
        case ReplyResult::Surplus:
        case ReplyResult::Rejected:
        case ReplyResult::Echo:
            break;
    }
    return ExchangeEnd::Rejected;
}

[[nodiscard]] bool nullsOnly(const std::vector<std::uint8_t>& bytes) {
    return std::ranges::all_of(bytes, [](std::uint8_t b) { return b == 0; });
}

}  // namespace

void ExchangeRecorder::set(bool on) {
    m_on = on;
    m_line.setRecording(on);
    if (on)
        return;
    m_records.clear();
    m_recorded = 0;
}

void ExchangeRecorder::add(const Ask& ask, const ReplyEnd& end, std::optional<Rejection> rejection) {
    add(ask, end, endFor(end.result), rejection);
}

void ExchangeRecorder::addAbandoned(const Ask& ask, TimePoint sent, TimePoint now) {
    ReplyEnd end;
    end.sent = sent;
    end.arrived = now;
    add(ask, end, ExchangeEnd::Abandoned, std::nullopt);
}

void ExchangeRecorder::add(const Ask& ask, const ReplyEnd& end, ExchangeEnd how,
                           std::optional<Rejection> rejection) {
    if (!m_on)
        return;
    addUnanswered(ask.purpose);
    const PacketBytes packet =
        ask.asSent ? *ask.asSent : toPacket({ask.request.address, ask.request.payload});
    ExchangeRecord entry;
    entry.number = ++m_recorded;
    entry.sent = end.sent;
    entry.ended = end.arrived;
    entry.purpose = ask.purpose;
    entry.baud = m_line.baud();
    entry.module = ask.module;
    entry.command.assign(packet.begin(), packet.end());
    entry.reply.assign(end.bytes.begin(), end.bytes.end());
    entry.layout = ask.request.reply;
    entry.end = how;
    entry.rejection = rejection;
    m_records.push_back(std::move(entry));
}

void ExchangeRecorder::addUnanswered(Purpose purpose) {
    if (!m_on)
        return;
    for (Line::Unanswered& sent : m_line.takeUnanswered()) {
        ExchangeRecord entry;
        entry.number = ++m_recorded;
        entry.sent = entry.ended = sent.sent;
        entry.purpose = purpose == Purpose::Connect ? purpose
                        : nullsOnly(sent.bytes)     ? Purpose::Flush
                                                    : purpose;
        entry.baud = m_line.baud();
        entry.command = std::move(sent.bytes);
        entry.end = ExchangeEnd::NotAsked;
        m_records.push_back(std::move(entry));
    }
}

}  // namespace nmc::bus
