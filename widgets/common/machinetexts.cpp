// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the table of texts about machine files and saved step responses.
#include <QDir>
#include <QFileInfo>
#include <QHash>

#include "widgets/common/sharedwords.h"
#include "widgets/common/textparts.h"
#include "widgets/common/unitwords.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

QString wanted(FileProblem::Wanted wanted) {
    switch (wanted) {
        case FileProblem::Wanted::WholeNumber:
            return Texts::tr("a whole number");
        case FileProblem::Wanted::Number:
            return Texts::tr("a number");
        case FileProblem::Wanted::Text:
            return Texts::tr("text in quotation marks");
        case FileProblem::Wanted::YesOrNo:
            return Texts::tr("true or false");
        case FileProblem::Wanted::Object:
            return Texts::tr("an object in { }");
        case FileProblem::Wanted::List:
            return Texts::tr("a list in [ ]");
    }
    return {};
}

/// What is wrong in a line; follows a colon and ends with a full stop.
QString wrongInLine(const FileProblem& problem) {
    using Kind = FileProblem::Kind;
    const QString field = QString::fromStdString(problem.field);
    const QString found = QString::fromStdString(problem.found);
    switch (problem.kind) {
        case Kind::Empty:
        case Kind::TooLarge:
        case Kind::OtherFormat:
        case Kind::NewerVersion:
            return {};
        case Kind::Truncated:
            return Texts::tr("the file is incomplete.");
        case Kind::NotUtf8:
            return Texts::tr("this text is not UTF-8.");
        case Kind::NotJson:
            return Texts::tr("this is not JSON.");
        case Kind::NotANumber:
            return Texts::tr("%1 is not a number.").arg(found);
        case Kind::NumberTooBig:
            return Texts::tr("this number is too large.");
        case Kind::TooDeep:
            return Texts::tr("more than %1 levels of brackets.").arg(plainNumber(problem.max));
        case Kind::TooManyValues:
            return Texts::tr("more than %1 values.").arg(plainNumber(problem.max));
        case Kind::DuplicateKey:
            return Texts::tr("%1 appears twice.").arg(field);
        case Kind::Missing:
            return Texts::tr("%1 is missing.").arg(field);
        case Kind::WrongType:
            return Texts::tr("%1 is not %2.").arg(field, wanted(problem.wanted));
        case Kind::OutOfRange:
            return (problem.ofModule ? Texts::tr("%1 is %2; the module accepts %3 to %4.")
                                     : Texts::tr("%1 is %2; it must be %3 to %4."))
                .arg(field, found, plainNumber(problem.min), plainNumber(problem.max));
        case Kind::UnknownWord:
            return Texts::tr("%1 has the unknown value \"%2\".").arg(field, found);
        case Kind::UnprintableText:
            return Texts::tr("%1 has an unprintable character.").arg(field);
        case Kind::TooMany:
            return Texts::tr("%1 has more than %2 entries.").arg(field, plainNumber(problem.max));
        case Kind::OtherChip:
            return Texts::tr("%1 has a unit that does not fit the module of this axis.").arg(field);
        case Kind::ModuleTwice:
            return Texts::tr("module %1 is already in a group.").arg(found);
        case Kind::AddressTwice:
            return Texts::tr("another group also has address %1.").arg(found);
        case Kind::LeaderNotInGroup:
            return Texts::tr("the leader is not one of the group's modules.");
        case Kind::NameMissing:
            return Texts::tr("it has no name.");
        case Kind::NameTwice:
            return Texts::tr("the name \"%1\" is already used.").arg(found);
        case Kind::AxisTwice:
            return Texts::tr("module %1 appears twice.").arg(found);
        case Kind::NoSuchPoint:
            return Texts::tr("point \"%1\" does not exist.").arg(found);
        case Kind::NoSuchSequence:
            return Texts::tr("sequence \"%1\" does not exist.").arg(found);
        case Kind::CallsItself:
            return Texts::tr("this row makes the sequence \"%1\" call itself endlessly.").arg(found);
        case Kind::RepeatsBelow:
            return Texts::tr("a repeat must go back to an earlier row.");
        case Kind::LimitsCrossed:
            return Texts::tr("the lowest position is not below the highest.");
    }
    return {};
}

