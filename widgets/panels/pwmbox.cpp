// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/pwmbox.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/common/flowlayout.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

PwmBox::PwmBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_value(new NumberField(0, this)),
      m_percent(look::newMutedLabel({}, this)),
      m_reverse(new Command({.name = u"pwmReverseButton"_s,
                             .icon = u"arrow-left"_s,
                             .text = tr("Drive reverse"),
                             .accessible = tr("Drive reverse with this PWM value")},
                            this, [this] { drive(true); })),
      m_forward(new Command({.name = u"pwmForwardButton"_s,
                             .icon = u"arrow-right"_s,
                             .text = tr("Drive forward"),
                             .accessible = tr("Drive forward with this PWM value")},
                            this, [this] { drive(false); })),
      m_off(new Command({.name = u"pwmOffButton"_s,
                         .icon = u"bolt"_s,
                         .text = tr("Motor off"),
                         .accessible = tr("Motor off: this module")},
                        this, [this] { m_context.ask(intent::MotorOff{}); })) {
    look::name(this, u"pwmBox"_s, tr("PWM"));
    look::name(m_value, u"pwmField"_s, tr("PWM value"));
    m_value->setRange(servo::kByteRange.min, servo::kByteRange.max);
    m_value->setWords(tr("The PWM value"), {});
    m_value->setMeaning(tr("The share of the supply that drives the motor; 255 is full power."));
    m_value->setDigits(8);
    m_value->showValue(0);

    auto* sign = new GlyphLabel(this);
    sign->showSeverity(Severity::Attention);
    auto* warning = new QLabel(
        tr("PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off."),
        this);
    warning->setObjectName(u"pwmWarning"_s);
    warning->setWordWrap(true);
    auto* label = new QLabel(tr("PWM value"), this);
    label->setBuddy(m_value);

    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit);
    grid->addWidget(sign, 0, 0, Qt::AlignTop | Qt::AlignRight);
    grid->addWidget(warning, 0, 1, 1, 3);
    grid->addWidget(label, 1, 0);
    grid->addWidget(m_value, 1, 1);
    grid->addWidget(m_percent, 1, 2);
    auto* buttons = new FlowLayout(unit);
    for (const Command* command : {m_reverse, m_forward, m_off})
        buttons->addWidget(command->button());
    grid->addLayout(buttons, 2, 0, 1, 4);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(3, 1);

    connect(m_value, &NumberField::edited, this, &PwmBox::refresh);
    m_context.whenSeen(this, [this] { refresh(); });
}

void PwmBox::drive(bool reverse) {
    if (const auto value = m_value->value())
        m_context.ask(intent::DrivePwm{static_cast<std::uint8_t>(*value), m_context.chipReverse(reverse)});
}

void PwmBox::refresh() {
    const auto value = m_value->value();
    look::setText(m_percent, value ? tr("= %1 %").arg(qRound(*value * 100.0 / 255.0)) : u"–"_s);
    QString reason = m_context.reasonNow(IntentKind::DrivePwm);
    if (reason.isEmpty())
        reason = m_value->problemText();
    const auto reasonOf = [&](bool reverse) {
        const intent::DrivePwm drive{static_cast<std::uint8_t>(value.value_or(0)),
                                     m_context.chipReverse(reverse)};
        return reason.isEmpty() ? m_context.reasonFor(Intent(drive)) : reason;
    };
    m_reverse->setPossible(reasonOf(true), tr("Drives the motor in reverse until you switch it off."));
    m_forward->setPossible(reasonOf(false), tr("Drives the motor forward until you switch it off."));
    m_off->setPossible(
        m_context.reasonFor(IntentKind::MotorOff),
        tr("Switches servo and amplifier off: the motor is free to turn, and a load may fall."));
}

}  // namespace nmc
