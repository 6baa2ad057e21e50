// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/pwmbox.h"

#include <QLabel>

#include "widgets/common/flowlayout.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/command.h"

namespace nmc {

using namespace Qt::StringLiterals;

PwmBox::PwmBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_value(form::newNumber(
          {.name = u"pwmField"_s,
           .accessible = Common::tr("PWM value"),
           .words = tr("The PWM value"),
           .min = servo::kByteRange.min,
           .max = servo::kByteRange.max,
           .digits = 8,
           .meaning = tr("The share of the supply that drives the motor; 255 is full power.")},
          this)),
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
                         .text = Common::tr("Motor off"),
                         .accessible = Common::tr("Motor off: this module")},
                        this, [this] { m_context.ask(intent::MotorOff{}); })) {
    look::name(this, u"pwmBox"_s, Common::tr("PWM"));
    m_value->showValue(0);

    auto* sign = new GlyphLabel(this);
    sign->showSeverity(Severity::Attention);
    QLabel* warning = form::newParagraph(u"pwmWarning"_s, {}, this);
    warning->setText(tr(
        "PWM drives the motor directly, without the servo. No position, position error or output limit protects it, and it runs until you switch it off."));
    auto* grid = new FormGrid(this, 4, {.ends = 1, .across = 1, .down = 1});
    grid->addWidget(sign, 0, 0, Qt::AlignTop | Qt::AlignRight);
    grid->addWide(warning, 1);
    grid->addRow(Common::tr("PWM value"), m_value, {m_percent});
    grid->addWide(
        new FlowLayout(look::gridUnit(this), {m_reverse->button(), m_forward->button(), m_off->button()}));
    grid->end();

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
        Common::tr("Switches servo and amplifier off: the motor is free to turn, and a load may fall."));
}

}  // namespace nmc