Message problemMessage(const QString& headline, const QString& body, const QString& details = {}) {
    return {.key = key::kMachineFile,
            .severity = Severity::Attention,
            .headline = headline,
            .body = body,
            .details = details};
}

/// Translates a word that the file format defines.
QString choiceWord(const std::string& word) {
    static const QHash<std::string, const char*> words{
        {"native", QT_TRANSLATE_NOOP("Texts", "counts (steps)")},
        {"turns", QT_TRANSLATE_NOOP("Texts", "turns")},
        {"degrees", QT_TRANSLATE_NOOP("Texts", "degrees")},
        {"millimetres", QT_TRANSLATE_NOOP("Texts", "millimetres")},
        {"own", QT_TRANSLATE_NOOP("Texts", "custom unit")},
        {"abruptly", QT_TRANSLATE_NOOP("Texts", "abruptly")},
        {"smoothly", QT_TRANSLATE_NOOP("Texts", "smoothly")},
        {"motor off", QT_TRANSLATE_NOOP("Texts", "motor off")}};
    const auto found = words.constFind(word);
    return found != words.cend() ? Texts::tr(*found) : QString::fromStdString(word);
}

QString commandsSent(int sent) {
    return sent == 0 ? Texts::tr("Nothing was sent.")
                     : Texts::tr("Commands sent: %1. No motor was moved.").arg(sent);
}

QString machineOrFile(const QString& machine) {
    return machine.isEmpty() ? Texts::tr("an unnamed machine") : u'"' + machine + u'"';
}

}  // namespace

QString fileProblem(const FileError& error) {
    const QString folder = QDir::toNativeSeparators(QFileInfo(error.path).absolutePath());
    switch (error.trouble) {
        case FileErrorKind::NotThere:
            return Texts::tr("There is no file %1. Check whether it was moved, or its disk is disconnected.")
                .arg(QDir::toNativeSeparators(QFileInfo(error.path).absoluteFilePath()));
        case FileErrorKind::NoFolder:
            return Texts::tr("The folder %1 does not exist. Choose another one.").arg(folder);
        case FileErrorKind::NotAFile:
            return Texts::tr("This is a folder or a device. Choose a file.");
        case FileErrorKind::NoPermission:
            return Texts::
                tr("Your user account has no permission for %1. Choose another folder, or change the permissions.")
                    .arg(folder);
        case FileErrorKind::ReadOnly:
            return Texts::tr("The disk of %1 is read-only. Choose another folder.").arg(folder);
        case FileErrorKind::NoSpace:
            return Texts::tr("The disk of %1 is full. Free some space, or choose another folder.")
                .arg(folder);
        case FileErrorKind::TooLarge:
            return Texts::tr("It is larger than any machine file. Check that it is the right file.");
        case FileErrorKind::ChangedElsewhere:
            return Texts::tr(
                "Another program has changed it since it was opened or saved here. Open it to see the changes, or save as another file; saving as the same one replaces it.");
        case FileErrorKind::Other:
            return Texts::tr("See Details for the system's message.");
    }
    return {};
}

QString machineFileName(const QString& path) {
    return path.isEmpty() ? Texts::tr("unsaved changes") : QFileInfo(path).fileName();
}

QString fileProblem(const QString& file, const FileProblem& problem) {
    using Kind = FileProblem::Kind;
    if (problem.kind == Kind::Empty)
        return Texts::tr("\"%1\" is empty.").arg(file);
    if (problem.kind == Kind::TooLarge)
        return Texts::tr("\"%1\" is larger than %2 bytes.")
            .arg(file, grouped(static_cast<qint64>(problem.max)));
    if (problem.kind == Kind::OtherFormat)
        return Texts::tr("\"%1\" is not a machine file of NMC Panel.").arg(file);
    if (problem.kind == Kind::NewerVersion)
        return Texts::
            tr("\"%1\" was written by a newer NMC Panel: its format is %2; this version reads formats up to %3.")
                .arg(file, QString::fromStdString(problem.found), plainNumber(problem.max));
    return Texts::tr("\"%1\" line %2: %3").arg(file, QString::number(problem.line), wrongInLine(problem));
}

