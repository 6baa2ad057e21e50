// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/iovaluesbox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

#include "model/settings/pinsof.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
#include "widgets/panels/boxparts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr int kLongestAnalogUnit = 8;
constexpr double kLargestScale = 1e6;
constexpr int kValueDigits = 8;  // width of a field

}  // namespace

IoValuesBox::IoValuesBox(ModuleContext& context, QWidget* parent) : QWidget(parent), m_context(context) {
    look::name(this, u"ioValuesBox"_s, Common::tr("A/D and PWM"));
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this, FoldingGrid::Kind::Table);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    buildAnalog(*grid, 0);
    grid->setRowMinimumHeight(4, unit);
    buildPwm(*grid, 5);
    grid->setRowStretch(9, 1);
    grid->setColumnStretch(1, 1);
    m_context.whenSeen(this, [this] { showModule(); });
}

QLineEdit* IoValuesBox::newText(const QString& objectName, const QString& accessibleName) {
    auto* edit = newNameField(objectName, accessibleName, this);
    edit->setMinimumWidth(look::gridUnit(this) * 6);
    return edit;
}

NumberField* IoValuesBox::newNumber(const QString& objectName, const QString& accessibleName) {
    return form::newNumber({.name = objectName,
                            .accessible = accessibleName,
                            .min = -kLargestScale,
                            .max = kLargestScale,
                            .decimals = 6,
                            .digits = kValueDigits},
                           this);
}

void IoValuesBox::buildAnalog(QGridLayout& grid, int row) {
    const std::array<QString, 6> headings{Common::tr("A/D input"), Common::tr("Name"), tr("Reads"),
                                          tr("Per count"),         tr("At 0"),         Common::tr("Unit")};
    for (int i = 0; i < static_cast<int>(headings.size()); ++i)
        grid.addWidget(look::newMutedLabel(headings.at(static_cast<std::size_t>(i)), this), row, i);
    for (std::size_t i = 0; i < m_analog.size(); ++i) {
        Analog& input = m_analog.at(i);
        const QString number = QString::number(i + 1);
        const QString label = u"AD"_s + number;
        input.name = newText(u"analog%1Name"_s.arg(number), Common::tr("Name of %1").arg(label));
        input.value = new QLabel(this);
        look::nameText(input.value, u"analog%1Value"_s.arg(number), tr("Value of %1").arg(label));
        input.value->setFont(look::tabular(font()));
        input.perCount = newNumber(u"analog%1PerCount"_s.arg(number), tr("%1 per count").arg(label));
        input.atZero = newNumber(u"analog%1AtZero"_s.arg(number), tr("%1 at 0").arg(label));
        input.unit = form::newText({.name = u"analog%1Unit"_s.arg(number),
                                    .accessible = tr("Unit of %1").arg(label),
                                    .maxLength = kLongestAnalogUnit,
                                    .example = u"V"_s},
                                   this);
        input.unit->setMaximumWidth(look::gridUnit(this) * 5);
        const int line = row + 1 + static_cast<int>(i);
        int column = 0;
        for (QWidget* widget :
             std::initializer_list<QWidget*>{form::newLabel(label, input.name), input.name, input.value,
                                             input.perCount, input.atZero, input.unit})
            grid.addWidget(widget, line, column++);
        connect(input.name, &QLineEdit::textEdited, this, [this, i](const QString& text) {
            editAnalog(i, [text = text.toStdString()](AnalogInput& in) { in.name = text; });
        });
        connect(input.unit, &QLineEdit::textEdited, this, [this, i](const QString& text) {
            editAnalog(i, [text = text.toStdString()](AnalogInput& in) { in.scale.unit = text; });
        });
        connect(input.perCount, &NumberField::edited, this, [this, i] {
            if (const auto value = m_analog.at(i).perCount->value())
                editAnalog(i, [value](AnalogInput& in) { in.scale.perCount = *value; });
        });
        connect(input.atZero, &NumberField::edited, this, [this, i] {
            if (const auto value = m_analog.at(i).atZero->value())
                editAnalog(i, [value](AnalogInput& in) { in.scale.atZero = *value; });
        });
    }
}

