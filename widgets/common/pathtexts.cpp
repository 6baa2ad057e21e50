// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/pathtexts.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "bus/path.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

AxisScale scaleIn(const std::vector<PathColumn>& axes, const std::string& name) {
    const auto found = std::ranges::find(axes, name, &PathColumn::name);
    return found != axes.end() ? found->scale : AxisScale();
}

QString percent(double share) {
    return QString::number(std::lround(share * 100.0));
}

/// The problem as a sentence, without its line number.
QString sentence(const PathProblem& problem, const AxisScale& scale) {
    using enum PathProblem::Kind;
    const QString text = QString::fromStdString(problem.text);
    switch (problem.kind) {
        case Rate:
            return Texts::tr("The rate \"%1\" does not exist. Use 30, 60 or 120.").arg(text);
        case NoColumns:
            return Texts::tr("The file has no line that names its axes.");
        case UnknownColumn:
            return Texts::tr("\"%1\" is not an axis that can follow a path.").arg(text);
        case ColumnTwice:
            return Texts::tr("This axis is named twice.");
        case Gap:
            return Texts::tr("A position is missing.");
        case CellCount:
            return Texts::tr("The line has %1 positions; the file has %2 axes.")
                .arg(readout(problem.value, 9), readout(problem.allowed, 9));
        case NotANumber:
            return Texts::tr("\"%1\" is not a number.").arg(text);
        case OutOfRange:
            return Texts::tr("\"%1\" is outside the module's position range.").arg(text);
        case Jump:
            return Texts::tr("The point is %1 from the previous one; at this rate the maximum is %2.")
                .arg(distance(scale, problem.value), distance(scale, problem.allowed));
        case TooFast:
            return Texts::tr("This needs a velocity of %1; the limit of the axis is %2.")
                .arg(velocity(scale, problem.value), velocity(scale, problem.allowed));
        case BeyondTravel:
            return Texts::tr("%1 is beyond the travel limit of %2.")
                .arg(position(scale, problem.value), position(scale, problem.allowed));
        case TooFewPoints:
            return Texts::tr("A path needs at least two points.");
        case TooManyPoints:
            return Texts::tr("A path has at most %1 points.").arg(grouped(kMaxPathPoints));
    }
    return {};
}

}  // namespace

QString pathProblem(const PathProblem& problem, const std::vector<PathColumn>& axes) {
    const QString said = sentence(problem, scaleIn(axes, problem.column));
    const QString line = grouped(static_cast<qint64>(problem.line));
    if (problem.line == 0)
        return said;
    if (problem.column.empty())
        return Texts::tr("Line %1: %2").arg(line, said);
    return Texts::tr("Line %1, %2: %3").arg(line, QString::fromStdString(problem.column), said);
}

QString pathObstacle(const PathObstacle& obstacle, servo::PathRate rate, const ScaleOfAxis& scaleOf) {
    using enum PathObstacle::Kind;
    const QString who = obstacle.module ? moduleName(*obstacle.module) : QString();
    const AxisScale scale = obstacle.module ? scaleOf(*obstacle.module) : AxisScale();
    const QString point = grouped(static_cast<qint64>(obstacle.point));
    switch (obstacle.kind) {
        case Refused:
            return Common::tr("%1: %2").arg(who,
                                            refusal(obstacle.refusal.value_or(Refusal::PathNotPossible)));
        case NoPathBuffer:
            return Texts::tr("%1 has no path buffer. Only a PIC-SERVO CMC or SC can follow a path.").arg(who);
        case ControlUnknown:
            return Texts::
                tr("The I/O settings of %1 are unknown: another program set them. Apply them first on the Amplifier or Limits and I/O page.")
                    .arg(who);
        case StepAndDirection:
            return Texts::tr(
                       "%1 is set to step and direction input. Switch that off on its Amplifier page first.")
                .arg(who);
        case WrongFastPath:
            return (rate == servo::PathRate::Hz30
                        ? Texts::tr(
                              "%1: a path at 30 Hz needs fast path off (Amplifier or Limits and I/O page).")
                        : Texts::tr(
                              "%1: a path at 120 Hz needs fast path on (Amplifier or Limits and I/O page)."))
                .arg(who);
        case ServoRate:
            return Texts::tr("%1: a path needs a servo rate divisor of 1. Apply the gains with SR = 1 first.")
                .arg(who);
        case PlaceUnknown:
            return Texts::tr("%1 has not reported its command position yet.").arg(who);
        case TooFarToStart:
            return Texts::tr("%1 is %2 from the first point. Choose Move to start first.")
                .arg(who, distance(scale, obstacle.value));
        case Jump:
            return Texts::tr("%1: point %2 is %3 from the previous one; at this rate the maximum is %4.")
                .arg(who, point, distance(scale, obstacle.value), distance(scale, obstacle.allowed));
        case TooFast:
            return Texts::tr("%1: point %2 needs a velocity of %3; the limit of the axis is %4.")
                .arg(who, point, velocity(scale, obstacle.value), velocity(scale, obstacle.allowed));
        case BeyondTravel:
            return Texts::tr("%1: point %2 at %3 is beyond the travel limit of %4.")
                .arg(who, point, position(scale, obstacle.value), position(scale, obstacle.allowed));
        case NoPoints:
            return Texts::tr("The path does not fit this chain. Open it again.");
        case NotAGroup:
            return Texts::tr(
                "The axes of a path start together. Put them, and no other module, into one group: Chain, Groups.");
        case BusTooSlow:
            return Texts::
                tr("The path needs %1 % of the bus time; %2 % is available. Use a higher baud rate or a lower path rate.")
                    .arg(percent(obstacle.value), percent(obstacle.allowed));
    }
    return {};
}