Message machineNotOpened(const QString& file, const FileProblem& problem) {
    return problemMessage(fileProblem(machineFileName(file), problem), Texts::tr("Nothing was loaded."));
}

Message machineNotOpened(const FileError& error) {
    return problemMessage(Texts::tr("Could not open \"%1\".").arg(machineFileName(error.path)),
                          fileProblem(error), error.detail);
}

Message machineNotSaved(const FileError& error) {
    return problemMessage(
        Texts::tr("Could not save \"%1\". Its previous content is kept.").arg(machineFileName(error.path)),
        fileProblem(error), error.detail);
}

Message machineNotSaved(const QString& file, const FileProblem& problem) {
    return problemMessage(Texts::tr("Could not save \"%1\": it could not be opened again afterwards.")
                              .arg(machineFileName(file)),
                          fileProblem(machineFileName(file), problem));
}

Message machineOpened(const QString& file, int parts, int sent) {
    return {.key = key::kMachineFile + u".opened"_s,
            .headline = Texts::tr("\"%1\" is open. Settings applied: %2.")
                            .arg(machineFileName(file), QString::number(parts)),
            .body = commandsSent(sent)};
}

Message axisCopied(ModuleIndex from, int parts, int sent) {
    return {
        .key = key::kMachineFile + u".copied"_s,
        .headline = Texts::tr("Settings copied from %1: %2.").arg(moduleName(from), QString::number(parts)),
        .body = commandsSent(sent)};
}

Message machineNotApplied(int movingMotors) {
    return {
        .key = key::kNotApplied,
        .severity = Severity::Attention,
        .headline = Texts::tr("Nothing was applied."),
        .body =
            movingMotors > 0
                ? notSentWhileMoving(movingMotors)
                : Texts::tr(
                      "Modules or settings have changed since the table was shown, so it was updated. Check it, then apply again.")};
}

Message machineSame(const QString& file) {
    return {.key = key::kMachineFile + u".opened"_s,
            .headline = Texts::tr("\"%1\" is open. No differences.").arg(machineFileName(file)),
            .body = Texts::tr("Nothing was sent.")};
}

Message unsavedWorkLeft(const QString& machine) {
    return {
        .key = key::kUnsavedWork,
        .severity = Severity::Attention,
        .headline = Texts::tr("An earlier session left unsaved changes to %1.").arg(machineOrFile(machine)),
        .body = Texts::tr(
            "If modules are connected, Restore shows what would change. Nothing is sent before you choose Apply."),
        .actions = {{MessageAction::RestoreWork, Common::tr("Restore")},
                    {MessageAction::DiscardWork, Texts::tr("Discard: the changes are lost")}}};
}

Message unsavedWorkDamaged(const FileProblem& problem) {
    return {.key = key::kUnsavedWork,
            .severity = Severity::Attention,
            .headline = Texts::tr("Could not recover unsaved changes of an earlier session."),
            .body = fileProblem(machineFileName({}), problem),
            .actions = {{MessageAction::DiscardWork, Texts::tr("Discard: the changes are lost")}}};
}

Message unsavedWorkNotKept(const FileError& error) {
    Message m = problemMessage(Texts::tr("Changes to the machine are not backed up until you save them."),
                               Texts::tr("%1 is not writable.").arg(QDir::toNativeSeparators(error.path)),
                               error.detail);
    m.stands = true;
    return m;
}

QString notSaved(const QString& machine) {
    return Texts::tr("Save the changes to %1?").arg(machineOrFile(machine));
}

QString beingSaved(const QString& machine) {
    return Texts::tr("Saving %1. The window closes when it is saved.").arg(machineOrFile(machine));
}