void IoValuesBox::buildPwm(QGridLayout& grid, int row) {
    const std::array<QString, 5> headings{tr("PWM output"), Common::tr("Name"), tr("Now"), tr("0 to 255"),
                                          Common::tr("Off at stop")};
    for (int i = 0; i < static_cast<int>(headings.size()); ++i)
        grid.addWidget(look::newMutedLabel(headings.at(static_cast<std::size_t>(i)), this), row, i);
    for (std::size_t i = 0; i < m_pwm.size(); ++i) {
        Pwm& output = m_pwm.at(i);
        const QString number = QString::number(i + 1);
        const QString label = u"PWM"_s + number;
        output.name = newText(u"ioPwm%1Name"_s.arg(number), Common::tr("Name of %1").arg(label));
        output.state = new QLabel(this);
        look::nameText(output.state, u"ioPwm%1State"_s.arg(number), tr("Last value sent to %1").arg(label));
        output.field = form::newNumber({.name = u"ioPwm%1Field"_s.arg(number),
                                        .accessible = tr("Value of %1").arg(label),
                                        .max = 255,
                                        .digits = kValueDigits,
                                        .meaning = tr("255 is always on. Press Enter to send.")},
                                       this);
        output.offAtStop = form::newCheck({.name = u"ioPwm%1OffAtStop"_s.arg(number),
                                           .text = {},
                                           .accessible = tr("Switch %1 off on STOP ALL").arg(label)},
                                          this);
        const int line = row + 1 + static_cast<int>(i);
        grid.addWidget(form::newLabel(label, output.field), line, 0);
        grid.addWidget(output.name, line, 1);
        grid.addWidget(output.state, line, 2);
        grid.addWidget(output.field, line, 3);
        grid.addWidget(output.offAtStop, line, 4, Qt::AlignHCenter);
        connect(output.name, &QLineEdit::textEdited, this, [this, i](const QString& text) {
            editPwm(i, [text = text.toStdString()](OutputSettings& out) { out.name = text; });
        });
        connect(output.offAtStop, &QCheckBox::clicked, this,
                [this, i](bool on) { editPwm(i, [on](OutputSettings& out) { out.offAtStop = on; }); });
        connect(output.field, &NumberField::returnPressed, this,
                [this, i] { sendPwm(static_cast<unsigned>(i)); });
    }
}

void IoValuesBox::editAnalog(std::size_t number, const std::function<void(AnalogInput&)>& change) {
    m_context.edit(
        [number, change](AxisSettings& axis) { change(PinSettings::in(editPins(axis).analog, number)); });
}

void IoValuesBox::editPwm(std::size_t number, const std::function<void(OutputSettings&)>& change) {
    m_context.edit(
        [number, change](AxisSettings& axis) { change(PinSettings::in(editPins(axis).pwm, number)); });
}

void IoValuesBox::sendPwm(unsigned output) {
    const auto value = m_pwm.at(output).field->value();
    const auto other = m_pwm.at(1 - output).field->value();
    // One command sets both, and an output may not change unasked.
    const bool known = other || m_context.state().pins.pwm;
    if (value && known && !m_context.whyNot(IntentKind::SetOutputs))
        m_context.ask(iointent::SetPwm{output, static_cast<std::uint8_t>(*value),
                                       static_cast<std::uint8_t>(other.value_or(0))});
}

void IoValuesBox::showModule() {
    const PinSettings& settings = pinsOf(m_context.settings());
    const QString locked = m_context.whyLocked();
    for (std::size_t i = 0; i < m_analog.size(); ++i) {
        const AnalogInput input = PinSettings::of(settings.analog, i);
        const Analog& shown = m_analog.at(i);
        showUnlessTyped(shown.name, input.name);
        showUnlessTyped(shown.unit, input.scale.unit);
        showUnlessTyped(shown.perCount, input.scale.perCount);
        showUnlessTyped(shown.atZero, input.scale.atZero);
        setNameLocked(shown.name, locked);
        look::setPossible(shown.unit, locked, tr("The unit of the value."));
        shown.perCount->setPossible(locked, tr("The value of one A/D count."));
        shown.atZero->setPossible(locked, Common::tr("The value at an A/D reading of 0."));
    }
    for (std::size_t i = 0; i < m_pwm.size(); ++i) {
        const OutputSettings output = PinSettings::of(settings.pwm, i);
        const Pwm& shown = m_pwm.at(i);
        showUnlessTyped(shown.name, output.name);
        shown.offAtStop->setChecked(output.offAtStop);
        setNameLocked(shown.name, locked);
        look::setPossible(shown.offAtStop, locked,
                          tr("STOP ALL switches this output off. If cleared, the output stays as it is."));
    }
    refresh();
}

void IoValuesBox::refresh() {
    const ModuleState& module = m_context.state();
    const PinSettings& settings = pinsOf(m_context.settings());
    const StatusReport report = module.latest.value_or(StatusReport{});
    for (std::size_t i = 0; i < m_analog.size(); ++i) {
        look::setOld(m_analog.at(i).value, m_context.age().has_value());
        look::setReadout(m_analog.at(i).value, texts::analogReading(PinSettings::of(settings.analog, i).scale,
                                                                    report.analogs.at(i)));
    }
    const auto pwm = module.pins.pwm;
    const QString reason = m_context.reasonNow(IntentKind::SetOutputs);
    for (std::size_t i = 0; i < m_pwm.size(); ++i) {
        look::setText(m_pwm.at(i).state, pwm ? Common::tr("%1 of 255").arg(static_cast<int>(pwm->at(i)))
                                             : Common::tr("? unknown"));
        m_pwm.at(i).field->setPossible(
            reason,
            pwm ? tr("255 is always on. Press Enter to send.")
                : tr("The PWM values are unknown. Enter one for each output: both are sent together."));
    }
}

}  // namespace nmc
