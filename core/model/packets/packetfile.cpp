// SPDX-License-Identifier: MIT
#include "model/packets/packetfile.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "base/numbertext.h"
#include "base/text.h"
#include "model/packets/packetwords.h"

namespace nmc {

namespace {

constexpr std::string_view kMagic = "# nmcpanel packet log 1";
constexpr std::string_view kColumns =
    "# time_us took_us purpose module baud type:items verdict >command <reply";
constexpr std::string_view kGap = "gap";
constexpr std::size_t kMaxHeaderText = 500;

std::string hex(ByteSpan bytes) {
    std::string text = toHex(bytes);
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

std::string microseconds(Duration duration) {
    return fixedText(std::max<std::int64_t>(duration.count(), 0), 3);
}

std::string layoutText(const bus::ReplyLayout& layout) {
    std::string text = std::to_string(static_cast<int>(layout.module.type));
    if (layout.module.version != 0)
        text += '.' + std::to_string(layout.module.version);
    return text + ':' + toHex(std::array{layout.items.mask()});
}

std::string verdictText(const bus::ExchangeRecord& record) {
    std::string text(words::kEnds[static_cast<std::size_t>(record.end)]);
    if (record.end == bus::ReplyResult::Rejected && record.rejection) {
        text += ':';
        text += words::kRejections[static_cast<std::size_t>(*record.rejection)];
    }
    return text;
}

std::string exchangeLine(const bus::ExchangeRecord& record, TimePoint zero) {
    std::string line =
        microseconds(record.sent - zero) + ' ' + microseconds(record.ended - record.sent) + ' ';
    line += words::kPurposes[static_cast<std::size_t>(record.purpose)];
    line += ' ' + (record.module ? std::to_string(record.module->value() + 1) : "-") + ' ';
    line += std::to_string(record.baud) + ' ' + layoutText(record.layout) + ' ' + verdictText(record);
    return line + " >" + hex(record.command) + " <" + hex(record.reply);
}

}  // namespace

std::string writePacketFile(const PacketLog& log) {
    const PacketSession& session = log.session();
    std::string text = std::string(kMagic) + '\n';
    text += "# program " + oneLine(session.program, kMaxHeaderText) + '\n';
    text += "# started " + oneLine(session.startedAt, kMaxHeaderText) + '\n';
    text += "# port " + oneLine(session.port, kMaxHeaderText) + '\n';
    text += std::string("# simulated ") + (session.simulated ? "yes" : "no") + '\n';
    text += "# dropped " + std::to_string(log.dropped()) + '\n';
    text += std::string(kColumns) + "\n#\n";
    for (std::uint64_t i = log.first(); i < log.end(); ++i) {
        if (log.at(i).afterGap && i > log.first())
            text += std::string(kGap) + '\n';
        text += exchangeLine(log.at(i).record, session.zero) + '\n';
    }
    return text;
}

}  // namespace nmc
