// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/expertbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

#include "widgets/common/askdialog.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/panels/command.h"
#include "widgets/panels/directbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

using Value = DirectBox::Value;

std::uint32_t unsignedOf(const Value& value) {
    return static_cast<std::uint32_t>(value.value());
}

template <typename T, typename Make>
std::optional<T> loadedAs(const Value& value, Make make) {
    std::optional<T> loaded;
    if (value.sent())
        loaded.emplace(make(value.value()));
    return loaded;
}

std::optional<Counts> counts(const Value& value) {
    return loadedAs<Counts>(value, [](double number) { return static_cast<std::int32_t>(number); });
}

std::optional<std::uint8_t> byte(const Value& value) {
    return loadedAs<std::uint8_t>(value, [](double number) { return static_cast<std::uint8_t>(number); });
}

QString startMeaning(bool startNow, const QString& meaning) {
    return startNow ? meaning
                    : ExpertBox::tr("%1 Waits for Start Motion; the next load overwrites it.").arg(meaning);
}

/// What the chip can watch for, and its bit in the command.
template <typename SetHoming>
struct HomingEvent {
    QString name;
    QString text;
    bool SetHoming::*watched;
};

/// Set Homing Mode of either chip.
template <typename ChipCommand, typename SetHoming>
DirectBox* newHoming(ModuleContext& context, const std::vector<HomingEvent<SetHoming>>& events,
                     QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertHoming"_s, ExpertBox::tr("Set Homing Mode"), ExpertBox::tr("Send homing mode")},
        parent);
    std::vector<std::pair<QCheckBox*, bool SetHoming::*>> flags;
    for (const auto& event : events)
        flags.emplace_back(box->addFlag(event.name, event.text), event.watched);
    QComboBox* manner = box->addChoice(u"Manner"_s, ExpertBox::tr("Then"),
                                       {ExpertBox::tr("Capture only"), ExpertBox::tr("Stop abruptly"),
                                        ExpertBox::tr("Stop smoothly"), Common::tr("Motor off")});
    box->setCommand(
        [=]() -> ModuleCommand {
            SetHoming homing;
            for (const auto& [flag, watched] : flags)
                homing.*watched = flag->isChecked();
            homing.stopAbruptly = manner->currentIndex() == 1;
            homing.stopSmoothly = manner->currentIndex() == 2;
            homing.motorOff = manner->currentIndex() == 3;
            return ChipCommand(homing);
        },
        [flags](const ModuleCommand& command) {
            const auto& homing = std::get<SetHoming>(std::get<ChipCommand>(command));
            if (std::ranges::none_of(flags, [&](const auto& flag) { return homing.*flag.second; }))
                return ExpertBox::tr("The chip stops watching for home.");
            const bool stops = homing.stopAbruptly || homing.stopSmoothly || homing.motorOff;
            return stops
                       ? ExpertBox::tr(
                             "At the first of these events the chip stores its position in the home register and stops. Start the motion with a command of your own.")
                       : ExpertBox::tr(
                             "At the first of these events the chip stores its position in the home register. The motion goes on.");
        });
    return box;
}

// ---- PIC-SERVO ----

