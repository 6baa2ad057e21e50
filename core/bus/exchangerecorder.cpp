// SPDX-License-Identifier: MIT
#include "bus/exchangerecorder.h"

#include <algorithm>

namespace nmc::bus {

namespace {

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

void ExchangeRecorder::add(const Ask& ask, const ReplyEnd& end) {
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
    entry.end = end.result;
    entry.rejection = end.rejection;
    m_records.push_back(std::move(entry));
}

void ExchangeRecorder::addAbandoned(const Ask& ask, TimePoint sent, TimePoint now) {
    ReplyEnd end;
    end.result = ReplyResult::Abandoned;
    end.sent = sent;
    end.arrived = now;
    add(ask, end);
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
        entry.end = ReplyResult::NotAsked;
        m_records.push_back(std::move(entry));
    }
}

}  // namespace nmc::bus
