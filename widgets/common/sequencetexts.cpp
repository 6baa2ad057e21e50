// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/sequencetexts.h"

#include <QStringList>
#include <array>

#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

QString notAnOutput(const QString& module) {
    return Texts::tr("This pin of %1 is not set as an output. Make it an output first.").arg(module);
}

QString outputsUnknown(const QString& module) {
    return Texts::tr("The outputs of %1 are unknown. Set them once on the module's page.").arg(module);
}

QString mayHaveShifted(const QString& module, const std::string& point) {
    return Texts::tr(
               "Point \"%2\" was taught before home of %1 was known, so it may have shifted. Teach it again.")
        .arg(module, QString::fromStdString(point));
}

/// The problem as a sentence, without the row.
QString wrong(const SequenceProblem& problem) {
    using Kind = SequenceProblem::Kind;
    const QString name = QString::fromStdString(problem.name);
    const QString module = problem.module ? moduleName(*problem.module) : QString();
    switch (problem.kind) {
        case Kind::NoName:
            return Texts::tr("Enter a name.");
        case Kind::NameTwice:
            return Texts::tr("The name \"%1\" is already used. Choose another one.").arg(name);
        case Kind::AxisTwice:
            return Texts::tr("Point \"%2\" contains %1 twice.").arg(module, name);
        case Kind::NoSuchPoint:
            return Texts::tr("Point \"%1\" does not exist.").arg(name);
        case Kind::NoSuchSequence:
            return Texts::tr("Sequence \"%1\" does not exist.").arg(name);
        case Kind::CallsItself:
            return Texts::tr("The sequence \"%1\" would call itself endlessly.").arg(name);
        case Kind::RepeatsBelow:
            return Texts::tr("A repeat must go back to an earlier row.");
        case Kind::NoRows:
            return Texts::tr("The sequence has no rows. Add a row first.");
        case Kind::NoAxes:
            return Texts::tr("Point \"%1\" has no axes. Teach it again.").arg(name);
        case Kind::NoSuchModule:
            return Texts::tr("%1 is not in the chain.").arg(module);
        case Kind::Refused: {
            const auto& travel = problem.travel;
            const QString reason = travel ? travelProblem(travel->problem, travel->zero, travel->scale)
                                          : refusal(*problem.refusal);
            return problem.module ? Common::tr("%1: %2").arg(module, reason) : reason;
        }
        case Kind::TaughtElsewhere:
            return mayHaveShifted(module, problem.name);
        case Kind::NoRecipe:
            return Texts::tr("Homing of %1 is not set up. Set it up on its Homing page.").arg(module);
        case Kind::NoSuchPin:
            return Texts::tr("%1 does not have this input or output.").arg(module);
        case Kind::NotAnInput:
            return Texts::tr("This pin of %1 is set as an output.").arg(module);
        case Kind::NotAnOutput:
            return notAnOutput(module);
        case Kind::OutputsUnknown:
            return outputsUnknown(module);
        case Kind::Unreachable:
            return Texts::tr("A run from the top never gets here: an earlier row repeats forever.");
        case Kind::NotThere:
            return name.isEmpty()
                       ? Texts::tr("At this row, %1 must be at home. Move it there first.").arg(module)
                       : Texts::tr("At this row, %1 must be at point \"%2\". Move it there first.")
                             .arg(module, name);
        case Kind::NotSet:
            return Texts::tr("At this row, output %1 of %2 must be in the opposite state. Set it first.")
                .arg(problem.output)
                .arg(module);
    }
    return {};
}

/// The pins of a motor's module are active or not; those of a PIC-I/O are high or low, as in the row.
QString inputTimeout(const action::WaitForInput& wait) {
    return (ioPin(wait.pin) ? wait.active ? Texts::tr("%1 of %2 did not become high within %3 s.")
                                          : Texts::tr("%1 of %2 did not become low within %3 s.")
            : wait.active ? Texts::tr("%1 of %2 did not become active within %3 s.")
                            : Texts::tr("%1 of %2 did not become inactive within %3 s."))
        .arg(pinWord(wait.pin), moduleName(wait.module), readout(wait.timeout));
}

QString analogTimeout(const action::WaitForAnalog& wait) {
    return (wait.above ? Texts::tr("A/D %1 of %2 did not rise above %3 of 255 within %4 s.")
                       : Texts::tr("A/D %1 of %2 did not fall below %3 of 255 within %4 s."))
        .arg(QString::number(wait.input), moduleName(wait.module), QString::number(wait.level),
             readout(wait.timeout));
}

