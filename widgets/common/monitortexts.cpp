// SPDX-License-Identifier: GPL-3.0-or-later
// The packet monitor's part of the table of texts.

#include "model/packets/packetlog.h"
#include "protocol/frame.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

QString rejection(bus::Rejection rejection) {
    switch (rejection) {
        case bus::Rejection::Uniform:
            return Texts::tr("all bytes are 00, or all FF, as on a line that is held low or high");
        case bus::Rejection::Surplus:
            return Texts::tr("more bytes than requested");
        case bus::Rejection::Echo:
            return Texts::tr("no exact echo of the command before it");
        case bus::Rejection::Identity:
            return Texts::tr("type or version does not match this module");
        case bus::Rejection::UndefinedBits:
            return Texts::tr("an undefined status bit changed");
        case bus::Rejection::HomingRose:
            return Texts::tr("homing started without a command");
        case bus::Rejection::HomeChanged:
            return Texts::tr("home register changed without a command");
        case bus::Rejection::PositionJump:
            return Texts::tr("position jumped farther than the velocities allow");
        case bus::Rejection::VelocityJump:
            return Texts::tr("velocity changed faster than any motor can");
        case bus::Rejection::OffWithoutBits:
            return Texts::tr("servo is off, but pos_error or move_done is not set");
        case bus::Rejection::OnWithoutPower:
            return Texts::tr("servo is on without motor power");
        case bus::Rejection::SlewWithoutAccel:
            return Texts::tr("slew_done is set without accel_done");
        case bus::Rejection::StickyCleared:
            return Texts::tr("a sticky bit was cleared without a command");
        case bus::Rejection::BothModes:
            return Texts::tr("velocity and trapezoidal mode at once");
        case bus::Rejection::MovingWithoutPower:
            return Texts::tr("moving without power or amplifier");
        case bus::Rejection::MovedWhileStopped:
            return Texts::tr("position changed while the motor was stopped");
        case bus::Rejection::TimerCount:
            return Texts::tr("timer count of a moving motor is not 1 to 65 452");
    }
    return {};
}

QString verdict(const bus::ExchangeRecord& record) {
    switch (record.end) {
        case bus::ReplyResult::Accepted:
            return Texts::tr("accepted");
        case bus::ReplyResult::Refused:
            return Texts::tr("module refused: checksum");
        case bus::ReplyResult::Unresponsive:
            return Texts::tr("no answer");
        case bus::ReplyResult::Partial:
            return Texts::tr("too few bytes");
        case bus::ReplyResult::BadChecksum:
            return Texts::tr("wrong checksum");
        case bus::ReplyResult::Rejected:
            return record.rejection ? Texts::tr("rejected: %1").arg(rejection(*record.rejection))
                                    : Texts::tr("rejected");
        case bus::ReplyResult::Abandoned:
            return Texts::tr("cancelled by a stop");
        case bus::ReplyResult::NotAsked:
            return record.reply.empty() ? Texts::tr("no answer expected")
                                        : Texts::tr("bytes, but no answer was expected");
    }
    return {};
}

QString purpose(bus::Purpose purpose) {
    switch (purpose) {
        case bus::Purpose::Connect:
            return Texts::tr("connecting");
        case bus::Purpose::Poll:
            return Texts::tr("poll");
        case bus::Purpose::Operation:
            return Texts::tr("command");
        case bus::Purpose::Check:
            return Texts::tr("check");
        case bus::Purpose::Hold:
            return Texts::tr("jog");
        case bus::Purpose::Stop:
            return Texts::tr("stop");
        case bus::Purpose::Challenge:
            return Texts::tr("challenge");
        case bus::Purpose::Flush:
            return Texts::tr("flush");
        case bus::Purpose::Lent:
            return Texts::tr("program");
    }
    return {};
}

QString packetTarget(const bus::ExchangeRecord& record) {
    if (record.module)
        return moduleName(*record.module);
    if (record.command.size() < 2 || record.command[0] != kHeader)
        return u"–"_s;
    const int address = record.command[1];
    return address >= 0x80 ? Common::tr("Group %1").arg(QString::number(address, 16).toUpper())
                           : Texts::tr("Address %1").arg(address);
}

QString packetTextHead(const PacketSession& session, quint64 dropped) {
    QStringList lines;
    if (session.simulated)
        lines << Texts::tr("SIMULATED SESSION: no hardware was connected.");
    lines << Texts::tr("Packets of %1 on %2, seconds since %3")
                 .arg(QString::fromStdString(session.program), portName(QString::fromStdString(session.port)),
                      QString::fromStdString(session.startedAt));
    if (dropped > 0)
        lines << Texts::tr("Older exchanges left out of this file: %1.")
                     .arg(grouped(static_cast<qint64>(dropped)));
    return lines.join(u'\n');
}

QString packetGap() {
    return Texts::tr("Exchanges before this one were not recorded.");
}

}  // namespace nmc::texts
