// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/sequencetexts.h"

#include <QStringList>
#include <array>

#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

using Kind = SequenceProblem::Kind;

/// What is wrong, without the row.
QString wrong(const SequenceProblem& problem) {
    const QString name = QString::fromStdString(problem.name);
    const QString module = problem.module ? moduleName(*problem.module) : QString();
    switch (problem.kind) {
        case Kind::NoName:
            return Texts::tr("It has no name.");
        case Kind::NameTwice:
            return Texts::tr("The name \"%1\" is taken already.").arg(name);
        case Kind::AxisTwice:
            return Texts::tr("%1 is in point \"%2\" twice.").arg(module, name);
        case Kind::NoSuchPoint:
            return Texts::tr("There is no point \"%1\".").arg(name);
        case Kind::NoSuchSequence:
            return Texts::tr("There is no sequence \"%1\".").arg(name);
        case Kind::CallsItself:
            return Texts::tr("The sequence \"%1\" would call itself and never end.").arg(name);
        case Kind::RepeatsBelow:
            return Texts::tr("A repeat goes back to a row above it.");
        case Kind::NoRows:
            return Texts::tr("The sequence has no rows.");
        case Kind::NoAxes:
            return Texts::tr("Point \"%1\" has no axes. Teach it again.").arg(name);
        case Kind::NoSuchModule:
            return Texts::tr("%1 is not in the chain.").arg(module);
        case Kind::Refused:
            return problem.module ? Texts::tr("%1: %2").arg(module, refusal(*problem.refusal))
                                  : refusal(*problem.refusal);
        case Kind::TaughtElsewhere:
            return Texts::
                tr("%1 was taught in point \"%2\" before its home was known, so the place may be another one now. Teach it again.")
                    .arg(module, name);
        case Kind::NoRecipe:
            return Texts::tr("%1 has not been told how to find its home. See its page Homing.").arg(module);
        case Kind::NoSuchPin:
            return Texts::tr("%1 does not have this input or output.").arg(module);
        case Kind::NotAnInput:
            return Texts::tr("This limit pin of %1 is an output, so it tells nothing.").arg(module);
        case Kind::NotAnOutput:
            return Texts::tr("This limit pin of %1 is not known to be an output. See its page I/O.")
                .arg(module);
        case Kind::OutputsUnknown:
            return Texts::tr("The outputs of %1 are not known. Set them once on its page I/O.").arg(module);
        case Kind::Unreachable:
            return Texts::tr("A run from the top never comes here: a repeat for ever stands above.");
        case Kind::NotThere:
            return name.isEmpty()
                       ? Texts::tr("A run from the top would have %1 at its home here. Move it there first.")
                             .arg(module)
                       : Texts::tr(
                             "A run from the top would have %1 at point \"%2\" here. Move it there first.")
                             .arg(module, name);
        case Kind::NotSet:
            return Texts::tr(
                       "A run from the top would have set output %1 of %2 otherwise here. Set it first.")
                .arg(problem.output)
                .arg(module);
    }
    return {};
}

QString why(const SequenceReport& report) {
    const QString module = report.module ? moduleName(*report.module) : QString();
    switch (*report.end) {
        case SequenceEnd::ByUser:
            return Texts::tr("You have stopped it.");
        case SequenceEnd::StopOfAll:
            return Texts::tr("All motors were stopped.");
        case SequenceEnd::TakenOver:
            return Texts::tr("%1 was told something else, or was moved by somebody else.").arg(module);
        case SequenceEnd::LimitClosed:
            return Texts::tr("A limit switch of %1 closed on the way.").arg(module);
        case SequenceEnd::NotArrived:
            return Texts::tr("%1 stopped before it was there.").arg(module);
        case SequenceEnd::WentOff:
            return Texts::tr("The motor of %1 went off.").arg(module);
        case SequenceEnd::Refused:
            return Texts::tr("%1: %2").arg(module, refusal(*report.refusal));
        case SequenceEnd::InputTimeout:
            return Texts::tr("The input of %1 that it waited for did not come in time.").arg(module);
        case SequenceEnd::NotHomed:
            return Texts::tr("%1 has not found its home.").arg(module);
        case SequenceEnd::LinkInDoubt:
            return Texts::tr("The link was in doubt.");
        case SequenceEnd::Silent:
            return Texts::tr("%1 does not answer.").arg(module);
        case SequenceEnd::NotCarriedOut:
            return Texts::tr("A command to %1 was refused or not answered.").arg(module);
    }
    return {};
}

/// "Main, row 3", "Main, row 3, Pick, row 1": with those that were called.
QString placeOf(const SequenceReport& report) {
    QStringList parts;
    for (const SequenceReport::Place& place : report.places) {
        QString part = Texts::tr("%1, row %2").arg(QString::fromStdString(place.sequence)).arg(place.row + 1);
        for (const auto& [row, rounds] : place.rounds)
            part = Texts::tr("%1, round %2").arg(part).arg(rounds + 1);
        parts << part;
    }
    return parts.join(u" › "_s);
}

/// Of a run that has a name.
QString nameOf(const SequenceReport& report) {
    if (!report.point.empty())
        return Texts::tr("Move to \"%1\"").arg(QString::fromStdString(report.point));
    if (report.places.front().sequence == kHomeAll)
        return Texts::tr("Home all");
    return Texts::tr("Sequence \"%1\"").arg(QString::fromStdString(report.places.front().sequence));
}

bool hasRows(const SequenceReport& report) {
    return report.point.empty() && report.places.front().sequence != kHomeAll;
}