QString why(const SequenceReport& report) {
    const QString module = report.module ? moduleName(*report.module) : QString();
    switch (*report.end) {
        case SequenceEnd::ByUser:
            return Texts::tr("You stopped it.");
        case SequenceEnd::StopOfAll:
            return Texts::tr("All motors were stopped.");
        case SequenceEnd::TakenOver:
            return Texts::tr("%1 received another command, or something else moved it.").arg(module);
        case SequenceEnd::LimitClosed:
            return Texts::tr("A limit switch of %1 closed during the move.").arg(module);
        case SequenceEnd::NotArrived:
            return Texts::tr("%1 stopped before it reached its goal.").arg(module);
        case SequenceEnd::NotSettled:
            return Texts::
                tr("%1 did not stay within its arrival tolerance. Check its gains, or change the tolerance (Axis page).")
                    .arg(module);
        case SequenceEnd::WentOff:
            return Texts::tr("The motor of %1 switched off.").arg(module);
        case SequenceEnd::Refused:
            return Common::tr("%1: %2").arg(module, refusal(*report.refusal));
        case SequenceEnd::InputTimeout:
            return inputTimeout(std::get<action::WaitForInput>(*report.awaited));
        case SequenceEnd::AnalogTimeout:
            return analogTimeout(std::get<action::WaitForAnalog>(*report.awaited));
        case SequenceEnd::NotHomed:
            return Texts::tr("%1 did not find home.").arg(module);
        case SequenceEnd::TaughtElsewhere:
            return mayHaveShifted(module, report.taught);
        case SequenceEnd::NotAnOutput:
            return notAnOutput(module);
        case SequenceEnd::OutputsUnknown:
            return outputsUnknown(module);
        case SequenceEnd::Closed:
        case SequenceEnd::LinkInDoubt:
            return Texts::tr("The link was unreliable.");
        case SequenceEnd::Unresponsive:
            return Texts::tr("%1 does not answer.").arg(module);
        case SequenceEnd::NotExecuted:
            return Texts::tr("%1 refused or did not answer a command.").arg(module);
    }
    return {};
}

/// "Main, row 3", or "Main, row 3 › Pick, row 1" with the sequences that were called.
QString runPlace(const SequenceReport& report) {
    QStringList parts;
    for (const RowPlace& place : report.places) {
        QString part = Texts::tr("%1, row %2")
                           .arg(QString::fromStdString(place.sequence), QString::number(place.row + 1));
        for (const auto& [row, rounds] : place.rounds)
            part = Texts::tr("%1, pass %2").arg(part, QString::number(rounds + 1));
        parts << part;
    }
    return parts.join(u" › "_s);
}

/// The name of a run, which must have a point or a place.
QString runName(const SequenceReport& report) {
    if (!report.point.empty())
        return Texts::tr("Move to \"%1\"").arg(QString::fromStdString(report.point));
    if (report.places.front().sequence == kHomeAll)
        return Common::tr("Home all");
    return Texts::tr("Sequence \"%1\"").arg(QString::fromStdString(report.places.front().sequence));
}

bool hasRows(const SequenceReport& report) {
    return report.point.empty() && report.places.front().sequence != kHomeAll;
}

QString axisLine(const DryRun::Axis& axis, const AxisScale& scale) {
    const auto [lowest, highest] = scale.ordered(axis.lowest, axis.highest);
    return Texts::tr("%1: %2 to %3, %4 in all, moves: %5")
        .arg(moduleName(axis.module), position(scale, lowest), position(scale, highest),
             distance(scale, axis.travelled), QString::number(axis.moves));
}

}  // namespace

QString actionWord(std::size_t action) {
    static const std::array<const char*, std::variant_size_v<Action>> kWords{
        QT_TRANSLATE_NOOP("Texts", "move to"),          QT_TRANSLATE_NOOP("Texts", "wait"),
        QT_TRANSLATE_NOOP("Texts", "wait for arrival"), QT_TRANSLATE_NOOP("Texts", "wait for input"),
        QT_TRANSLATE_NOOP("Texts", "set output"),       QT_TRANSLATE_NOOP("Texts", "find home"),
        QT_TRANSLATE_NOOP("Texts", "repeat"),           QT_TRANSLATE_NOOP("Texts", "call"),
        QT_TRANSLATE_NOOP("Texts", "wait for A/D")};
    return Texts::tr(kWords.at(action));
}

QString pinWord(InputPin pin) {
    if (const auto io = ioPin(pin))
        return u"IO%1"_s.arg(*io + 1);
    // In the order of InputPin.
    const std::array others{Common::tr("limit 1"), Common::tr("limit 2"), u"IN1"_s, u"IN2"_s,
                            Texts::tr("home switch")};
    return others.at(static_cast<std::size_t>(pin));
}