QString machinePart(MachinePart part) {
    switch (part) {
        case MachinePart::MachineName:
            return Texts::tr("Machine");
        case MachinePart::Rate:
            return Common::tr("Baud rate");
        case MachinePart::Groups:
            return Common::tr("Groups");
        case MachinePart::OperatorRights:
            return Texts::tr("Operator permissions");
        case MachinePart::Program:
            return Common::tr("Points and sequences");
        case MachinePart::HomeOrder:
            return Texts::tr("Order of Home all");
        case MachinePart::Hardware:
            return Texts::tr("Type and version");
        case MachinePart::AxisName:
            return Common::tr("Name");
        case MachinePart::Unit:
            return Common::tr("Unit");
        case MachinePart::Motion:
            return Common::tr("Motion");
        case MachinePart::Travel:
            return Common::tr("Travel and speed limits");
        case MachinePart::Backlash:
            return Common::tr("Backlash");
        case MachinePart::Arrival:
            return Common::tr("Arrival");
        case MachinePart::Homing:
            return Common::tr("Homing");
        case MachinePart::LimitStop:
            return Common::tr("Limit stop");
        case MachinePart::WorkOffsets:
            return Common::tr("Work offsets");
        case MachinePart::Analog:
            return Texts::tr("A/D scale");
        case MachinePart::PinNames:
            return Texts::tr("Names of inputs and outputs");
        case MachinePart::AccelerationTime:
            return Common::tr("Acceleration time");
        case MachinePart::Gains:
            return Common::tr("Gains");
        case MachinePart::Io:
            return Texts::tr("Limit pins");
        case MachinePart::Parameters:
            return Common::tr("Parameters");
    }
    return {};
}

Message runsNotRead(const QString& path, const FileProblem& problem) {
    const QString file = QFileInfo(path).fileName();
    return {.key = key::kRuns,
            .severity = Severity::Attention,
            .headline = Texts::tr("Could not read the step responses of this machine."),
            .body = (problem.kind == FileProblem::Kind::OtherFormat
                         ? Texts::tr("\"%1\" is not a file of step responses.").arg(file)
                         : fileProblem(file, problem)) +
                    u' ' +
                    Texts::tr("The file is kept: before new step responses are saved, it is moved to %1.")
                        .arg(QDir::toNativeSeparators(QFileInfo(path).absolutePath()))};
}

Message runsNotRead(const FileError& error) {
    return {
        .key = key::kRuns,
        .severity = Severity::Attention,
        .headline = Texts::tr("Could not read the step responses of this machine."),
        .body = Texts::tr("\"%1\" is not readable. It is moved aside before new step responses are saved.")
                    .arg(QDir::toNativeSeparators(error.path)),
        .details = error.detail};
}

Message runsNotKept(const FileError& error) {
    return {.key = key::kRunsNotKept,
            .severity = Severity::Attention,
            .headline = Texts::tr("The step responses of this session are not saved."),
            .body = Texts::tr("%1 is not writable. Export them before you close the panel.")
                        .arg(QDir::toNativeSeparators(error.path)),
            .details = error.detail,
            .stands = true};
}