QString axisLine(const DryRun::Axis& axis, const AxisScale& scale) {
    return Texts::tr("%1: %2 to %3, %4 in all, moves: %5")
        .arg(moduleName(axis.module), position(scale, axis.lowest), position(scale, axis.highest),
             position(scale, axis.way))
        .arg(axis.moves);
}

}  // namespace

QString actionWord(std::size_t action) {
    static const std::array<const char*, std::variant_size_v<Action>> kWords{
        QT_TRANSLATE_NOOP("Texts", "move to"),          QT_TRANSLATE_NOOP("Texts", "wait"),
        QT_TRANSLATE_NOOP("Texts", "wait for arrival"), QT_TRANSLATE_NOOP("Texts", "wait for input"),
        QT_TRANSLATE_NOOP("Texts", "set output"),       QT_TRANSLATE_NOOP("Texts", "find home"),
        QT_TRANSLATE_NOOP("Texts", "repeat"),           QT_TRANSLATE_NOOP("Texts", "call")};
    return Texts::tr(kWords.at(action));
}

QString pinWord(InputPin pin) {
    switch (pin) {
        case InputPin::Limit1:
            return Texts::tr("limit 1");
        case InputPin::Limit2:
            return Texts::tr("limit 2");
        case InputPin::In1:
            return u"IN1"_s;
        case InputPin::In2:
            return u"IN2"_s;
        case InputPin::HomeSwitch:
            return Texts::tr("home switch");
    }
    return {};
}

QString placesOf(const Point& point, const ScaleOfAxis& scale) {
    QStringList places;
    for (const PointAxis& axis : point.axes) {
        const QString place = position(scale(axis.module), axis.counts);
        places << (axis.fromHome ? Texts::tr("%1: %2 from home") : Texts::tr("%1: at %2, home not known"))
                      .arg(moduleName(axis.module), place);
    }
    return places.join(u"; "_s);
}

QString sequenceProblem(const SequenceProblem& problem) {
    const bool hasRow = !problem.ofPoint && problem.kind != Kind::NoRows && !problem.sequence.empty() &&
                        problem.sequence.front() != '\n' &&
                        !(problem.kind == Kind::Refused && !problem.module);
    if (!hasRow)
        return wrong(problem);
    return Texts::tr("%1, row %2: %3")
        .arg(QString::fromStdString(problem.sequence))
        .arg(problem.row + 1)
        .arg(wrong(problem));
}

QString sequenceState(const SequenceReport& report) {
    const QString where = hasRows(report) ? placeOf(report) : nameOf(report);
    switch (report.stage) {
        case SequenceStage::Running:
            return Texts::tr("Runs: %1").arg(where);
        case SequenceStage::Pausing:
            return Texts::tr("Finishes its row, then pauses: %1").arg(where);
        case SequenceStage::Paused:
            return Texts::tr("Paused before: %1").arg(where);
        case SequenceStage::Stopping:
            return Texts::tr("Stopping: %1").arg(where);
        case SequenceStage::Done:
            return Texts::tr("Done: %1").arg(nameOf(report));
        case SequenceStage::Over:
            return (isDoubt(*report.end) ? Texts::tr("Paused by a doubt, motors stopped: %1. %2")
                                         : Texts::tr("Over: %1. %2"))
                .arg(where, why(report));
    }
    return {};
}

std::optional<Message> sequenceOver(const SequenceReport& report) {
    if (!report.over() || report.end == SequenceEnd::ByUser || report.end == SequenceEnd::StopOfAll)
        return std::nullopt;
    Message message{.key = u"sequence"_s, .headline = Texts::tr("%1 is done.").arg(nameOf(report))};
    if (!report.end)
        return message;
    message.module = report.module;
    message.severity = Severity::Attention;
    message.headline = (isDoubt(*report.end) ? Texts::tr("%1 paused, and its motors were told to stop.")
                                             : Texts::tr("%1 has ended, and its motors were told to stop."))
                           .arg(nameOf(report));
    message.body = why(report);
    if (hasRows(report))
        message.body +=
            u' ' +
            Texts::tr(
                "It was at: %1. Nothing moves again by itself; choose the row to go on from, and run from there.")
                .arg(placeOf(report));
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
        lines << Texts::tr("Dry run: it would not be started.");
        for (const SequenceProblem& problem : dryRun.problems)
            lines << sequenceProblem(problem);
        return lines.join(u'\n');
    }
    if (dryRun.report.places.empty())
        return Texts::tr("Dry run: the simulated copy was not ready. Try again.");
    const QString seconds = readout(dryRun.seconds, 3);
    if (dryRun.tooLong)
        lines
            << Texts::tr("Dry run: it takes longer than %1 s and was not followed any farther.").arg(seconds);
    else if (dryRun.done())
        lines << Texts::tr("Dry run: done after %1 s.").arg(seconds);
    else
        lines << Texts::tr("Dry run: it would end after %1 s. %2").arg(seconds, sequenceState(dryRun.report));
    for (const DryRun::Axis& axis : dryRun.axes)
        lines << axisLine(axis, scale(axis.module));
    if (!dryRun.homeAssumed.empty())
        lines << Texts::tr("Searches for home take longer than here: %1.")
                     .arg(listOfModules(dryRun.homeAssumed));
    if (dryRun.inputsAssumed)
        lines << Texts::tr("Inputs came at once here.");
    if (dryRun.onceOnly)
        lines << Texts::tr("A repeat for ever was done once.");
    lines << Texts::tr("The motors were the simulator's; yours may take longer.");
    return lines.join(u'\n');
}

}  // namespace nmc::texts