QString placesOf(const Point& point, const ScaleOfAxis& scale) {
    QStringList places;
    for (const PointAxis& axis : point.axes) {
        const QString place = position(scale(axis.module), axis.counts);
        places << (axis.fromHome ? Texts::tr("%1: %2 from home") : Texts::tr("%1: at %2, home unknown"))
                      .arg(moduleName(axis.module), place);
    }
    return places.join(u"; "_s);
}

QString sequenceProblem(const SequenceProblem& problem) {
    using Kind = SequenceProblem::Kind;
    const bool hasRow = !problem.ofPoint && problem.kind != Kind::NoRows && !problem.sequence.empty() &&
                        problem.sequence.front() != '\n' &&
                        !(problem.kind == Kind::Refused && !problem.module);
    if (!hasRow)
        return wrong(problem);
    return Texts::tr("%1, row %2: %3")
        .arg(QString::fromStdString(problem.sequence), QString::number(problem.row + 1), wrong(problem));
}

QString sequenceState(const SequenceReport& report) {
    const QString where = hasRows(report) ? runPlace(report) : runName(report);
    switch (report.stage) {
        case SequenceStage::Running:
            return Texts::tr("Running: %1").arg(where);
        case SequenceStage::Pausing:
            return Texts::tr("Finishing its row, then pausing: %1").arg(where);
        case SequenceStage::Paused:
            return Texts::tr("Paused before: %1").arg(where);
        case SequenceStage::Stopping:
            return Texts::tr("Stopping: %1").arg(where);
        case SequenceStage::Done:
            return Texts::tr("Done: %1").arg(runName(report));
        case SequenceStage::Over:
            return Texts::tr("Ended: %1. %2").arg(where, why(report));
    }
    return {};
}

std::optional<Message> sequenceOver(const SequenceReport& report) {
    // The user has ended it, or the message about the connection says what became of the motors.
    if (!report.over() || report.end == SequenceEnd::ByUser || report.end == SequenceEnd::StopOfAll ||
        report.end == SequenceEnd::Closed)
        return std::nullopt;
    Message message{.key = u"sequence"_s, .headline = Texts::tr("%1 is done.").arg(runName(report))};
    if (!report.end)
        return message;
    message.module = report.module;
    message.severity = Severity::Attention;
    message.headline = Texts::tr("%1 ended, and its motors were commanded to stop.").arg(runName(report));
    message.body = why(report);
    if (hasRows(report))
        message.body +=
            u' ' +
            Texts::tr(
                "It was at: %1. To continue, select a row and choose Run from row. Nothing restarts on its own.")
                .arg(runPlace(report));
    return message;
}

Message sequenceNotBegun(const SequenceProblem& problem) {
    return {.key = u"sequence"_s,
            .module = problem.module,
            .severity = Severity::Attention,
            .headline = Texts::tr("Nothing was started."),
            .body = sequenceProblem(problem)};
}

QString foreseen(const DryRun& dryRun, const ScaleOfAxis& scale) {
    QStringList lines;
    if (!dryRun.problems.empty()) {
        lines << Texts::tr("Dry run: the sequence would not start.");
        for (const SequenceProblem& problem : dryRun.problems)
            lines << sequenceProblem(problem);
        return lines.join(u'\n');
    }
    if (dryRun.report.places.empty())
        return Texts::tr("Dry run: the simulation was not ready. Try again.");
    if (dryRun.leftOff)
        return Texts::tr("Dry run: %1 cannot be simulated. %2")
            .arg(moduleName(*dryRun.report.module), refusal(*dryRun.leftOff));
    const QString seconds = readout(dryRun.seconds, 3);
    if (dryRun.tooLong)
        lines << Texts::tr("Dry run: cut off after %1 s.").arg(seconds);
    else if (dryRun.done())
        lines << Texts::tr("Dry run: done after %1 s.").arg(seconds);
    else
        lines << Texts::tr("Dry run: it would end after %1 s. %2").arg(seconds, sequenceState(dryRun.report));
    for (const DryRun::Axis& axis : dryRun.axes)
        lines << axisLine(axis, scale(axis.module));
    if (!dryRun.homeAssumed.empty())
        lines << Texts::tr("Homing takes longer in reality: %1.").arg(listOfModules(dryRun.homeAssumed));
    if (dryRun.inputsAssumed)
        lines << Texts::tr("Inputs were assumed to change at once.");
    if (dryRun.onceOnly)
        lines << Texts::tr("An endless repeat ran once.");
    lines << Texts::tr("Simulated motors were used; real motors may take longer.");
    return lines.join(u'\n');
}

}  // namespace nmc::texts
