// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperparametersbox.h"

#include <QCheckBox>
#include <QLabel>

#include "model/intent/stepperplan.h"
#include "model/module/stepperdefaults.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// For an unknown motor: slow and cool. Never sent by themselves.
constexpr stepper::SetParameters kStartingValues{
    .speedMode = stepper::SpeedMode::X1, .minimumProfileSpeed = 4, .runCurrent = 64, .holdCurrent = 32};
}  // namespace

StepperParametersBox::StepperParametersBox(ModuleContext& context, QWidget* parent)
    : StagedForm(context,
                 {.what = u"Parameters"_s,
                  .undo = tr("Undo the last edit of a parameter"),
                  .redo = tr("Redo the edit of a parameter"),
                  .revert = tr("Revert the parameters to those last sent"),
                  .sentOnes = tr("Restores the parameters last sent. Sends nothing."),
                  .none = tr("Clears the fields: no parameters have been sent yet. Sends nothing.")},
                 parent) {
    look::name(this, u"stepperParametersBox"_s, Common::tr("Parameters"));
    auto* grid = new FormGrid(this, 4, {.ends = 1});
    addFields(grid);
    buildCommands();
    m_start = new Command({.name = u"stepperFillParametersButton"_s,
                           .icon = u"wand"_s,
                           .text = Common::tr("Start&ing values"),
                           .accessible = Common::tr("Starting values: fill in")},
                          this, [this] { fill(*valuesOf(kStartingValues)); });
    m_apply = new Command({.name = u"stepperApplyParametersButton"_s,
                           .icon = u"send"_s,
                           .text = tr("&Apply parameters"),
                           .accessible = tr("Apply parameters: all")},
                          this, [this] {
                              if (const auto parameters = this->parameters())
                                  this->context().ask(stepperintent::SetParameters{*parameters});
                          });
    grid->addWide(new FlowLayout(look::gridUnit(this),
                                 {m_start->button(), undoCommand()->button(), redoCommand()->button(),
                                  revertCommand()->button(), m_apply->button()}));
    grid->addWide(hint());
    grid->addGap(1);
    addRamp(grid);
    grid->end();
    m_minimumSpeed->setScale(context.scale());
    begin(*m_apply);
}

void StepperParametersBox::addFields(FormGrid* grid) {
    const auto addNumber = [&](const Row& row) {
        addField(grid, row,
                 form::newNumber({.name = row.object + u"Field"_s,
                                  .accessible = row.label,
                                  .min = static_cast<double>(stepper::kByteRange.min),
                                  .max = static_cast<double>(stepper::kByteRange.max),
                                  .digits = 8,
                                  .meaning = row.meaning},
                                 this));
    };
    const auto addCheck = [&](const Row& row, const QString& text) {
        addField(grid, row,
                 form::newCheck({.name = row.object + u"Field"_s,
                                 .text = text,
                                 .accessible = text + u": "_s + row.label,
                                 .meaning = row.meaning},
                                this));
    };
    const Row speedMode{
        u"stepperSpeedMode"_s, tr("Speed mode"),
        tr("The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.")};
    m_speedMode = form::newChoice(
        {.name = speedMode.object + u"Field"_s, .accessible = speedMode.label, .meaning = speedMode.meaning},
        this);
    for (const auto mode :
         {stepper::SpeedMode::X1, stepper::SpeedMode::X2, stepper::SpeedMode::X4, stepper::SpeedMode::X8})
        m_speedMode->addItem(texts::speedMode(mode), static_cast<int>(mode));
    // The range follows before the edit is recorded.
    connect(m_speedMode, &QComboBox::activated, this, &StepperParametersBox::setSpeedRange);
    addField(grid, speedMode, m_speedMode);
    const Row minimumSpeed{
        u"stepperMinimumSpeed"_s, tr("Minimum profile speed"),
        tr("The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.")};
    m_minimumSpeed = form::newQuantity({.kind = QuantityField::Kind::Velocity,
                                        .name = minimumSpeed.object + u"Field"_s,
                                        .accessible = minimumSpeed.label,
                                        .step = 25,
                                        .meaning = minimumSpeed.meaning},
                                       this);
    addField(
        grid, minimumSpeed, m_minimumSpeed,
        [this]() -> std::optional<int> {
            const auto speed = m_minimumSpeed->native();
            return speed ? std::optional<int>(speeds().speedFor(*speed)) : std::nullopt;
        },
        [this](const std::optional<int>& speed) {
            setSpeedRange();
            if (speed)
                m_minimumSpeed->showNative(speeds().ofSpeed(*speed));
            else
                m_minimumSpeed->showNothing();
        });
    addNumber(
        {u"stepperRunCurrent"_s, tr("Run current"),
         tr("Motor current while moving; 255 is the driver's full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.")});
    addNumber(
        {u"stepperHoldCurrent"_s, tr("Hold current"),
         tr("Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.")});
    addNumber(
        {u"stepperThermalLimit"_s, tr("Thermal limit"),
         tr("The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.")});
    addCheck(
        {u"stepperIgnoreLimits"_s, tr("Limit switches"),
         tr("Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.")},
        tr("ignored: no motor stop"));
    addCheck(
        {u"stepperIgnoreEstop"_s, Common::tr("E-stop input"),
         tr("Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.")},
        tr("ignored: no motor stop"));
    addCheck(
        {u"stepperMotorOffOnStop"_s, tr("On limit or E-stop"),
         tr("A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.")},
        tr("motor switches off, too"));
}

