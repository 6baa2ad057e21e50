// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/packetsaving.h"

#include <QSaveFile>

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

tl::expected<void, QString> savePackets(const PacketLog& log, const QString& path) {
    const bool replayable = path.endsWith(kPacketLogSuffix, Qt::CaseInsensitive);
    const std::string content = replayable ? writePacketFile(log) : textOf(log);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(file.errorString());
    file.write(content.data(), static_cast<qint64>(content.size()));
    if (!file.commit())
        return tl::unexpected(file.errorString());
    return {};
}

}  // namespace nmc
