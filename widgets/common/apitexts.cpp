// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/apitexts.h"

#include "widgets/common/textparts.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {
/// Messages about one program replace one another.
[[nodiscard]] Message aboutProgram(const QString& program, const QString& headline) {
    return {.key = u"program/"_s + program, .headline = headline, .relation = Message::Relation::Update};
}

/// Numbers as nmcctl and other programs write them, exact enough to be taken if they are typed.
[[nodiscard]] QString outOfRange(const QString& field, const api::NumberRange& range) {
    const auto number = [](double value) { return QString::number(value, 'g', 10); };
    const QString highest = (number(range.max) + u' ' + QString::fromStdString(range.unit)).trimmed();
    return (range.isJogged
                ? Texts::tr(
                      "The parameter \"%1\" must be from %2 to %3 here, in either direction. %3 is the max jog speed of the axis.")
                : Texts::tr("The parameter \"%1\" must be from %2 to %3 here."))
        .arg(field, number(range.min), highest);
}
}  // namespace

QString apiProblem(const api::Problem& problem) {
    using enum api::Problem::Kind;
    const QString field = QString::fromStdString(problem.field);
    switch (problem.kind) {
        case NotJson:
            return Texts::tr("This line is not JSON.");
        case InvalidRequest:
            return Texts::tr("A request is an object with method, params (an object) and id.");
        case NoMethod:
            return Texts::tr("There is no such method.");
        case FieldMissing:
            return (field.contains(u',') ? Texts::tr("These parameters are missing: %1.")
                                         : Texts::tr("The parameter \"%1\" is missing."))
                .arg(field);
        case FieldWrong:
            if (problem.range)
                return outOfRange(field, *problem.range);
            return Texts::tr("The parameter \"%1\" has the wrong type, or is out of its range.").arg(field);
        case AxisUnknown:
            return Texts::tr("There is no such axis.");
        case AxisAmbiguous:
            return Texts::tr(
                "Several axes have this name. Use the number of the axis, or give each its own name.");
        case SequenceUnknown:
            return Texts::tr("There is no sequence or point of that name.");
        case NotAnOutput:
            return Texts::tr("This pin is not set as an output. Make it an output first.");
        case OutputsUnknown:
            return Texts::tr(
                "The outputs of this module, or their directions, are unknown. Set them once first.");
        case Refused:
            return refusal(problem.refusal.value());
    }
    return {};
}

QString noControl() {
    return Texts::tr("This program may not move motors now: call request_control first.");
}

QString helloFirst() {
    return Texts::tr("Call hello first.");
}

QString otherProtocol(const QString& theirs, const QString& ours) {
    return Texts::tr("This panel speaks version %1 of the protocol, and the program version %2.")
        .arg(ours, theirs);
}

QString wasCancelled() {
    return Texts::tr("It was cancelled by a stop or by another command.");
}

QString didNotSettle() {
    return Texts::tr("The motor did not stay within the arrival tolerance of its axis.");
}

QString controlLost(ControlLost why) {
    switch (why) {
        case ControlLost::Stopped:
            return Texts::tr("Motors were stopped.");
        case ControlLost::TakenBack:
            return Texts::tr("The user has taken control back.");
        case ControlLost::Commanded:
            return Texts::tr("The user has commanded a motor.");
        case ControlLost::Disconnected:
            return Texts::tr("The chain is no longer connected.");
    }
    return {};
}

Message apiClosed(const ApiServerProblem& problem) {
    Message message{.key = u"api"_s,
                    .severity = Severity::Attention,
                    .headline = Texts::tr("Other programs cannot connect.")};
    switch (problem.kind) {
        case ApiServerProblem::Kind::InUse:
            message.body = Texts::tr("Another panel already lets programs in at %1.").arg(problem.path);
            break;
        case ApiServerProblem::Kind::NotPrivate:
            message.body =
                Texts::tr(
                    "%1 is a link, belongs to another user, or is open to others. Remove it, and try again.")
                    .arg(problem.path);
            break;
        case ApiServerProblem::Kind::System:
            message.body = Texts::tr("%1 cannot be created.").arg(problem.path);
            message.details = problem.reason;
            break;
    }
    return message;
}

Message programConnected(const QString& program) {
    return aboutProgram(
        program,
        Texts::tr(
            "Program \"%1\" has connected. It may read, stop motors and switch them off, but not move them.")
            .arg(program));
}

Message programGone(const QString& program, bool stops) {
    Message message = aboutProgram(
        program, (stops ? Texts::tr("Program \"%1\" has disconnected; the motors that it moved are stopped.")
                        : Texts::tr("Program \"%1\" has disconnected."))
                     .arg(program));
    if (stops)
        message.severity = Severity::Attention;
    return message;
}

Message programCalled(const QString& program, const QString& call) {
    return aboutProgram(program, Texts::tr("Program \"%1\": %2").arg(program, call));
}

Message lineLent(const LineLent& lent) {
    const QString path = QString::fromStdString(lent.path);
    Message message{.key = u"lent"_s, .relation = Message::Relation::Update};
    switch (lent.state) {
        case LineLent::State::Waiting:
            message.headline = Texts::tr("The line is lent at %1. No program has used it yet.").arg(path);
            break;
        case LineLent::State::InUse:
            message.headline = Texts::tr("A program has the line, at %1.").arg(path);
            break;
        case LineLent::State::HeldOff:
            message.severity = Severity::Attention;
            message.headline = Texts::tr("All motors were commanded to stop, and the program is held off.");
            message.body = Texts::tr(
                "What it sends is dropped. Release lets it continue; it does not know what it has missed.");
            break;
        case LineLent::State::Left:
            message.headline =
                Texts::tr("The program has closed %1, and the line is no longer lent.").arg(path);
            break;
        case LineLent::State::Ended:
            message.headline = Texts::tr("The line is no longer lent.");
            break;
    }
    return message;
}

Message notLent(const LendingProblem& problem) {
    const QString path = QString::fromStdString(problem.path);
    Message message{.key = u"lent"_s,
                    .severity = Severity::Attention,
                    .headline = Texts::tr("The line was not lent."),
                    .relation = Message::Relation::Update};
    switch (problem.kind) {
        case LendingProblem::Kind::NotNow:
            message.body =
                Texts::tr("The chain was busy, or a motor was moving. Stop the motors, and try again.");
            break;
        case LendingProblem::Kind::Taken:
            message.body = Texts::tr("There is something at %1 already. Choose another path.").arg(path);
            break;
        case LendingProblem::Kind::System:
            message.body =
                Texts::tr("No terminal can be made at %1. Choose a path in a folder of your own.").arg(path);
            message.details = QString::fromStdString(problem.reason);
            break;
    }
    return message;
}

QString lentTo(const LentLine& lent) {
    const QString path = QString::fromStdString(lent.path);
    return lent.heldOff ? Texts::tr("LENT at %1 — stopped; the program is held off.").arg(path)
           : lent.inUse
               ? Texts::tr(
                     "LENT at %1 — a program has the line. No travel limit or other check of the panel protects the motors; STOP ALL does.")
                     .arg(path)
               : Texts::tr("LENT at %1 — no program yet.").arg(path);
}

}  // namespace nmc::texts
