// SPDX-License-Identifier: GPL-3.0-or-later
// What the table of texts has to say of the program itself and of the computer it runs on.
#include <cmath>

#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

/// In the unit that a person would say it in.
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
        stopped ? Texts::tr("The panel was frozen for %1; motors were told to stop after 2 s.")
                : Texts::tr("The panel was frozen for %1 while a motor was moving. It was not stopped.");
    return {.key = u"froze"_s,
            .severity = Severity::Attention,
            .headline = text.arg(span(seconds)),
            .body = Texts::tr(
                "Stop all could not be pressed meanwhile. The computer was busy, or the program hung.")};
}

Message machineSlept(double seconds, bool stopped) {
    const QString text =
        stopped ? Texts::tr("Resumed after %1: motors were told to stop, and all values are read again.")
                : Texts::tr("Resumed after %1: all values are read again.");
    return {.key = u"slept"_s,
            .severity = Severity::Attention,
            .headline = text.arg(span(seconds)),
            .body = Texts::tr(
                "The computer was suspended. Motors that moved went on moving meanwhile; look at them before "
                "the next move.")};
}

namespace {

QString guardianTold(const std::vector<ModuleIndex>& modules) {
    const QString text =
        modules.size() == 1
            ? Texts::tr("The panel ended without stopping its motors; its guardian told module %1 to stop.")
            : Texts::tr("The panel ended without stopping its motors; its guardian told modules %1 to stop.");
    return text.arg(listOfModules(modules));
}

QString guardianCannotSee() {
    return Texts::tr(
        "The program was killed, or it hung. The guardian cannot see whether a motor obeyed: look at it "
        "before you connect; use the hardware stop if it moves.");
}

}  // namespace

Message endedWhileMoving(const std::vector<ModuleIndex>& modules, const QString& port, const QString& file,
                         const std::optional<std::vector<ModuleIndex>>& toldByGuardian) {
    Message m{
        .key = key::endedWhileMoving(file),
        .severity = Severity::Attention,
        .actions = {lookFirst(), {MessageAction::LookedAt, Texts::tr("I have looked: it stands still")}}};
    const QString moving = listOfModules(modules);
    if (toldByGuardian) {
        const QString were = modules.size() == 1 ? Texts::tr("Motor %1 was moving, at %2.")
                                                 : Texts::tr("Motors %1 were moving, at %2.");
        m.headline = guardianTold(*toldByGuardian);
        m.body = were.arg(moving, portName(port)) + u' ' + guardianCannotSee() + u' ' +
                 Texts::tr("This is said until the motor was seen at rest.");
        return m;
    }
    const QString ended = modules.size() == 1
                              ? Texts::tr("The last session ended while motor %1 was moving.")
                              : Texts::tr("The last session ended while motors %1 were moving.");
    m.headline = ended.arg(moving);
    m.body = Texts::tr(
                 "It was connected to %1, and was killed, or the computer failed. Motor state unknown: "
                 "look at it before you connect; use the hardware stop if it moves. This is said until "
                 "the motor was seen at rest.")
                 .arg(portName(port));
    return m;
}

Message guardianStoppedBefore(const std::vector<ModuleIndex>& modules) {
    return {.key = u"guardianStoppedBefore"_s,
            .severity = Severity::Attention,
            .headline = guardianTold(modules),
            .body = guardianCannotSee(),
            .actions = {lookFirst()}};
}

Message guardianStopped() {
    return {
        .key = u"guardianStopped"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("The panel stood still while a motor was moving; its guardian told the motors "
                              "to stop."),
        .body = Texts::tr("The program was halted, or the computer was too busy. Every value is being read "
                          "again.")};
}

Message guardianMissing(GuardianProblem problem) {
    Message m{.key = u"guardianMissing"_s,
              .severity = Severity::Attention,
              .headline = Texts::tr("Nobody stops the motors if this program is killed: it has no guardian."),
              .stands = true};
    switch (problem) {
        case GuardianProblem::Missing:
            m.body = Texts::tr(
                "nmcguard, a part of this program, is missing. Install the program again. "
                "Everything else works.");
            break;
        case GuardianProblem::NotPermitted:
            m.body =
                Texts::tr("This user may not start nmcguard, a part of this program. Everything else works.");
            break;
        case GuardianProblem::WrongVersion:
            m.body = Texts::tr(
                "The nmcguard of this program is of another version. Install the program again. "
                "Everything else works.");
            break;
        case GuardianProblem::Failed:
            m.body = Texts::tr(
                "The computer has no memory or no file left for it. Close other programs, then "
                "connect again. Everything else works.");
            break;
        case GuardianProblem::Ended:
            m.body = Texts::tr(
                "It has ended by itself. Connect again to start another one. Everything else "
                "works.");
            break;
    }
    return m;
}

Message settingsNotSaved(const QString& file) {
    return {
        .key = u"settings"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("Settings are not saved."),
        .body = Texts::tr("%1 cannot be written. Everything else works; only the layout of the window and "
                          "the last port will not be remembered.")
                    .arg(file),
        .stands = true};
}

Message messagesNotKept(const FileError& error) {
    return {
        .key = u"messageLog"_s,
        .severity = Severity::Attention,
        .headline = Texts::tr("Messages are not kept beyond this session."),
        .body = Texts::tr("%1 cannot be written. Everything else works; the list of messages has an export.")
                    .arg(error.path),
        .details = error.detail};
}

Message withRecord(Message message) {
    message.actions.prepend({MessageAction::ShowRecord, Texts::tr("Show the last 2 s")});
    return message;
}

QString recordTitle(const QString& headline, const QTime& when) {
    return Texts::tr("%1 (%2)").arg(headline, when.toString(u"HH:mm:ss"_s));
}

QString stopOfAll() {
    return Texts::tr("Stop of all motors");
}

}  // namespace nmc::texts