DirectBox* newServoLoad(ModuleContext& context, QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertLoad"_s, ExpertBox::tr("Load Trajectory"), ExpertBox::tr("Send load")}, parent);
    const auto range = [](const ValueRange& r) {
        return std::pair(static_cast<double>(r.min), static_cast<double>(r.max));
    };
    const auto [lowest, highest] = range(servo::kPositionRange);
    const auto [slowest, fastest] = range(servo::kVelocityRange);
    QComboBox* mode =
        box->addChoice(u"Mode"_s, ExpertBox::tr("Mode"),
                       {ExpertBox::tr("Trapezoidal"), Common::tr("Velocity"), Common::tr("PWM")});
    const Value position =
        box->addValue(u"Position"_s, ExpertBox::tr("Position (counts)"), lowest, highest, true);
    const Value velocity =
        box->addValue(u"Velocity"_s, ExpertBox::tr("Velocity (counts/tick × 65536)"), slowest, fastest, true);
    const Value acceleration = box->addValue(
        u"Acceleration"_s, ExpertBox::tr("Acceleration (counts/tick² × 65536)"), slowest, fastest, true);
    const Value pwm = box->addValue(u"Pwm"_s, Common::tr("PWM value"), 0, 255, true);
    QCheckBox* reverse = box->addFlag(u"Reverse"_s, ExpertBox::tr("Reverse (velocity and PWM)"));
    QCheckBox* relative = hasPathBuffer(context.state().info.identity)
                              ? box->addFlag(u"Relative"_s, ExpertBox::tr("Relative (trapezoidal)"))
                              : nullptr;
    QCheckBox* now = box->addFlag(u"Now"_s, ExpertBox::tr("Start motion now"));
    box->setCommand(
        [=]() -> ModuleCommand {
            servo::LoadTrajectory load;
            load.relative = relative != nullptr && relative->isChecked();
            load.position = counts(position);
            if (velocity.sent())
                load.velocity = CountsPerTick(unsignedOf(velocity));
            if (acceleration.sent())
                load.acceleration = CountsPerTickSquared(unsignedOf(acceleration));
            load.pwm = byte(pwm);
            load.servo = mode->currentIndex() != 2;
            load.profile =
                mode->currentIndex() == 1 ? servo::ProfileMode::Velocity : servo::ProfileMode::Trapezoidal;
            load.reverse = reverse->isChecked();
            load.startNow = now->isChecked();
            return ServoCommand(load);
        },
        [](const ModuleCommand& command) {
            const auto& load = std::get<servo::LoadTrajectory>(std::get<ServoCommand>(command));
            if (!load.servo)
                return startMeaning(
                    load.startNow,
                    ExpertBox::tr("The servo is off; the PWM value drives the motor. No limit applies."));
            if (load.profile == servo::ProfileMode::Velocity)
                return startMeaning(load.startNow, ExpertBox::tr("The motor runs until it is stopped."));
            return startMeaning(
                load.startNow,
                load.relative
                    ? ExpertBox::tr(
                          "A trapezoidal move by this many counts, from the command position. Start it only from standstill.")
                    : ExpertBox::tr("A trapezoidal move to the position. Start it only from standstill."));
        });
    return box;
}

DirectBox* newServoStop(ModuleContext& context, QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertStop"_s, ExpertBox::tr("Stop Motor"), ExpertBox::tr("Send stop")}, parent);
    QComboBox* manner =
        box->addChoice(u"Manner"_s, Common::tr("How"),
                       {ExpertBox::tr("Amplifier only"), Common::tr("Motor off"), Common::tr("Abruptly"),
                        Common::tr("Smoothly"), ExpertBox::tr("At a position")});
    const Value here = box->addValue(u"Position"_s, ExpertBox::tr("Position (counts)"),
                                     static_cast<double>(servo::kPositionRange.min),
                                     static_cast<double>(servo::kPositionRange.max), false);
    QCheckBox* amplifier = box->addFlag(u"Amplifier"_s, ExpertBox::tr("Amplifier enabled"));
    amplifier->setChecked(true);
    const ModuleIdentity& module = context.state().info.identity;
    QCheckBox* advanced = hasPathBuffer(module) && !isSc(module)
                              ? box->addFlag(u"Advanced"_s, ExpertBox::tr("Advanced features on"))
                              : nullptr;
    box->setCommand(
        [=]() -> ModuleCommand {
            return ServoCommand(servo::StopMotor{
                amplifier->isChecked(), static_cast<servo::StopManner>(manner->currentIndex()), *counts(here),
                advanced != nullptr && advanced->isChecked()});
        },
        [&context](const ModuleCommand& command) {
            switch (std::get<servo::StopMotor>(std::get<ServoCommand>(command)).manner) {
                case servo::StopManner::AmplifierOnly:
                    return ExpertBox::tr("Switches only AMP_EN. The servo stays as it is.");
                case servo::StopManner::MotorOff:
                    return ExpertBox::tr("The servo is switched off. The motor is free to turn.");
                case servo::StopManner::Abruptly:
                    return context.state().servoOn()
                               ? ExpertBox::tr("The motor stops at once and holds.")
                               : ExpertBox::tr("The servo is switched ON and holds its position.");
                case servo::StopManner::Smoothly:
                    return ExpertBox::tr("The motor slows down with the loaded acceleration and holds.");
                case servo::StopManner::Here:
                    return ExpertBox::tr(
                        "The motor goes to this position without a profile, as fast as the gains drive it, and holds there.");
            }
            return QString();
        });
    return box;
}

DirectBox* newServoHoming(ModuleContext& context, QWidget* parent) {
    using servo::SetHoming;
    return newHoming<ServoCommand, SetHoming>(
        context,
        {{u"Limit1"_s, ExpertBox::tr("Change of limit 1"), &SetHoming::onLimit1Change},
         {u"Limit2"_s, ExpertBox::tr("Change of limit 2"), &SetHoming::onLimit2Change},
         {u"Index"_s, Common::tr("Index"), &SetHoming::onIndexChange},
         {u"PositionError"_s, Common::tr("Position error"), &SetHoming::onPositionError},
         {u"CurrentLimit"_s, Common::tr("Current limit"), &SetHoming::onCurrentLimit}},
        parent);
}

