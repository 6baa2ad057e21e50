// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperparametersbox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "model/intent/stepperplan.h"
#include "widgets/common/flowlayout.h"
#include "widgets/common/foldinggrid.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperrampbox.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

std::optional<int> wholeOrNothing(const std::optional<double>& value) {
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

void showWhole(NumberField* field, const std::optional<int>& value) {
    const QSignalBlocker blocker(field);
    if (value)
        field->showValue(*value);
    else
        field->showNothing();
}

void showTick(QCheckBox* box, const std::optional<int>& value) {
    const QSignalBlocker blocker(box);
    box->setChecked(value.value_or(0) != 0);
}

constexpr std::size_t indexOf(StepperParameter parameter) {
    return static_cast<std::size_t>(parameter);
}

}  // namespace

StepperParametersBox::StepperParametersBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_speedMode(new QComboBox(this)),
      m_minimumSpeed(new QuantityField(QuantityField::Kind::Velocity, this)),
      m_runCurrent(new NumberField(0, this)),
      m_holdCurrent(new NumberField(0, this)),
      m_thermalLimit(new NumberField(0, this)),
      m_ignoreLimits(new QCheckBox(tr("ignored: no motor stop"), this)),
      m_ignoreEstop(new QCheckBox(tr("ignored: no motor stop"), this)),
      m_motorOff(new QCheckBox(tr("motor switches off, too"), this)),
      m_ramp(new StepperRampBox(context, this)),
      m_fill(new Command({.name = u"stepperFillParametersButton"_s,
                          .icon = u"wand"_s,
                          .text = tr("Start&ing values"),
                          .accessible = tr("Starting values: fill in")},
                         this, [this] { fillIn(); })),
      m_revert(new Command({.name = u"stepperRevertParametersButton"_s,
                            .icon = u"arrow-back-up"_s,
                            .text = tr("Revert"),
                            .accessible = tr("Revert the parameters to those last sent"),
                            .key = Qt::CTRL | Qt::Key_R},
                           this, [this] { revert(); })),
      m_apply(new Command({.name = u"stepperApplyParametersButton"_s,
                           .icon = u"send"_s,
                           .text = tr("&Apply parameters"),
                           .accessible = tr("Apply parameters: all")},
                          this, [this] { apply(); })),
      m_hint(new QLabel(this)) {
    look::name(this, u"stepperParametersBox"_s, tr("Parameters"));
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit * 2 / 3);
    grid->setVerticalSpacing(unit / 3);
    buildRows(grid);
    const int line = static_cast<int>(kStepperParameters.size());
    buildButtons(grid, line);
    grid->setRowMinimumHeight(line + 2, unit);
    grid->addWidget(m_ramp, line + 3, 0, 1, 5);
    grid->setRowStretch(line + 4, 1);
    grid->setColumnStretch(4, 1);
    connectControls();
    m_kept = m_context.settings().parameters;
    m_sent = m_context.state().stepper.parameters();
    m_minimumSpeed->setScale(m_context.scale());
    showSettings();
    m_context.whenSeen(this, [this] { showModule(); });
}

void StepperParametersBox::buildRows(QGridLayout* grid) {
    for (const auto mode :
         {stepper::SpeedMode::X1, stepper::SpeedMode::X2, stepper::SpeedMode::X4, stepper::SpeedMode::X8})
        m_speedMode->addItem(texts::speedMode(mode), static_cast<int>(mode));
    m_speedMode->setPlaceholderText(tr("unknown"));
    m_speedMode->setCurrentIndex(-1);
    m_minimumSpeed->setQuantity(stepperParameterName(StepperParameter::MinimumSpeed));
    m_minimumSpeed->setNativeStep(25);
    for (const auto& [field, parameter] : {std::pair{m_runCurrent, StepperParameter::RunCurrent},
                                           {m_holdCurrent, StepperParameter::HoldCurrent},
                                           {m_thermalLimit, StepperParameter::ThermalLimit}}) {
        field->setRange(static_cast<double>(stepper::kByteRange.min),
                        static_cast<double>(stepper::kByteRange.max));
        field->setWords(stepperParameterName(parameter), {});
        field->setDigits(8);
    }
    for (NumberField* field :
         {static_cast<NumberField*>(m_minimumSpeed), m_runCurrent, m_holdCurrent, m_thermalLimit})
        field->setPlaceholderText(tr("unknown"));
    addRow(grid, StepperParameter::SpeedMode, m_speedMode);
    addRow(grid, StepperParameter::MinimumSpeed, m_minimumSpeed);
    addRow(grid, StepperParameter::RunCurrent, m_runCurrent);
    addRow(grid, StepperParameter::HoldCurrent, m_holdCurrent);
    addRow(grid, StepperParameter::ThermalLimit, m_thermalLimit);
    addRow(grid, StepperParameter::IgnoreLimits, m_ignoreLimits);
    addRow(grid, StepperParameter::IgnoreEstop, m_ignoreEstop);
    addRow(grid, StepperParameter::MotorOff, m_motorOff);
    // The accessible name begins with the text of the box, by which it is found; the parameter follows.
    for (QCheckBox* box : {m_ignoreLimits, m_ignoreEstop, m_motorOff})
        box->setAccessibleName(box->text() + u": "_s + box->accessibleName());
}

