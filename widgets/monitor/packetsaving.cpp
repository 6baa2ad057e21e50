// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetsaving.h"

#include <utility>

#include "model/packets/packetfile.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

std::string linesOf(const PacketLog& log, std::uint64_t first) {
    std::string text;
    const std::string gap = texts::packetGap().toStdString();
    for (std::uint64_t i = first; i < log.end(); ++i) {
        const PacketEntry& entry = log.at(i);
        if (entry.afterGap)
            text += "... " + gap + '\n';
        text += packetLine(entry.record, log.session().zero, texts::verdict(entry.record).toStdString());
        text += '\n';
    }
    return text;
}

std::string readableText(const PacketLog& log) {
    return texts::packetTextHead(log.session(), log.dropped()).toStdString() + "\n\n" +
           linesOf(log, log.first());
}

}  // namespace

FileContent packetFile(PacketLog log, const QString& path) {
    const bool replayable = path.endsWith(kPacketLogSuffix, Qt::CaseInsensitive);
    return
        [log = std::move(log), replayable] { return replayable ? writePacketFile(log) : readableText(log); };
}

std::string lastPackets(const PacketLog& log, std::uint64_t most) {
    return linesOf(log, log.size() > most ? log.end() - most : log.first());
}

}  // namespace nmc
