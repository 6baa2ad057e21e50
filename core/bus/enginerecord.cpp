// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bus/engineprivate.h"

namespace nmc::bus {

namespace {

[[nodiscard]] ExchangeEnd endFor(ReplyResult result) {
    switch (result) {
        case ReplyResult::Accepted:
            return ExchangeEnd::Accepted;
        case ReplyResult::Refused:
            return ExchangeEnd::Refused;
        case ReplyResult::Silent:
            return ExchangeEnd::Silent;
        case ReplyResult::Partial:
            return ExchangeEnd::Partial;
        case ReplyResult::BadChecksum:
            return ExchangeEnd::BadChecksum;
        case ReplyResult::Surplus:
        case ReplyResult::Rejected:
            break;
    }
    return ExchangeEnd::Rejected;
}

}  // namespace

void Engine::Private::setRecording(bool on) {
    m_recording = on;
    line.setRecording(on);
    if (on)
        return;
    records.clear();
    m_recorded = 0;
}

void Engine::Private::record(const Work& work, const ReplyEnd& end, std::optional<Rejection> rejection) {
    if (m_recording)
        recordAs(work, end, endFor(end.result),
                 end.result == ReplyResult::Surplus ? Rejection::Surplus : rejection);
}

void Engine::Private::recordAs(const Work& work, const ReplyEnd& end, ExchangeEnd how,
                               std::optional<Rejection> rejection) {
    recordUnanswered();
    const PacketBytes packet = toPacket({work.request.address, work.request.payload});
    ExchangeRecord entry;
    entry.number = ++m_recorded;
    entry.sent = end.sent;
    entry.ended = end.arrived;
    entry.purpose = purposeOf(work.lane);
    entry.baud = line.baud();
    entry.module = work.module;
    entry.command.assign(packet.begin(), packet.end());
    entry.reply.assign(end.bytes.begin(), end.bytes.end());
    entry.layout = work.request.reply;
    entry.end = how;
    entry.rejection = rejection;
    records.push_back(std::move(entry));
}

/// What scripts sent since the last time, in front of what came after it.
void Engine::Private::recordUnanswered() {
    for (Line::Unanswered& sent : line.takeUnanswered()) {
        ExchangeRecord entry;
        entry.number = ++m_recorded;
        entry.sent = entry.ended = sent.sent;
        const bool nulls =
            std::all_of(sent.bytes.begin(), sent.bytes.end(), [](std::uint8_t b) { return b == 0; });
        entry.purpose = m_phase == Phase::Discovering || m_rateChange ? Purpose::Connect
                        : nulls                                       ? Purpose::Flush
                        : m_groupRun                                  ? Purpose::Operation
                                                                      : Purpose::Stop;
        entry.baud = line.baud();
        entry.command = std::move(sent.bytes);
        entry.end = ExchangeEnd::NotAsked;
        records.push_back(std::move(entry));
    }
}

void Engine::Private::recordAbandoned(TimePoint now) {
    if (!m_recording)
        return;
    for (const Work& work : m_works) {
        ReplyEnd end;
        end.sent = work.sent;
        end.arrived = now;
        recordAs(work, end, ExchangeEnd::Abandoned, std::nullopt);
    }
}

Purpose Engine::Private::purposeOf(Lane lane) {
    switch (lane) {
        case Lane::Discovery:
        case Lane::Rate:
            return Purpose::Connect;
        case Lane::Stop:
        case Lane::Guard:
            return Purpose::Stop;
        case Lane::HoldStop:
        case Lane::HoldCheck:
        case Lane::Hold:
            return Purpose::Hold;
        case Lane::Operation:
        case Lane::Group:
            return Purpose::Operation;
        case Lane::Check:
        case Lane::GroupLook:
            return Purpose::Check;
        case Lane::Challenge:
        case Lane::Restarted:
            return Purpose::Challenge;
        case Lane::Poll:
            break;
    }
    return Purpose::Poll;
}

}  // namespace nmc::bus
