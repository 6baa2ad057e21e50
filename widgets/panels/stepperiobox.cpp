// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperiobox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

#include "widgets/common/foldinggrid.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

std::string& outputName(AxisSettings& axis, std::size_t number) {
    return axis.outputNames.at(number);
}

std::string& inputName(AxisSettings& axis, std::size_t number) {
    return axis.inputNames.at(number);
}

QLabel* newHeading(const QString& text, QWidget* parent) {
    auto* heading = new QLabel(text, parent);
    QFont bold = parent->font();
    bold.setBold(true);
    heading->setFont(bold);
    return heading;
}

}  // namespace

StepperIoBox::StepperIoBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_send(new Command({.name = u"stepperSetOutputsButton"_s,
                          .icon = u"send"_s,
                          .text = tr("Set all outputs"),
                          .accessible = tr("Set all outputs")},
                         this, [this] { sendAll(); })),
      m_hint(look::newMutedLabel({}, this)),
      m_analog(new QLabel(this)) {
    look::name(this, u"stepperIoBox"_s, tr("Inputs and outputs"));
    m_hint->setObjectName(u"stepperOutputsHint"_s);
    m_hint->setWordWrap(true);
    m_analog->setObjectName(u"stepperIoAnalog"_s);
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    buildOutputs(grid);
    grid->setRowMinimumHeight(8, unit);
    buildInputs(grid, 9);
    grid->setRowStretch(18, 1);
    grid->setColumnStretch(3, 1);
    m_context.whenSeen(this, [this] { showModule(); });
}

QLineEdit* StepperIoBox::newName(const QString& objectName, const QString& accessibleName, Name name,
                                 std::size_t number) {
    auto* field = new QLineEdit(this);
    look::name(field, objectName, accessibleName);
    field->setMaxLength(kMaxNameLength);
    field->setPlaceholderText(tr("name"));
    field->setToolTip(tr("Its name on this machine. Sends nothing."));
    connect(field, &QLineEdit::textEdited, this, [this, name, number](const QString& text) {
        m_context.edit([=](AxisSettings& axis) { name(axis, number) = text.toStdString(); });
    });
    return field;
}

void StepperIoBox::buildOutputs(QGridLayout* grid) {
    grid->addWidget(newHeading(tr("Outputs"), this), 0, 0, 1, 4);
    for (std::size_t i = 0; i < kOutputs; ++i) {
        Output& output = m_outputs[i];
        const QString number = QString::number(i + 1);
        const int line = static_cast<int>(i) + 1;
        output.box = new QCheckBox(u"OUT"_s + number, this);
        look::name(output.box, u"stepperOutput%1Box"_s.arg(number), tr("OUT%1").arg(number));
        output.state = look::newMutedLabel({}, this);
        output.state->setObjectName(u"stepperOutput%1State"_s.arg(number));
        output.name =
            newName(u"stepperOutput%1Name"_s.arg(number), tr("Name of output %1").arg(number), outputName, i);
        grid->addWidget(output.box, line, 0);
        grid->addWidget(output.state, line, 1);
        grid->addWidget(output.name, line, 2, 1, 2);
        connect(output.box, &QCheckBox::clicked, this, [this, i](bool on) { choose(i, on); });
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(look::gridUnit(this));
    row->addWidget(m_send->button());
    row->addStretch(1);
    grid->addLayout(row, 6, 0, 1, 4);
    grid->addWidget(m_hint, 7, 0, 1, 4);
}

void StepperIoBox::buildInputs(QGridLayout* grid, int line) {
    grid->addWidget(newHeading(tr("Inputs"), this), line, 0, 1, 4);
    const std::array<QString, kInputs> names{tr("E-stop input"), u"IN1"_s,      u"IN2"_s,
                                             tr("Limit 1"),      tr("Limit 2"), tr("Home switch")};
    const std::array<QString, kInputs> objects{u"stepperEstopInput"_s,  u"stepperIn1Input"_s,
                                               u"stepperIn2Input"_s,    u"stepperLimit1Input"_s,
                                               u"stepperLimit2Input"_s, u"stepperHomeInput"_s};
    for (std::size_t i = 0; i < kInputs; ++i) {
        Input& input = m_inputs[i];
        const int row = line + 1 + static_cast<int>(i);
        input.glyph = new GlyphLabel(this);
        input.glyph->showBit(std::nullopt);
        input.state = look::newMutedLabel(u"–"_s, this);
        input.state->setObjectName(objects[i]);
        auto* who = new QHBoxLayout;
        who->setSpacing(look::gridUnit(this) / 2);
        who->addWidget(input.glyph);
        who->addWidget(new QLabel(names[i], this));
        who->addStretch(1);
        grid->addLayout(who, row, 0);
        grid->addWidget(input.state, row, 1);
        if (i == 1 || i == 2) {
            input.name =
                newName(u"stepperInput%1Name"_s.arg(i), tr("Name of input %1").arg(i), inputName, i - 1);
            grid->addWidget(input.name, row, 2, 1, 2);
        } else {
            input.effect = look::newMutedLabel({}, this);
            input.effect->setObjectName(objects[i] + u"Effect"_s);
            grid->addWidget(input.effect, row, 2, 1, 2);
        }
    }
    const int row = line + 1 + static_cast<int>(kInputs);
    grid->addWidget(new QLabel(tr("A/D (temperature)"), this), row, 0);
    grid->addWidget(m_analog, row, 1, 1, 3);
}

void StepperIoBox::showNames() {
    const auto show = [](QLineEdit* edit, const std::string& name) {
        const QString text = QString::fromStdString(name);
        if (edit->text() != text && !edit->hasFocus())
            edit->setText(text);
    };
    for (std::size_t i = 0; i < kOutputs; ++i)
        show(m_outputs[i].name, m_context.settings().outputNames[i]);
    for (std::size_t i = 0; i < m_context.settings().inputNames.size(); ++i)
        show(m_inputs[i + 1].name, m_context.settings().inputNames[i]);
}

void StepperIoBox::showModule() {
    if (m_context.state().stepper.outputs())
        m_staged = {};
    showNames();
    refresh();
}

void StepperIoBox::choose(std::size_t output, bool on) {
    if (const auto known = m_context.state().stepper.outputs()) {
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
    const auto& parameters = m_context.state().stepper.parameters();
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
    const auto known = module.stepper.outputs();
    const QString reason = m_context.reasonNow(IntentKind::SetOutputs);
    for (std::size_t i = 0; i < kOutputs; ++i) {
        const Output& output = m_outputs[i];
        const auto on = known ? std::optional(bitOf(*known, i)) : m_staged[i];
        const QSignalBlocker blocker(output.box);
        output.box->setTristate(!on);
        output.box->setCheckState(!on ? Qt::PartiallyChecked : *on ? Qt::Checked : Qt::Unchecked);
        const QString level = on ? *on ? tr("high") : tr("low") : QString();
        look::setText(output.state, !on ? tr("? unknown") : known ? level : tr("● %1, not sent").arg(level));
        look::setPossible(output.box, reason,
                          known ? tr("Switches this output at once.")
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
        look::setText(input.state, !inputs ? u"–"_s : active ? tr("high") : tr("low"));
        if (input.effect != nullptr)
            look::setText(input.effect, inputs ? effectOf(i, active) : QString());
    }
    look::setText(m_analog,
                  report.analog ? texts::analogReading(m_context.settings().analog, *report.analog) : u"–"_s);
}

}  // namespace nmc
