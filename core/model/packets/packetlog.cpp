// SPDX-License-Identifier: MIT
#include "model/packets/packetlog.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/numbertext.h"
#include "protocol/describe.h"
#include "protocol/frame.h"

namespace nmc {

namespace {

std::size_t bytesOf(const PacketEntry& entry) {
    return entry.record.command.size() + entry.record.reply.size();
}

}  // namespace

PacketKind kindOf(bus::Purpose purpose) {
    switch (purpose) {
        case bus::Purpose::Poll:
            return PacketKind::Poll;
        case bus::Purpose::Operation:
        case bus::Purpose::Check:
        case bus::Purpose::Hold:
        case bus::Purpose::Lent:
            return PacketKind::Command;
        case bus::Purpose::Stop:
            return PacketKind::Stop;
        case bus::Purpose::Connect:
        case bus::Purpose::Challenge:
        case bus::Purpose::Flush:
            return PacketKind::Link;
    }
    return PacketKind::Link;
}

bool wentWrong(const bus::ExchangeRecord& record) {
    switch (record.end) {
        case bus::ReplyResult::Accepted:
        case bus::ReplyResult::Abandoned:
            return false;
        case bus::ReplyResult::NotAsked:
            return !record.reply.empty();
        case bus::ReplyResult::Refused:
        case bus::ReplyResult::Unresponsive:
        case bus::ReplyResult::Partial:
        case bus::ReplyResult::BadChecksum:
        case bus::ReplyResult::Rejected:
            return true;
    }
    return true;
}

bool PacketFilter::passes(const bus::ExchangeRecord& record) const {
    return (!module || record.module == module) && (!kind || kindOf(record.purpose) == *kind) &&
           (!onlyErrors || wentWrong(record));
}

void PacketLog::begin(PacketSession session) {
    clear();
    m_session = std::move(session);
    m_lastNumber = 0;
}

void PacketLog::clear() {
    m_first = end();
    m_entries.clear();
    m_bytes = 0;
    m_dropped = 0;
    m_interrupted = false;
}

void PacketLog::append(bus::ExchangeRecord record) {
    // The numbers count the recorded exchanges, so a jump shows how many a full queue has lost.
    const bool jump = !m_entries.empty() && record.number != m_lastNumber + 1;
    m_lastNumber = record.number;
    record.command.resize(std::min(record.command.size(), kMaxRecordBytes));
    record.reply.resize(std::min(record.reply.size(), kMaxRecordBytes));
    m_entries.push_back({std::move(record), std::exchange(m_interrupted, false) || jump});
    m_bytes += bytesOf(m_entries.back());
    while (m_entries.size() > m_maxEntries || (m_bytes > m_maxBytes && m_entries.size() > 1))
        dropFirst();
}

void PacketLog::dropFirst() {
    m_bytes -= bytesOf(m_entries.front());
    m_entries.pop_front();
    ++m_first;
    ++m_dropped;
}

std::string packetTarget(const bus::ExchangeRecord& record) {
    if (record.module)
        return "module " + std::to_string(record.module->value() + 1);
    if (record.command.size() < 2 || record.command[0] != kHeader)
        return "-";
    const std::uint8_t address = record.command[1];
    return address >= 0x80 ? "group " + toHex(std::array{address}) : "address " + std::to_string(address);
}

std::string packetReplyMeaning(const bus::ExchangeRecord& record) {
    if (record.end != bus::ReplyResult::NotAsked || record.reply.empty())
        return describeReply(record.layout.module, record.layout.items, record.reply);
    return std::to_string(record.reply.size()) + (record.reply.size() == 1 ? " byte" : " bytes");
}

std::string packetTime(TimePoint time, TimePoint zero) {
    return fixedText((time - zero) / std::chrono::microseconds(1), 6);
}

std::string packetLine(const bus::ExchangeRecord& record, TimePoint zero, std::string_view verdict) {
    std::string line = packetTime(record.sent, zero) + " s  " + packetTarget(record) + "  " +
                       std::to_string(record.baud) + " Bd  > " + toHex(record.command) + "  (" +
                       describeCommand(record.layout.module, record.command) + ')';
    if (!record.reply.empty())
        line += "  < " + toHex(record.reply) + "  (" + packetReplyMeaning(record) + ')';
    return line + "  " + std::string(verdict);
}

}  // namespace nmc