void StepperParametersBox::addRow(QGridLayout* grid, StepperParameter parameter, QWidget* control) {
    Row& row = m_rows[indexOf(parameter)];
    const int line = static_cast<int>(parameter);
    const QString name = stepperParameterName(parameter);
    const QString object = stepperParameterObject(parameter);
    row.label = new QLabel(name, this);
    row.label->setBuddy(control);
    row.label->setToolTip(stepperParameterMeaning(parameter));
    row.remark = look::newMutedLabel({}, this);
    row.remark->setObjectName(object + u"Remark"_s);
    row.state = look::newMutedLabel({}, this);
    row.state->setObjectName(object + u"State"_s);
    look::name(control, object + u"Field"_s, name);
    if (auto* field = qobject_cast<NumberField*>(control))
        field->setMeaning(stepperParameterMeaning(parameter));
    else
        control->setToolTip(stepperParameterMeaning(parameter));
    grid->addWidget(row.label, line, 0);
    // A choice needs no remark; a number is followed by its unit or by what it means.
    const bool wide = parameter == StepperParameter::SpeedMode || parameter >= StepperParameter::IgnoreLimits;
    grid->addWidget(control, line, 1, 1, wide ? 3 : 1);
    if (parameter == StepperParameter::MinimumSpeed) {
        m_minimumSpeed->setName(object + u"Field"_s, name);
        grid->addWidget(m_minimumSpeed->unitLabel(), line, 2);
        m_minimumSpeed->otherView()->hide();
    }
    row.remark->setVisible(!wide);
    if (!wide)
        grid->addWidget(row.remark, line, parameter == StepperParameter::MinimumSpeed ? 3 : 2, 1,
                        parameter == StepperParameter::MinimumSpeed ? 1 : 2);
    grid->addWidget(row.state, line, 4);
}

void StepperParametersBox::buildButtons(QGridLayout* grid, int line) {
    m_fill->setPossible({}, tr("Fills in low speeds and currents to start with. Sends nothing."));
    m_hint->setObjectName(u"stepperParametersHint"_s);
    m_hint->setWordWrap(true);
    m_hint->setTextFormat(Qt::PlainText);
    auto* buttons = new FlowLayout(look::gridUnit(this));
    for (const Command* command : {m_fill, m_revert, m_apply})
        buttons->addWidget(command->button());
    grid->addLayout(buttons, line, 0, 1, 5);
    grid->addWidget(m_hint, line + 1, 0, 1, 5);
}

void StepperParametersBox::connectControls() {
    connect(m_speedMode, &QComboBox::activated, this, &StepperParametersBox::edit);
    connect(m_minimumSpeed, &QuantityField::nativeEdited, this, &StepperParametersBox::edit);
    for (NumberField* field : {m_runCurrent, m_holdCurrent, m_thermalLimit})
        connect(field, &NumberField::edited, this, &StepperParametersBox::edit);
    for (QCheckBox* box : {m_ignoreLimits, m_ignoreEstop, m_motorOff})
        connect(box, &QCheckBox::toggled, this, &StepperParametersBox::edit);
}

// ---- contents of the fields ----

