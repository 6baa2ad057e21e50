// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperparametersbox.h"

#include <QCheckBox>

#include "model/intent/stepperplan.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperrampbox.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

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
    auto* start = new Command({.name = u"stepperFillParametersButton"_s,
                               .icon = u"wand"_s,
                               .text = Common::tr("Start&ing values"),
                               .accessible = Common::tr("Starting values: fill in")},
                              this, [this] { fill(*valuesOf(stepperStartingValues())); });
    start->setPossible({}, tr("Fills in low speeds and currents to start with. Sends nothing."));
    m_apply = new Command({.name = u"stepperApplyParametersButton"_s,
                           .icon = u"send"_s,
                           .text = tr("&Apply parameters"),
                           .accessible = tr("Apply parameters: all")},
                          this, [this] {
                              if (const auto parameters = this->parameters())
                                  this->context().ask(stepperintent::SetParameters{*parameters});
                          });
    auto* buttons = new FlowLayout(look::gridUnit(this));
    for (const Command* command : {start, undoCommand(), redoCommand(), revertCommand(), m_apply})
        buttons->addWidget(command->button());
    m_ramp = new StepperRampBox(context, this);
    grid->addWide(buttons);
    grid->addWide(hint());
    grid->addGap(1);
    grid->addWide(m_ramp);
    grid->end();
    m_minimumSpeed->setScale(context.scale());
    begin(*m_apply);
}

void StepperParametersBox::addFields(FormGrid* grid) {
    const auto rowOf = [](StepperParameter parameter) {
        return Row{stepperParameterObject(parameter), stepperParameterName(parameter),
                   stepperParameterMeaning(parameter)};
    };
    const auto fieldName = [](StepperParameter parameter) {
        return stepperParameterObject(parameter) + u"Field"_s;
    };
    const auto addNumber = [&](StepperParameter parameter) {
        addField(grid, rowOf(parameter),
                 form::newNumber({.name = fieldName(parameter),
                                  .accessible = stepperParameterName(parameter),
                                  .min = static_cast<double>(stepper::kByteRange.min),
                                  .max = static_cast<double>(stepper::kByteRange.max),
                                  .digits = 8,
                                  .meaning = stepperParameterMeaning(parameter)},
                                 this));
    };
    const auto addCheck = [&](StepperParameter parameter, const QString& text) {
        QCheckBox* box = form::newCheck({.name = fieldName(parameter),
                                         .text = text,
                                         .accessible = text + u": "_s + stepperParameterName(parameter),
                                         .meaning = stepperParameterMeaning(parameter)},
                                        this);
        addField(grid, rowOf(parameter), box);
    };
    m_speedMode = form::newChoice({.name = fieldName(StepperParameter::SpeedMode),
                                   .accessible = stepperParameterName(StepperParameter::SpeedMode),
                                   .meaning = stepperParameterMeaning(StepperParameter::SpeedMode)},
                                  this);
    for (const auto mode :
         {stepper::SpeedMode::X1, stepper::SpeedMode::X2, stepper::SpeedMode::X4, stepper::SpeedMode::X8})
        m_speedMode->addItem(texts::speedMode(mode), static_cast<int>(mode));
    // The range follows before the edit is recorded.
    connect(m_speedMode, &QComboBox::activated, this, &StepperParametersBox::setSpeedRange);
    addField(grid, rowOf(StepperParameter::SpeedMode), m_speedMode);
    m_minimumSpeed = form::newQuantity({.kind = QuantityField::Kind::Velocity,
                                        .name = fieldName(StepperParameter::MinimumSpeed),
                                        .accessible = stepperParameterName(StepperParameter::MinimumSpeed),
                                        .step = 25,
                                        .meaning = stepperParameterMeaning(StepperParameter::MinimumSpeed)},
                                       this);
    addField(
        grid, rowOf(StepperParameter::MinimumSpeed), m_minimumSpeed,
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
    addNumber(StepperParameter::RunCurrent);
    addNumber(StepperParameter::HoldCurrent);
    addNumber(StepperParameter::ThermalLimit);
    addCheck(StepperParameter::IgnoreLimits, tr("ignored: no motor stop"));
    addCheck(StepperParameter::IgnoreEstop, tr("ignored: no motor stop"));
    addCheck(StepperParameter::MotorOff, tr("motor switches off, too"));
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
    Values values;
    for (const StepperParameter parameter : kStepperParameters)
        values.emplace_back(stepperParameter(*parameters, parameter));
    return values;
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
    stepper::SetParameters parameters;
    const Values values = entered();
    for (const StepperParameter parameter : kStepperParameters)
        setStepParameter(parameters, parameter, *values.at(static_cast<std::size_t>(parameter)));
    return parameters;
}

void StepperParametersBox::keep() {
    context().edit([parameters = parameters()](AxisSettings& axis) { axis.parameters = parameters; });
}

// ---- display ----

void StepperParametersBox::arrange() {
    m_ramp->setNarrow(narrow());
}

QString StepperParametersBox::remark(std::size_t field, const std::optional<int>& value) const {
    return stepperParameterRemark(kStepperParameters.at(field), value,
                                  context().state().latest.value_or(StatusReport{}).analog);
}

void StepperParametersBox::refreshRest() {
    m_minimumSpeed->setScale(context().scale());
    setSpeedRange();
    const auto ignored = [this](StepperParameter parameter) {
        return field(static_cast<std::size_t>(parameter)).value() == 1;
    };
    const QString problem = m_speedMode->currentIndex() < 0 ? tr("Choose a speed mode.") : trouble();
    QString text = problem;
    if (unknown())
        text =
            tr("Parameters cannot be read back from the module. The motor moves only after you apply them.");
    else if (problem.isEmpty() && ignored(StepperParameter::IgnoreEstop))
        text = tr("If checked, the E-stop input does not stop the motor.");
    else if (problem.isEmpty() && ignored(StepperParameter::IgnoreLimits))
        text = tr("If checked, the limit switches do not stop the motor.");
    look::setText(hint(), text);
    QString reason = context().reasonFor(IntentKind::SetParameters);
    if (const auto entered = parameters(); entered && reason.isEmpty())
        if (const auto refusal = whyNotSet(*entered, context().state()))
            reason = texts::refusal(*refusal);
    m_apply->setPossible(
        !reason.isEmpty()    ? reason
        : !problem.isEmpty() ? problem
                             : context().whyBusy(),
        context().state().driveOn()
            ? tr("Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.")
            : tr("Sends all parameters at once. The motor does not move."));
}

}  // namespace nmc