QString drawingProblem(const DrawingProblem& problem) {
    using enum DrawingProblem::Kind;
    const auto atRow = [&problem](const QString& said) {
        return Texts::tr("%1, row %2: %3")
            .arg(QString::fromStdString(problem.sequence), grouped(static_cast<qint64>(problem.row) + 1),
                 said);
    };
    const QString who = problem.module ? moduleName(*problem.module) : QString();
    switch (problem.kind) {
        case NoPathAxis:
            return Texts::tr("%1 cannot follow a path. Only a PIC-SERVO CMC or SC can.").arg(who);
        case PlaceUnknown:
            return Texts::
                tr("%1 does not hold a known position. Enable its servo, and find home if the points count from home.")
                    .arg(who);
        case NotDrawn:
            return atRow(Texts::tr("Only moves, waits, repeats and calls can become a path."));
        case Endless:
            return atRow(Texts::tr("A path cannot repeat forever."));
        case TooManyPoints:
            return atRow(Texts::tr("Up to here the path would have more than %1 points.")
                             .arg(grouped(kMaxPathPoints)));
        case NoMove:
            return Texts::tr("The sequence \"%1\" moves nothing.")
                .arg(QString::fromStdString(problem.sequence));
    }
    return {};
}

QString pathNotRead(const FileError& error) {
    return Texts::tr("Could not open \"%1\". %2").arg(QFileInfo(error.path).fileName(), fileProblem(error));
}

QString pathFailure(ProcedureFailure failure) {
    if (failure != ProcedureFailure::StoppedShort)
        return procedureFailure(failure);
    return Texts::tr(
        "A module ended the path by itself: a limit switch, a position error, or no motor power. All axes of the path were commanded to stop.");
}

QString pathState(const ProcedureReport& report) {
    if (report.over()) {
        if (report.stage == ProcedureStage::Done)
            return Texts::tr("The path is done. Each axis holds its last point.");
        if (report.stage == ProcedureStage::Cancelled)
            return Texts::tr("The path was stopped.");
        return report.failure ? pathFailure(*report.failure) : QString();
    }
    if (!report.path)
        return Texts::tr("Starting the path");
    const bus::PathProgress& path = *report.path;
    const QString state =
        Texts::tr("Point %1 of %2, %3 s left, %4 points left in the buffer")
            .arg(grouped(static_cast<qint64>(path.done)), grouped(static_cast<qint64>(path.points())),
                 fixed(toSeconds(path.remaining()), 1), grouped(static_cast<qint64>(path.left)));
    return path.runsDry ? Texts::tr("%1. The buffer is about to run dry: the bus is too slow.").arg(state)
                        : state;
}

QString pathReach(const PathTable::Column& column, const PathColumn& axis) {
    const auto reach = std::ranges::minmax(column.points);
    const auto [least, most] = axis.scale.ordered(reach.min, reach.max);
    return Texts::tr("%1 from %2 to %3")
        .arg(QString::fromStdString(axis.name), position(axis.scale, least), position(axis.scale, most));
}

QString pathLength(const PathTable& table) {
    const auto points = static_cast<qint64>(table.columns.front().points.size());
    const double seconds = toSeconds(bus::pathPeriod(table.rate)) * static_cast<double>(points);
    return Texts::tr("%1 points at %2 Hz, %3 s")
        .arg(grouped(points), QString::number(servo::nominalHertz(table.rate)), fixed(seconds, 1));
}

}  // namespace nmc::texts