/// For CMC and SC.
DirectBox* newServoReset(ModuleContext& context, QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertReset"_s, ExpertBox::tr("Reset Position"), ExpertBox::tr("Send reset position")},
        parent);
    QStringList choices{ExpertBox::tr("To 0"), ExpertBox::tr("Relative to home")};
    if (isSc(context.state().info.identity))
        choices << ExpertBox::tr("To a value");
    QComboBox* how = box->addChoice(u"How"_s, Common::tr("How"), choices);
    const Value position = box->addValue(u"Position"_s, ExpertBox::tr("Position (counts)"),
                                         static_cast<double>(servo::kPositionRange.min),
                                         static_cast<double>(servo::kPositionRange.max), false);
    box->setCommand(
        [=]() -> ModuleCommand {
            if (how->currentIndex() == 1)
                return ServoCommand(servo::ResetRelativeToHome{});
            if (how->currentIndex() == 2)
                return ServoCommand(servo::SetPosition{*counts(position)});
            return ServoCommand(ResetPosition{});
        },
        [](const ModuleCommand& command) {
            if (is<servo::ResetRelativeToHome>(command))
                return ExpertBox::tr("The home register is subtracted from the position. Nothing moves.");
            return ExpertBox::tr("The position becomes this value. Nothing moves.");
        });
    return box;
}

// ---- PIC-STEP ----

/// By Table 4, the goal depends on what is loaded and on what the motor is doing now.
QString stepperGoalMeaning(const stepper::LoadTrajectory& load, StepperMode mode) {
    const auto goal = goalMode(mode, load);
    if (!goal)
        return ExpertBox::tr(
            "Table 4 of the data sheet has no such mode for the present state of the motor.");
    switch (*goal) {
        case StepperMode::Trapezoidal:
            return ExpertBox::tr("A trapezoidal move to the position.");
        case StepperMode::VelocityProfile:
            return ExpertBox::tr("A ramp to the speed. The motor runs until it is stopped.");
        case StepperMode::UnprofiledWithStop:
            if (load.position)
                return ExpertBox::tr("One speed from the first step to the position.");
            return ExpertBox::tr(
                "The move continues to its position at this speed. If it has just ended, the motor runs until it is stopped.");
        case StepperMode::Unprofiled:
            return ExpertBox::tr("One speed from the first step. The motor runs until it is stopped.");
        case StepperMode::Stopped:
        case StepperMode::Unknown:
            break;
    }
    return {};
}

DirectBox* newStepperLoad(ModuleContext& context, QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertLoad"_s, ExpertBox::tr("Load Trajectory"), ExpertBox::tr("Send load")}, parent);
    const auto add = [box](const QString& name, const QString& text, const ValueRange& range) {
        return box->addValue(name, text, static_cast<double>(range.min), static_cast<double>(range.max),
                             true);
    };
    const Value position = add(u"Position"_s, ExpertBox::tr("Position (steps)"), stepper::kPositionRange);
    const Value speed = add(u"Speed"_s, Common::tr("Speed"), stepper::kSpeedRange);
    const Value acceleration =
        add(u"Acceleration"_s, ExpertBox::tr("Acceleration time (0.25 ms)"), stepper::kAccelerationTimeRange);
    const Value timer = add(u"Timer"_s, ExpertBox::tr("Initial timer count"), stepper::kTimerCountRange);
    const Value nearest = box->addValue(u"Nearest"_s, ExpertBox::tr("Nearest integer speed"), 1, 250, false);
    QCheckBox* reverse = box->addFlag(u"Reverse"_s, ExpertBox::tr("Reverse (not trapezoidal)"));
    QCheckBox* now = box->addFlag(u"Now"_s, ExpertBox::tr("Start motion now"));
    box->setCommand(
        [=]() -> ModuleCommand {
            stepper::LoadTrajectory load;
            load.position = counts(position);
            load.speed = byte(speed);
            load.accelerationTime = byte(acceleration);
            if (timer.sent())
                load.timer = stepper::TimerCount{static_cast<std::uint16_t>(timer.value()),
                                                 static_cast<std::uint8_t>(nearest.value())};
            load.reverse = reverse->isChecked();
            load.startNow = now->isChecked();
            return StepperCommand(load);
        },
        [&context](const ModuleCommand& command) {
            const auto& load = std::get<stepper::LoadTrajectory>(std::get<StepperCommand>(command));
            return startMeaning(load.startNow, stepperGoalMeaning(load, context.state().stepper.mode()));
        });
    return box;
}