/// The speed mode in its field; 1x while none is selected.
StepperSpeed StepperParametersBox::speeds() const {
    const bool chosen = m_speedMode->currentIndex() >= 0;
    return StepperSpeed(chosen ? static_cast<stepper::SpeedMode>(m_speedMode->currentData().toInt())
                               : stepper::SpeedMode::X1);
}

std::optional<int> StepperParametersBox::entry(StepperParameter parameter) const {
    switch (parameter) {
        case StepperParameter::SpeedMode:
            return m_speedMode->currentIndex() < 0 ? std::nullopt
                                                   : std::optional(m_speedMode->currentData().toInt());
        case StepperParameter::MinimumSpeed: {
            const auto speed = m_minimumSpeed->native();
            return speed ? std::optional<int>(speeds().speedFor(*speed)) : std::nullopt;
        }
        case StepperParameter::RunCurrent:
            return wholeOrNothing(m_runCurrent->value());
        case StepperParameter::HoldCurrent:
            return wholeOrNothing(m_holdCurrent->value());
        case StepperParameter::ThermalLimit:
            return wholeOrNothing(m_thermalLimit->value());
        case StepperParameter::IgnoreLimits:
            return m_ignoreLimits->isChecked() ? 1 : 0;
        case StepperParameter::IgnoreEstop:
            return m_ignoreEstop->isChecked() ? 1 : 0;
        case StepperParameter::MotorOff:
            return m_motorOff->isChecked() ? 1 : 0;
    }
    return std::nullopt;
}

StepperParametersBox::Entries StepperParametersBox::entries() const {
    Entries all;
    for (const StepperParameter parameter : kStepperParameters)
        all[indexOf(parameter)] = entry(parameter);
    return all;
}

std::optional<stepper::SetParameters> StepperParametersBox::entered() const {
    stepper::SetParameters parameters;
    for (const StepperParameter parameter : kStepperParameters) {
        const auto value = entry(parameter);
        if (!value)
            return std::nullopt;
        setStepParameter(parameters, parameter, *value);
    }
    return parameters;
}

void StepperParametersBox::showEntries(const Entries& all) {
    const auto of = [&all](StepperParameter parameter) { return all[indexOf(parameter)]; };
    const auto mode = of(StepperParameter::SpeedMode);
    m_speedMode->setCurrentIndex(mode ? m_speedMode->findData(*mode) : -1);
    m_minimumSpeed->setNativeRange(speeds().slowest(), speeds().fastest());
    if (const auto minimum = of(StepperParameter::MinimumSpeed))
        m_minimumSpeed->showNative(speeds().ofSpeed(*minimum));
    else
        m_minimumSpeed->showNothing();
    showWhole(m_runCurrent, of(StepperParameter::RunCurrent));
    showWhole(m_holdCurrent, of(StepperParameter::HoldCurrent));
    showWhole(m_thermalLimit, of(StepperParameter::ThermalLimit));
    showTick(m_ignoreLimits, of(StepperParameter::IgnoreLimits));
    showTick(m_ignoreEstop, of(StepperParameter::IgnoreEstop));
    showTick(m_motorOff, of(StepperParameter::MotorOff));
}

/// Shows the parameters in the settings, or else those that were sent, or nothing if both are unknown.
void StepperParametersBox::showSettings() {
    Entries all;
    const auto& known = m_kept ? m_kept : m_sent;
    if (known)
        for (const StepperParameter parameter : kStepperParameters)
            all[indexOf(parameter)] = stepperParameter(*known, parameter);
    showEntries(all);
}

void StepperParametersBox::showModule() {
    const auto& kept = m_context.settings().parameters;
    const auto& sent = m_context.state().stepper.parameters();
    m_minimumSpeed->setScale(m_context.scale());
    const bool opened = kept != m_kept;  // another machine file replaces what was typed
    const bool others = opened || sent != m_sent;
    m_kept = kept;
    m_sent = sent;
    m_typed = m_typed && !opened;
    if (others && !m_typed)
        showSettings();
    m_typed = m_typed && entered() != sent;
    refresh();
}

void StepperParametersBox::edit() {
    m_minimumSpeed->setNativeRange(speeds().slowest(), speeds().fastest());
    m_typed = true;
    const auto parameters = entered();
    if (parameters && parameters != m_kept) {
        m_kept = parameters;
        m_context.edit([parameters](AxisSettings& axis) { axis.parameters = parameters; });
    }
    refresh();
}

