// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperiobox.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>

#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

std::string& outputName(AxisSettings& axis, std::size_t number) {
    return axis.outputNames.at(number);
}

std::string& inputName(AxisSettings& axis, std::size_t number) {
    return axis.inputNames.at(number);
}

}  // namespace

StepperIoBox::StepperIoBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_send(new Command(
          {.name = u"stepperSetOutputsButton"_s, .icon = u"send"_s, .text = tr("Set all outputs")}, this,
          [this] { sendAll(); })),
      m_hint(form::newRemark({}, this, u"stepperOutputsHint"_s)),
      m_analog(new QLabel(this)) {
    look::name(this, u"stepperIoBox"_s, tr("Inputs and outputs"));
    m_analog->setObjectName(u"stepperIoAnalog"_s);
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 1});
    buildOutputs(grid);
    grid->addGap(1);
    buildInputs(grid);
    grid->end();
    m_context.whenSeen(this, [this] { showModule(); });
}

QLineEdit* StepperIoBox::newName(const QString& objectName, const QString& accessibleName, Name name,
                                 std::size_t number) {
    auto* field = newNameField(objectName, accessibleName, this);
    connect(field, &QLineEdit::textEdited, this, [this, name, number](const QString& text) {
        m_context.edit([=](AxisSettings& axis) { name(axis, number) = text.toStdString(); });
    });
    return field;
}

void StepperIoBox::buildOutputs(FormGrid* grid) {
    grid->addWide(form::newHeading(Common::tr("Outputs"), this));
    for (std::size_t i = 0; i < kOutputs; ++i) {
        Output& output = m_outputs[i];
        const QString number = QString::number(i + 1);
        output.box = form::newCheck({.name = u"stepperOutput%1Box"_s.arg(number),
                                     .text = u"OUT"_s + number,
                                     .accessible = tr("OUT%1").arg(number)},
                                    this);
        output.state = look::newMutedLabel({}, this, u"stepperOutput%1State"_s.arg(number));
        output.name =
            newName(u"stepperOutput%1Name"_s.arg(number), tr("Name of output %1").arg(number), outputName, i);
        grid->addLine({output.box, output.state, {output.name, 1}});
        connect(output.box, &QCheckBox::clicked, this, [this, i](bool on) { choose(i, on); });
    }
    grid->addWide(form::newLine(this, {m_send->button(), nullptr}));
    grid->addWide(m_hint);
}

void StepperIoBox::buildInputs(FormGrid* grid) {
    grid->addWide(form::newHeading(tr("Inputs"), this));
    const std::array<QString, kInputs> names{
        Common::tr("E-stop input"), u"IN1"_s, u"IN2"_s, Common::tr("Limit 1"), Common::tr("Limit 2"),
        Common::tr("Home switch")};
    const std::array<QString, kInputs> objects{u"stepperEstopInput"_s,  u"stepperIn1Input"_s,
                                               u"stepperIn2Input"_s,    u"stepperLimit1Input"_s,
                                               u"stepperLimit2Input"_s, u"stepperHomeInput"_s};
    for (std::size_t i = 0; i < kInputs; ++i) {
        Input& input = m_inputs[i];
        input.glyph = new GlyphLabel(this);
        input.glyph->showBit(std::nullopt);
        input.state = look::newMutedLabel(u"–"_s, this, objects[i]);
        QWidget* last = nullptr;
        if (i == 1 || i == 2) {
            input.name =
                newName(u"stepperInput%1Name"_s.arg(i), tr("Name of input %1").arg(i), inputName, i - 1);
            last = input.name;
        } else {
            input.effect = look::newMutedLabel({}, this, objects[i] + u"Effect"_s);
            last = input.effect;
        }
        grid->addLine({form::newLine(this, {input.glyph, new QLabel(names[i], this), nullptr}, 0.5),
                       input.state,
                       {last, 1}});
    }
    grid->addTitled(Common::tr("A/D (temperature)"), m_analog);
}

void StepperIoBox::showNames() {
    const auto show = [this](QLineEdit* field, const std::string& name) {
        showUnlessTyped(field, name);
        setNameLocked(field, m_context.whyLocked());
    };
    for (std::size_t i = 0; i < kOutputs; ++i)
        show(m_outputs[i].name, m_context.settings().outputNames[i]);
    for (std::size_t i = 0; i < m_context.settings().inputNames.size(); ++i)
        show(m_inputs[i + 1].name, m_context.settings().inputNames[i]);
}