/// Adds what is not a parameter of the chip but applies to every motion: the acceleration time, and the speed
/// cap of hold to move. Both are kept in the settings; an edit sends nothing.
void StepperParametersBox::addRamp(FormGrid* grid) {
    auto* box = new QWidget(this);
    m_time = form::newNumber(
        {.name = u"stepperAccelerationTimeField"_s,
         .accessible = Common::tr("Acceleration time"),
         .words = tr("The acceleration time"),
         .min = static_cast<double>(stepper::kAccelerationTimeRange.min),
         .max = static_cast<double>(stepper::kAccelerationTimeRange.max),
         .digits = 8,
         .meaning = tr(
             "How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.")},
        box);
    m_acceleration = look::newMutedLabel({}, box, u"stepperAccelerationRemark"_s);
    m_timeState = look::newMutedLabel({}, box, u"stepperAccelerationTimeState"_s);
    m_cap = form::newQuantity(
        {.kind = QuantityField::Kind::Velocity,
         .name = u"stepperHoldCapField"_s,
         .accessible = Common::tr("Max jog speed"),
         .step = 100,
         .meaning = tr("Jog is never faster than this. Set a speed that you can react to.")},
        box);
    auto* ramp = new FormGrid(box, 5, {.sides = 0, .ends = 0, .across = 1});
    ramp->addWide(form::newHeading(tr("With every motion"), box));
    ramp->addRow(Common::tr("Acceleration time"), m_time,
                 {new QLabel(tr("× 0.25 ms"), box), m_acceleration, m_timeState});
    ramp->addRow(Common::tr("Max jog speed"), m_cap);
    ramp->setColumnStretch(3, 0);
    ramp->setColumnStretch(4, 1);
    grid->addWide(box);
    connect(m_time, &NumberField::edited, this, [this] {
        if (const auto time = m_time->value())
            context().edit([time](AxisSettings& axis) { axis.accelerationTime = *time; });
        refreshRamp();
    });
    connect(m_cap, &QuantityField::nativeEdited, this, [this] {
        if (const auto cap = m_cap->native())
            context().edit([cap](AxisSettings& axis) { axis.motion.holdCap = *cap; });
    });
}

// ---- contents of the fields ----

/// The speed mode in its field; 1x while none is selected.
StepperSpeed StepperParametersBox::speeds() const {
    const bool chosen = m_speedMode->currentIndex() >= 0;
    return StepperSpeed(chosen ? form::chosen<stepper::SpeedMode>(m_speedMode) : stepper::SpeedMode::X1);
}

void StepperParametersBox::setSpeedRange() {
    m_minimumSpeed->setNativeRange(speeds().slowest(), speeds().fastest());
}

std::optional<StagedForm::Values> StepperParametersBox::valuesOf(
    const std::optional<stepper::SetParameters>& parameters) {
    if (!parameters)
        return std::nullopt;
    return Values{static_cast<int>(parameters->speedMode),
                  parameters->minimumProfileSpeed,
                  parameters->runCurrent,
                  parameters->holdCurrent,
                  parameters->thermalLimit,
                  parameters->ignoreLimits,
                  parameters->ignoreEstop,
                  parameters->motorOffOnLimitOrEstop};
}

std::optional<StagedForm::Values> StepperParametersBox::kept() const {
    return valuesOf(context().settings().parameters);
}

std::optional<StagedForm::Values> StepperParametersBox::sent() const {
    return valuesOf(context().state().stepper.parameters);
}