QString machineField(const QString& key, bool reversed) {
    if (reversed && (key == u"lowest"_s || key == u"highest"_s))
        return machineField(key == u"lowest"_s ? u"highest"_s : u"lowest"_s);
    static const QHash<QString, const char*> words{
        {u"name"_s, QT_TRANSLATE_NOOP("Texts", "Name")},
        {u"enable"_s, QT_TRANSLATE_NOOP("Texts", "Enable")},
        {u"jog"_s, QT_TRANSLATE_NOOP("Texts", "Jog")},
        {u"points"_s, QT_TRANSLATE_NOOP("Texts", "Points and sequences")},
        {u"moves"_s, QT_TRANSLATE_NOOP("Texts", "Moves")},
        {u"homing"_s, QT_TRANSLATE_NOOP("Texts", "Homing")},
        {u"outputs"_s, QT_TRANSLATE_NOOP("Texts", "Outputs")},
        {u"rate_bd"_s, QT_TRANSLATE_NOOP("Texts", "Baud rate, Bd")},
        {u"hardware"_s, QT_TRANSLATE_NOOP("Texts", "Type and version")},
        {u"kind"_s, QT_TRANSLATE_NOOP("Texts", "Unit")},
        {u"counts_per_unit"_s, QT_TRANSLATE_NOOP("Texts", "Counts (steps) per unit")},
        {u"symbol"_s, QT_TRANSLATE_NOOP("Texts", "Symbol")},
        {u"velocity"_s, QT_TRANSLATE_NOOP("Texts", "Velocity")},
        {u"acceleration"_s, QT_TRANSLATE_NOOP("Texts", "Acceleration")},
        {u"run_velocity"_s, QT_TRANSLATE_NOOP("Texts", "Run velocity")},
        {u"hold_velocity"_s, QT_TRANSLATE_NOOP("Texts", "Jog speed")},
        {u"hold_cap"_s, QT_TRANSLATE_NOOP("Texts", "Max jog speed")},
        {u"step"_s, QT_TRANSLATE_NOOP("Texts", "Step")},
        {u"lowest"_s, QT_TRANSLATE_NOOP("Texts", "Lowest position, from home")},
        {u"highest"_s, QT_TRANSLATE_NOOP("Texts", "Highest position, from home")},
        {u"fastest"_s, QT_TRANSLATE_NOOP("Texts", "Highest velocity")},
        {u"distance"_s, QT_TRANSLATE_NOOP("Texts", "Distance")},
        {u"tolerance"_s, QT_TRANSLATE_NOOP("Texts", "Tolerance")},
        {u"duration"_s, QT_TRANSLATE_NOOP("Texts", "Duration")},
        {u"from_above"_s, QT_TRANSLATE_NOOP("Texts", "From above")},
        {u"each_motion"_s, QT_TRANSLATE_NOOP("Texts", "Armed for each motion")},
        {u"on_limit1"_s, QT_TRANSLATE_NOOP("Texts", "On limit switch 1")},
        {u"on_limit2"_s, QT_TRANSLATE_NOOP("Texts", "On limit switch 2")},
        {u"on_index"_s, QT_TRANSLATE_NOOP("Texts", "On index")},
        {u"on_position_error"_s, QT_TRANSLATE_NOOP("Texts", "On position error")},
        {u"on_current_limit"_s, QT_TRANSLATE_NOOP("Texts", "On current limit")},
        {u"on_home_switch"_s, QT_TRANSLATE_NOOP("Texts", "On home switch")},
        {u"then_index"_s, QT_TRANSLATE_NOOP("Texts", "Then on index")},
        {u"reverse"_s, QT_TRANSLATE_NOOP("Texts", "Reverse")},
        {u"index_velocity"_s, QT_TRANSLATE_NOOP("Texts", "Index velocity")},
        {u"stop"_s, QT_TRANSLATE_NOOP("Texts", "Stop")},
        {u"travel_limit"_s, QT_TRANSLATE_NOOP("Texts", "Search distance")},
        {u"time_limit"_s, QT_TRANSLATE_NOOP("Texts", "Time limit")},
        {u"go_to_home"_s, QT_TRANSLATE_NOOP("Texts", "Go to home")},
        {u"make_zero"_s, QT_TRANSLATE_NOOP("Texts", "Set position to 0")},
        {u"per_count"_s, QT_TRANSLATE_NOOP("Texts", "Per A/D count")},
        {u"at_zero"_s, QT_TRANSLATE_NOOP("Texts", "At zero")},
        {u"unit"_s, QT_TRANSLATE_NOOP("Texts", "A/D unit")},
        {u"acceleration_time"_s, QT_TRANSLATE_NOOP("Texts", "Acceleration time")},
        {u"EL_counts"_s, QT_TRANSLATE_NOOP("Texts", "EL, counts")},
        {u"limit1_is_input"_s, QT_TRANSLATE_NOOP("Texts", "Limit 1 is an input")},
        {u"limit2_is_input"_s, QT_TRANSLATE_NOOP("Texts", "Limit 2 is an input")},
        {u"limit1_output"_s, QT_TRANSLATE_NOOP("Texts", "Limit 1 as an output")},
        {u"limit2_output"_s, QT_TRANSLATE_NOOP("Texts", "Limit 2 as an output")},
        {u"SM"_s, QT_TRANSLATE_NOOP("Texts", "SM, step multiplier")},
        {u"fast_path"_s, QT_TRANSLATE_NOOP("Texts", "Fast path")},
        {u"sc_fast_path"_s, QT_TRANSLATE_NOOP("Texts", "Fast path")},
        {u"speed_mode"_s, QT_TRANSLATE_NOOP("Texts", "Speed mode")},
        {u"minimum_profile_speed"_s, QT_TRANSLATE_NOOP("Texts", "Minimum profile speed")},
        {u"run_current"_s, QT_TRANSLATE_NOOP("Texts", "Run current")},
        {u"hold_current"_s, QT_TRANSLATE_NOOP("Texts", "Hold current")},
        {u"thermal_limit"_s, QT_TRANSLATE_NOOP("Texts", "Thermal limit")},
        {u"ignore_limits"_s, QT_TRANSLATE_NOOP("Texts", "Ignore limit switches")},
        {u"ignore_estop"_s, QT_TRANSLATE_NOOP("Texts", "Ignore E-stop input")},
        {u"motor_off_on_limit_or_estop"_s, QT_TRANSLATE_NOOP("Texts", "Motor off on limit or E-stop input")}};
    if (const auto found = words.constFind(key); found != words.cend())
        return Texts::tr(*found);
    if (key.startsWith(u"group"_s))
        return Common::tr("Group %1").arg(QString::number(key.mid(5).toInt(), 16).toUpper());
    if (key.startsWith(u"leader"_s))
        return Texts::tr("Leader of group %1").arg(QString::number(key.mid(6).toInt(), 16).toUpper());
    if (key.startsWith(u"offset "_s))
        return Texts::tr("\"%1\", from home").arg(key.mid(7));
    if (key.startsWith(u"point "_s))
        return Texts::tr("Point %1").arg(key.mid(6));
    if (key.startsWith(u"sequence "_s))
        return Texts::tr("Sequence %1").arg(key.mid(9));
    if (key == u"home_order"_s)
        return Texts::tr("Order of Home all");
    if (key.startsWith(u"output"_s))
        return Texts::tr("Output %1").arg(key.mid(6));
    if (key.startsWith(u"input"_s))
        return Texts::tr("Input %1").arg(key.mid(5));
    return key;  // Kp, Kd and the like have the same name everywhere
}

