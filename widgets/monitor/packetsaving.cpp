// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetsaving.h"

#include <utility>

#include "model/packets/packetfile.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

std::string textOf(const PacketLog& log) {
    std::string text = texts::packetTextHead(log.session(), log.dropped()).toStdString() + "\n\n";
    const std::string gap = texts::packetGap().toStdString();
    for (std::uint64_t i = log.first(); i < log.end(); ++i) {
        const PacketEntry& entry = log.at(i);
        if (entry.afterGap)
            text += "... " + gap + '\n';
        text += packetLine(entry.record, log.session().zero, texts::verdict(entry.record).toStdString());
        text += '\n';
    }
    return text;
}

}  // namespace

FileContent packetFile(PacketLog log, const QString& path) {
    const bool replayable = path.endsWith(kPacketLogSuffix, Qt::CaseInsensitive);
    return [log = std::move(log), replayable] { return replayable ? writePacketFile(log) : textOf(log); };
}

}  // namespace nmc