std::optional<stepper::SetParameters> StepperParametersBox::parameters() const {
    if (!complete())
        return std::nullopt;
    const auto number = [this](Parameter parameter) { return *field(parameter).value(); };
    const auto byte = [&](Parameter parameter) { return static_cast<std::uint8_t>(number(parameter)); };
    return stepper::SetParameters{.speedMode = static_cast<stepper::SpeedMode>(byte(SpeedMode)),
                                  .ignoreLimits = number(IgnoreLimits) != 0,
                                  .ignoreEstop = number(IgnoreEstop) != 0,
                                  .motorOffOnLimitOrEstop = number(MotorOff) != 0,
                                  .minimumProfileSpeed = byte(MinimumSpeed),
                                  .runCurrent = byte(RunCurrent),
                                  .holdCurrent = byte(HoldCurrent),
                                  .thermalLimit = byte(ThermalLimit)};
}

void StepperParametersBox::keep() {
    context().edit([parameters = parameters()](AxisSettings& axis) { axis.parameters = parameters; });
}

// ---- display ----

void StepperParametersBox::showRamp() {
    const StepperState& stepper = context().state().stepper;
    const AxisSettings& settings = context().settings();
    m_cap->setScale(context().scale());
    m_cap->setNativeRange(stepperdefaults::slowestProfile(stepper, settings),
                          stepperdefaults::speedMode(stepper, settings).fastest());
    showUnlessTyped(m_time, stepperdefaults::accelerationTime(settings));
    const double cap = stepperdefaults::holdCap(stepper, settings);
    if (!m_cap->hasFocus() && m_cap->native() != cap)
        m_cap->showNative(cap);
    refreshRamp();
}

void StepperParametersBox::refreshRamp() {
    const StepperState& stepper = context().state().stepper;
    const StepperSpeed mode = stepperdefaults::speedMode(stepper, context().settings());
    const auto time = m_time->value();
    look::setText(m_acceleration, time ? texts::acceleration(mode, static_cast<int>(*time), m_cap->scale())
                                       : m_time->problemText());
    const auto loaded = stepper.accelerationTime;
    showMark(m_timeState, !loaded ? Mark::Unknown : *loaded == time ? Mark::Sent : Mark::Edited);
}

QString StepperParametersBox::remark(std::size_t field, const std::optional<int>& value) const {
    if (field == ThermalLimit) {
        const auto analog = context().state().latest.value_or(StatusReport{}).analog;
        const QString now = analog ? tr("A/D now %1").arg(*analog) : QString();
        if (value != 0)
            return now;
        return now.isEmpty() ? Common::tr("off") : tr("off; %1").arg(now);
    }
    if (!value)
        return {};
    if (field == MinimumSpeed)
        return tr("speed %1").arg(*value);
    if (field == RunCurrent || field == HoldCurrent)
        return *value == 0 ? tr("no current") : tr("%1 % of full").arg(qRound(*value * 100.0 / 255));
    return {};
}

void StepperParametersBox::refreshRest() {
    showRamp();
    m_minimumSpeed->setScale(context().scale());
    setSpeedRange();
    const auto ignored = [this](Parameter parameter) { return field(parameter).value() == 1; };
    const QString problem = m_speedMode->currentIndex() < 0 ? tr("Choose a speed mode.") : trouble();
    QString text = problem;
    if (unknown())
        text =
            tr("Parameters cannot be read back from the module. The motor moves only after you apply them.");
    else if (problem.isEmpty() && ignored(IgnoreEstop))
        text = tr("If checked, the E-stop input does not stop the motor.");
    else if (problem.isEmpty() && ignored(IgnoreLimits))
        text = tr("If checked, the limit switches do not stop the motor.");
    look::setText(hint(), text);
    QString reason = context().reasonFor(IntentKind::SetParameters);
    if (const auto entered = parameters(); entered && reason.isEmpty())
        if (const auto refusal = whyNotSet(*entered, context().state()))
            reason = texts::refusal(*refusal);
    m_start->setPossible(context().whyLocked(),
                         tr("Fills in low speeds and currents to start with. Sends nothing."));
    m_apply->setPossible(
        !reason.isEmpty()    ? reason
        : !problem.isEmpty() ? problem
                             : context().whyBusy(),
        context().state().driveOn()
            ? tr("Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.")
            : tr("Sends all parameters at once. The motor does not move."));
}

}  // namespace nmc