void StepperParametersBox::fillIn() {
    Entries all;
    const stepper::SetParameters values = stepperStartingValues();
    for (const StepperParameter parameter : kStepperParameters)
        all[indexOf(parameter)] = stepperParameter(values, parameter);
    showEntries(all);
    edit();
}

void StepperParametersBox::revert() {
    m_typed = false;
    m_kept = m_sent;
    showSettings();
    m_context.edit([kept = m_kept](AxisSettings& axis) { axis.parameters = kept; });
    refresh();
}

void StepperParametersBox::apply() {
    if (const auto parameters = entered())
        m_context.ask(stepperintent::SetParameters{*parameters});
}

// ---- display ----

QString StepperParametersBox::trouble() const {
    if (m_speedMode->currentIndex() < 0)
        return tr("Choose a speed mode.");
    for (const NumberField* field :
         {static_cast<NumberField*>(m_minimumSpeed), m_runCurrent, m_holdCurrent, m_thermalLimit})
        if (field->problem() != NumberField::Problem::None)
            return field->problemText();
    return {};
}

void StepperParametersBox::refreshRow(StepperParameter parameter) {
    const Row& row = m_rows[indexOf(parameter)];
    const auto value = entry(parameter);
    const std::optional<std::uint8_t> analog = m_context.state().latest.value_or(StatusReport{}).analog;
    look::setText(row.remark, stepperParameterRemark(parameter, value, analog));
    const auto sent = m_sent ? std::optional(stepperParameter(*m_sent, parameter)) : std::nullopt;
    const bool choice = parameter >= StepperParameter::IgnoreLimits;
    const bool unknown = !sent && (!value || (choice && !m_kept));
    // A shape followed by words, as in the gains.
    const bool edited = !unknown && (!value || value != sent);
    const QString state = unknown ? tr("? unknown") : edited ? tr("● not sent") : tr("✓ sent");
    look::setText(row.state, m_narrow ? state.section(u' ', 0, 0) : state);
    QFont font = this->font();
    font.setBold(edited);
    if (row.state->font().bold() != edited)
        row.state->setFont(font);
}

void StepperParametersBox::fitInto(int width) {
    if (!m_narrow)
        m_wideWidth = minimumSizeHint().width();
    const bool narrow = width < m_wideWidth;
    if (narrow == m_narrow)
        return;
    m_narrow = narrow;
    m_ramp->setNarrow(narrow);
    refresh();
}

void StepperParametersBox::refresh() {
    for (const StepperParameter parameter : kStepperParameters)
        refreshRow(parameter);
    const QString problem = trouble();
    QString hint = problem;
    if (!m_sent &&
        entries() == Entries{std::nullopt, std::nullopt, std::nullopt, std::nullopt, std::nullopt, 0, 0, 0})
        hint =
            tr("Parameters cannot be read back from the module. The motor moves only after you apply them.");
    else if (problem.isEmpty() && m_ignoreEstop->isChecked())
        hint = tr("If checked, the E-stop input does not stop the motor.");
    else if (problem.isEmpty() && m_ignoreLimits->isChecked())
        hint = tr("If checked, the limit switches do not stop the motor.");
    look::setText(m_hint, hint);
    QString reason = m_context.reasonFor(IntentKind::SetParameters);
    if (const auto parameters = entered(); parameters && reason.isEmpty())
        if (const auto refusal = whyNotSet(*parameters, m_context.state()))
            reason = texts::refusal(*refusal);
    m_apply->setPossible(
        !reason.isEmpty()    ? reason
        : !problem.isEmpty() ? problem
                             : m_context.whyBusy(),
        m_context.state().driveOn()
            ? tr("Sends all parameters at once. The amplifier is on: currents and limits take effect immediately.")
            : tr("Sends all parameters at once. The motor does not move."));
    m_revert->setPossible(m_typed ? QString() : tr("No changes to apply."),
                          m_sent ? tr("Restores the parameters last sent. Sends nothing.")
                                 : tr("Clears the fields: no parameters have been sent yet. Sends nothing."));
}

}  // namespace nmc