DirectBox* newStepperStop(ModuleContext& context, QWidget* parent) {
    auto* box = new DirectBox(
        context, {u"expertStop"_s, ExpertBox::tr("Stop Motor"), ExpertBox::tr("Send stop")}, parent);
    QComboBox* manner =
        box->addChoice(u"Manner"_s, Common::tr("How"),
                       {ExpertBox::tr("Amplifier only"), Common::tr("Abruptly"), Common::tr("Smoothly")});
    QCheckBox* amplifier = box->addFlag(u"Amplifier"_s, ExpertBox::tr("Amplifier enabled"));
    amplifier->setChecked(true);
    box->setCommand(
        [=]() -> ModuleCommand {
            return StepperCommand(stepper::StopMotor{
                amplifier->isChecked(), static_cast<stepper::StopManner>(manner->currentIndex())});
        },
        [](const ModuleCommand& command) {
            switch (std::get<stepper::StopMotor>(std::get<StepperCommand>(command)).manner) {
                case stepper::StopManner::AmplifierOnly:
                    return ExpertBox::tr("Switches only AMP_EN. A motion in progress keeps counting.");
                case stepper::StopManner::Abruptly:
                    return ExpertBox::tr("The steps end at once.");
                case stepper::StopManner::Smoothly:
                    return ExpertBox::tr("The motor slows down with its acceleration time.");
            }
            return QString();
        });
    return box;
}

DirectBox* newStepperHoming(ModuleContext& context, QWidget* parent) {
    using stepper::SetHoming;
    return newHoming<StepperCommand, SetHoming>(
        context,
        {{u"Limit1"_s, ExpertBox::tr("Change of limit 1"), &SetHoming::onLimit1Change},
         {u"Limit2"_s, ExpertBox::tr("Change of limit 2"), &SetHoming::onLimit2Change},
         {u"HomeSwitch"_s, ExpertBox::tr("Change of the home switch"), &SetHoming::onHomeSwitchChange}},
        parent);
}

}  // namespace

ExpertBox::ExpertBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_reset(new Command({.name = u"resetModuleButton"_s,
                           .text = tr("Reset module…"),
                           .accessible = tr("Reset module to its power-up state")},
                          this, [this] { askBeforeReset(); })) {
    look::name(this, u"expertBox"_s, tr("Commands as in the data sheet"));
    const int unit = look::gridUnit(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit / 2, unit / 2, unit / 2, unit / 2);
    layout->addWidget(form::newRemark(
        tr("Commands as in the data sheet, in native counts. STOP ALL and Esc work as usual."), this));
    const bool steps = context.state().isStepper();
    layout->addWidget(steps ? newStepperLoad(context, this) : newServoLoad(context, this));
    layout->addWidget(steps ? newStepperStop(context, this) : newServoStop(context, this));
    layout->addWidget(steps ? newStepperHoming(context, this) : newServoHoming(context, this));
    if (hasPathBuffer(context.state().info.identity))
        layout->addWidget(newServoReset(context, this));
    layout->addWidget(m_reset->button(), 0, Qt::AlignRight);
    layout->addStretch(1);
    m_context.whenSeen(this, [this] { refresh(); });
}

void ExpertBox::refresh() {
    m_reset->setPossible(
        m_context.reasonNow(IntentKind::ResetModule),
        tr("Returns this module to its power-up state and assigns its address again. The other modules are unchanged."));
}

void ExpertBox::askBeforeReset() {
    // While another module's page is shown, this one is in no window, and does not follow its module.
    const auto text = [this, module = texts::moduleName(m_context.state().info.index)] {
        const bool stands = window()->isVisible() && !m_context.whyNot(IntentKind::ResetModule);
        return stands
                   ? tr("Reset %1? Its motor switches off, and it loses its position, settings and group. The other modules are unchanged.")
                         .arg(module)
                   : QString();
    };
    const auto go = [this] { m_context.ask(intent::ResetModule{}); };
    AskDialog::ask({.name = u"resetModuleQuestion"_s,
                    .title = tr("Reset module"),
                    .text = text,
                    .stay = Common::tr("Cancel"),
                    .stayName = u"resetModuleCancel"_s},
                   {{tr("Reset the module"), u"resetModuleGo"_s, go}}, this);
}

}  // namespace nmc