QString machineValue(const FieldDifference& field, const std::optional<FieldValue>& value,
                     const AxisScale& scale, const QString& unknown) {
    if (!value)
        return unknown;
    const bool way = scale.reversed() && (field.key == "reverse" || field.key == "from_above");
    if (const auto* flag = std::get_if<bool>(&*value))
        return *flag != way ? Texts::tr("yes") : Texts::tr("no");
    if (const auto* text = std::get_if<std::string>(&*value))
        return field.key == "kind" || field.key == "stop" ? choiceWord(*text) : QString::fromStdString(*text);
    const double number = std::get<double>(*value);
    switch (field.quantity) {
        case Quantity::Plain:
            return readout(number, 6);
        case Quantity::Distance:
            return distance(scale, number);
        case Quantity::Place:
            return position(scale, number);
        case Quantity::Velocity:
            return velocity(scale, number);
        case Quantity::Acceleration:
            return acceleration(scale, number);
        case Quantity::Seconds:
            return Texts::tr("%1 s").arg(readout(number));
    }
    return {};
}

QString machineApplying(const Difference& difference) {
    switch (difference.applying) {
        case Applying::ChangesPanel:
            return difference.id.part == MachinePart::Hardware
                       ? Texts::tr(
                             "Another type of module: if any of this axis is applied, the rest is reset.")
                       : Texts::tr("Changes only the panel; nothing is sent.");
        case Applying::Sends:
            return Texts::tr("Sent to the module.");
        case Applying::KeepsUnsent:
            return difference.refusal ? Texts::tr("Filled in, not sent: %1").arg(refusal(*difference.refusal))
                                      : Texts::tr("Filled in, not sent.");
        case Applying::NotInFile:
            return Texts::tr("Not in the file: stays as it is.");
        case Applying::OtherHardware:
            return Texts::tr("Cannot be applied: the file is for another module.");
        case Applying::NotThere:
            return Texts::tr("Not in the chain; its settings are kept.");
    }
    return {};
}

QString notSentWhileMoving(int movingMotors) {
    return Texts::tr("%n motors are moving: stop them before anything is sent.", nullptr, movingMotors);
}

}  // namespace nmc::texts
