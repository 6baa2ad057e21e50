// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/pwmbox.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/glyphs.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/numberfield.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

PwmBox::PwmBox(QWidget* parent)
    : QWidget(parent),
      m_value(new NumberField(0, this)),
      m_percent(look::newMutedLabel({}, this)),
      m_reverse(new QPushButton(icons::tinted(u"arrow-left"_s), tr("Drive reverse"), this)),
      m_forward(new QPushButton(icons::tinted(u"arrow-right"_s), tr("Drive forward"), this)),
      m_off(new QPushButton(icons::tinted(u"bolt"_s), tr("Motor off"), this)) {
    look::name(this, u"pwmBox"_s, tr("PWM"));
    look::name(m_value, u"pwmField"_s, tr("PWM value"));
    m_value->setRange(servo::kByteRange.min, servo::kByteRange.max);
    m_value->setWords(tr("The PWM value"), {});
    m_value->setMeaning(tr("How much of the supply drives the motor: 255 is all of it."));
    m_value->setDigits(8);
    m_value->showValue(0);
    look::name(m_reverse, u"pwmReverseButton"_s, tr("Drive the motor in reverse with this PWM value"));
    look::name(m_forward, u"pwmForwardButton"_s, tr("Drive the motor forward with this PWM value"));
    look::name(m_off, u"pwmOffButton"_s, tr("Switch this motor off"));

    auto* sign = new GlyphLabel(this);
    sign->showSeverity(Severity::Attention);
    auto* warning = new QLabel(tr("The motor is driven directly, without the servo: no position limit, no "
                                  "position error limit and no "
                                  "output limit protects it, and it runs until it is switched off."),
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
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addWidget(m_reverse);
    buttons->addWidget(m_forward);
    buttons->addSpacing(unit);
    buttons->addWidget(m_off);
    buttons->addStretch(1);
    grid->addLayout(buttons, 2, 0, 1, 4);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(3, 1);

    connect(m_value, &NumberField::edited, this, &PwmBox::refresh);
    connect(m_reverse, &QPushButton::clicked, this, [this] { drive(true); });
    connect(m_forward, &QPushButton::clicked, this, [this] { drive(false); });
    connect(m_off, &QPushButton::clicked, this, [this] { emit intentRequested(intent::MotorOff{}); });
    refresh();
}

void PwmBox::showModule(const PanelView& view) {
    if (!m_module || m_module->info.index != view.module.info.index)
        m_value->showValue(0);
    m_module = view.module;
    m_connected = view.connected;
    refresh();
}

void PwmBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void PwmBox::drive(bool reverse) {
    if (const auto value = m_value->value(); value && m_forward->isEnabled())
        emit intentRequested(intent::DrivePwm{static_cast<std::uint8_t>(*value), reverse});
}

void PwmBox::refresh() {
    const auto value = m_value->value();
    look::setText(m_percent, value ? tr("= %1 %").arg(qRound(*value * 100.0 / 255.0)) : u"–"_s);
    const bool connected = m_connected && m_module;
    const auto reasonFor = [&](Request request) {
        const auto refusal = connected ? whyNot(request, *m_module) : std::optional(Refusal::NotConnected);
        return refusal ? texts::refusal(*refusal) : QString();
    };
    QString reason = reasonFor(Request::DrivePwm);
    if (reason.isEmpty())
        reason = m_busy ? tr("Waiting for the module's answer.") : m_value->problemText();
    look::setPossible(m_reverse, reason, tr("Drives the motor in reverse until it is switched off."));
    look::setPossible(m_forward, reason, tr("Drives the motor forward until it is switched off."));
    look::setPossible(
        m_off, reasonFor(Request::MotorOff),
        tr("Switches servo and amplifier off: the motor is free to turn, and a load may fall."));
}

}  // namespace nmc