void StepperIoBox::showModule() {
    if (m_context.state().stepper.outputs)
        m_staged = {};
    showNames();
    refresh();
}

void StepperIoBox::choose(std::size_t output, bool on) {
    if (const auto known = m_context.state().stepper.outputs) {
        const unsigned bit = 1U << output;
        const unsigned outputs = on ? *known | bit : *known & ~bit;
        m_context.ask(stepperintent::SetOutputs{static_cast<std::uint8_t>(outputs)});
    } else {
        m_staged[output] = on;
    }
    // The box shows what was confirmed, not what was clicked.
    refresh();
}

std::optional<std::uint8_t> StepperIoBox::staged() const {
    unsigned outputs = 0;
    for (std::size_t i = 0; i < kOutputs; ++i) {
        if (!m_staged[i])
            return std::nullopt;
        outputs |= *m_staged[i] ? 1U << i : 0U;
    }
    return static_cast<std::uint8_t>(outputs);
}

void StepperIoBox::sendAll() {
    if (const auto outputs = staged())
        m_context.ask(stepperintent::SetOutputs{*outputs});
}

QString StepperIoBox::effectOf(std::size_t input, bool active) const {
    const auto& parameters = m_context.state().stepper.parameters;
    const bool limitsIgnored = parameters && parameters->ignoreLimits;
    const auto blocked = [this](bool reverse) {
        return m_context.chipReverse(reverse) ? tr("blocks reverse") : tr("blocks forward");
    };
    const bool estopIgnored = parameters && parameters->ignoreEstop;
    switch (input) {
        case 0:
            return estopIgnored ? tr("ignored") : active ? tr("keeps the motor from moving") : QString();
        case 3:
            return limitsIgnored ? tr("ignored") : active ? blocked(false) : QString();
        case 4:
            return limitsIgnored ? tr("ignored") : active ? blocked(true) : QString();
        default:
            return {};
    }
}

void StepperIoBox::refresh() {
    const ModuleState& module = m_context.state();
    const auto known = module.stepper.outputs;
    const QString reason = m_context.reasonNow(IntentKind::SetOutputs);
    for (std::size_t i = 0; i < kOutputs; ++i) {
        const Output& output = m_outputs[i];
        const auto on = known ? std::optional(bitOf(*known, i)) : m_staged[i];
        const QSignalBlocker blocker(output.box);
        output.box->setTristate(!on);
        output.box->setCheckState(!on ? Qt::PartiallyChecked : *on ? Qt::Checked : Qt::Unchecked);
        const QString level = on ? *on ? Common::tr("high") : Common::tr("low") : QString();
        look::setText(output.state, !on     ? Common::tr("? unknown")
                                    : known ? level
                                            : tr("● %1, not sent").arg(level));
        look::setPossible(output.box, reason,
                          known ? Common::tr("Switches this output at once.")
                                : tr("Selects the level. Choose Set all outputs to send all five."));
    }
    m_send->setVisible(!known);
    m_send->setPossible(!reason.isEmpty() ? reason
                        : staged()        ? QString()
                                          : tr("Select a level for all five outputs first."),
                        tr("Sends all five outputs as selected above."));
    look::setText(
        m_hint,
        known ? QString()
              : tr("Outputs unknown: they cannot be read back. Select all five levels, then set them."));
    const StatusReport report = module.latest.value_or(StatusReport{});
    const std::optional<std::uint8_t>& inputs = report.aux;
    for (std::size_t i = 0; i < kInputs; ++i) {
        const Input& input = m_inputs[i];
        const bool active = inputs && bitOf(*inputs, i);
        input.glyph->showBit(inputs ? std::optional(active) : std::nullopt);
        look::setText(input.state, !inputs ? u"–"_s : active ? Common::tr("high") : Common::tr("low"));
        if (input.effect != nullptr)
            look::setText(input.effect, inputs ? effectOf(i, active) : QString());
    }
    look::setText(m_analog, texts::analogReading(m_context.settings().analog, report.analog));
}

}  // namespace nmc
