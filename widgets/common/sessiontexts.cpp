// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about the program itself and the computer that it runs on.
#include <cmath>

#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// A time span in the unit that a person would use.
QString span(double seconds) {
    constexpr double kMinute = 60;
    constexpr double kHour = 60 * kMinute;
    if (seconds < 2 * kMinute)
        return Texts::tr("%1 s").arg(readout(std::round(seconds * 10) / 10, 3));
    if (seconds < 2 * kHour)
        return Texts::tr("%1 min").arg(std::lround(seconds / kMinute));
    return Texts::tr("%1 h").arg(std::lround(seconds / kHour));
}

}  // namespace

Message panelFroze(double seconds, bool stopped) {
    const QString text =
        stopped ? Texts::tr("The panel froze for %1; motors were commanded to stop after 2 s.")
                : Texts::tr("The panel froze for %1 while a motor was moving. The motor was not stopped.");
    // A separate key, so that one that stopped motors does not count as a repeat of one that did not.
    return {.key = stopped ? u"frozeAndStopped"_s : u"froze"_s,
            .severity = Severity::Attention,
            .headline = text.arg(span(seconds)),
            .body = Texts::tr(
                "STOP ALL did not work during that time. The computer was busy, or the program hung."),
            .relation = Message::Relation::Repeat};
}

Message machineSlept(double seconds, bool stopped) {
    const QString text =
        stopped ? Texts::tr("Resumed after %1: motors were commanded to stop; reading all values again.")
                : Texts::tr("Resumed after %1: reading all values again.");
    return {
        .key = u"slept"_s,
        .severity = Severity::Attention,
        .headline = text.arg(span(seconds)),
        .body = Texts::tr(
            "While the computer was suspended, the panel could not stop a motor. Look at the motors before the next move.")};
}

namespace {

QString commandedByGuardian(const std::vector<ModuleIndex>& modules) {
    return Texts::tr(
               "The panel ended without stopping its motors; its guardian commanded modules %1 to stop.",
               nullptr, howMany(modules))
        .arg(listOfModules(modules));
}

QString guardianCannotSee() {
    return Texts::tr(
        "The program was killed, or it hung. The guardian cannot see whether a motor stopped: look at the motors before you connect; use the hardware stop if one moves.");
}

}  // namespace

Message endedWhileMoving(const std::vector<ModuleIndex>& modules, const QString& port, const QString& file,
                         const std::optional<std::vector<ModuleIndex>>& stoppedByGuardian) {
    Message m{
        .key = key::endedWhileMoving(file),
        .severity = Severity::Attention,
        .actions = {lookFirst(), {MessageAction::LookedAt, Texts::tr("I have checked: it is at rest")}}};
    const QString moving = listOfModules(modules);
    if (stoppedByGuardian) {
        const QString were = Texts::tr("Motors %1 were moving, at %2.", nullptr, howMany(modules));
        m.headline = commandedByGuardian(*stoppedByGuardian);
        m.body = were.arg(moving, portName(port)) + u' ' + guardianCannotSee() + u' ' +
                 Texts::tr("This message stays until the motor is seen at rest.");
        return m;
    }
    m.headline = Texts::tr("The last session ended while motors %1 were moving.", nullptr, howMany(modules))
                     .arg(moving);
    m.body =
        Texts::tr(
            "It was connected to %1 and was killed, or the computer failed. Motor state unknown: look at the motor before you connect; use the hardware stop if it moves. This message stays until the motor is seen at rest.")
            .arg(portName(port));
    return m;
}

Message guardianStoppedBefore(const std::vector<ModuleIndex>& modules) {
    return {.key = u"guardianStoppedBefore"_s,
            .severity = Severity::Attention,
            .headline = commandedByGuardian(modules),
            .body = guardianCannotSee(),
            .actions = {lookFirst()}};
}

Message guardianStopped() {
    return {
        .key = u"guardianStopped"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr(
            "The panel stalled while a motor was moving; its guardian commanded the motors to stop."),
        .body = Texts::tr(
            "The program was halted, or the computer was too busy. The panel is reading all values again.")};
}

Message guardianMissing(GuardianProblem problem) {
    Message m{.key = u"guardianMissing"_s,
              .severity = Severity::Attention,
              .headline = Texts::tr("No guardian: if this program is killed, nothing stops the motors."),
              .stands = true};
    switch (problem) {
        case GuardianProblem::Missing:
            m.body = Texts::tr("nmcguard is missing. Reinstall the program. Everything else works.");
            break;
        case GuardianProblem::NotPermitted:
            m.body = Texts::tr(
                "Your user account has no permission to start nmcguard. Reinstall the program. Everything else works.");
            break;
        case GuardianProblem::WrongVersion:
            m.body = Texts::tr(
                "nmcguard and this program have different versions. Reinstall both. Everything else works.");
            break;
        case GuardianProblem::Failed:
            m.body = Texts::tr(
                "The computer ran out of memory or open files. Close other programs, then connect again. Everything else works.");
            break;
        case GuardianProblem::Ended:
            m.body = Texts::tr(
                "The guardian ended unexpectedly. Connect again to restart it. Everything else works.");
            break;
    }
    return m;
}

Message settingsNotSaved(const QString& file) {
    return {
        .key = u"settings"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("Settings cannot be saved."),
        .body =
            Texts::tr(
                "%1 is not writable. Everything else works; only the window layout and the last port are not remembered.")
                .arg(file),
        .stands = true};
}

Message messagesNotKept(const FileError& error) {
    return {
        .key = key::kMessageLog,
        .severity = Severity::Attention,
        .headline = Texts::tr("Messages are lost when this session ends."),
        .body =
            Texts::tr("%1 is not writable. Everything else works. To keep messages, export the message list.")
                .arg(error.path),
        .details = error.detail};
}

Message positionsNotKept(const FileError& error) {
    return {
        .key = u"positionFile"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("The positions of the axes are not saved."),
        .body =
            Texts::tr(
                "%1 is not writable. Everything else works. If the modules lose power now, search for home again: an older position may be offered.")
                .arg(error.path),
        .details = error.detail};
}

Message withRecord(Message message) {
    message.actions.prepend({MessageAction::ShowRecord, Texts::tr("Show the last 2 s")});
    return message;
}

Message recordNotKept(std::size_t most) {
    return {
        .key = u"record"_s,
        .headline = Texts::tr("What led to that message is no longer kept."),
        .body =
            Texts::tr("The last %1 faults and stops can be shown. A recording keeps everything.").arg(most)};
}

QString recordTitle(const QString& headline, const QTime& when) {
    return Common::tr("%1 (%2)").arg(headline, when.toString(u"HH:mm:ss"_s));
}

QString stopOfAll() {
    return Texts::tr("Stop of all motors");
}

}  // namespace nmc::texts
