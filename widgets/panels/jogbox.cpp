// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/jogbox.h"

#include "widgets/common/elidedlabel.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/travelwords.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

JogBox::JogBox(ModuleContext& context, QWidget* parent)
    : QGroupBox(parent),
      m_context(context),
      m_reverse(newHold(true)),
      m_forward(newHold(false)),
      m_outcome(new ElidedLabel(1, this)) {
    look::name(this, m_context.named(u"jogBox"_s), Common::tr("Jog"));
    m_speed = form::newQuantity({.kind = QuantityField::Kind::Velocity,
                                 .name = m_context.named(u"holdVelocityField"_s),
                                 .accessible = tr("Jog speed"),
                                 .step = m_context.state().isStepper() ? 25 : 0.05},
                                this);
    m_outcome->setObjectName(m_context.named(u"jogHint"_s));
    auto* grid = new FormGrid(this);
    form::setBold(grid->addRow(tr("J&og speed"), m_speed, {form::newLine(this, {m_reverse, m_forward})}));
    grid->addWide(m_outcome);
    m_speed->setScale(m_context.scale());
    connect(m_speed, &QuantityField::nativeEdited, this, [this] {
        endHold();
        if (const auto speed = m_speed->native())
            m_typed = speed;
        refresh();
    });
    connect(&m_context, &ModuleContext::holdMustEnd, this, &JogBox::endHold);
    connect(&m_context, &ModuleContext::lookedForAnew, this, &JogBox::lookedForAnew);
    m_context.whenSeen(this, [this] { showModule(); });
}

HoldButton* JogBox::newHold(bool reverse) {
    auto* button = newJogButton(
        m_context, reverse, [this, reverse](double share) { return wanted(reverse, share); }, this);
    look::name(button, m_context.named(reverse ? u"holdReverseButton"_s : u"holdForwardButton"_s),
               reverse ? tr("Hold to move in reverse") : tr("Hold to move forward"));
    button->setDirection(reverse ? HoldButton::Direction::Reverse : HoldButton::Direction::Forward);
    return button;
}

void JogBox::showSpeed() {
    m_speed->showNative(std::clamp(m_typed.value_or(m_range.first), m_range.slowest, m_range.cap));
}

void JogBox::lookedForAnew() {
    endHold();
    m_typed.reset();
    showSpeed();
    refresh();
}

void JogBox::endHold() {
    m_forward->endHold();
    m_reverse->endHold();
}

void JogBox::showModule() {
    const JogRange range = jogRange(m_context.state(), m_context.settings());
    const AxisScale scale = m_context.scale();
    const bool otherRange = range != m_range;
    if (otherRange || scale != m_speed->scale())
        endHold();
    m_range = range;
    m_speed->setScale(scale);
    m_speed->setNativeRange(range.slowest, range.cap);
    if (m_context.state().isStepper()) {
        m_speed->setMeaning(
            tr("How fast the motor turns while you hold a button, or Space on it: %1 to %2. Set the max jog speed on the Parameters page.")
                .arg(texts::stepsPerSecond(range.slowest, scale), texts::stepsPerSecond(range.cap, scale)));
    } else {
        m_speed->setRangeReason(texts::jogReason());
        m_speed->setMeaning(tr(
            "How fast the motor turns while you hold a button, or Space on it. Returns to a low value at each connection; set the max jog speed on the Axis page."));
    }
    if (otherRange)
        showSpeed();
    refresh();
}

void JogBox::refresh() {
    // Never "busy": a hold in progress must not end because it waits for the answers to its own commands.
    look::setPossible(m_forward, reasonFor(false), Common::tr("Moves forward while held, then stops."));
    look::setPossible(m_reverse, reasonFor(true), Common::tr("Moves in reverse while held, then stops."));
    look::setText(m_outcome, outcome());
}

QString JogBox::outcome() const {
    const auto hold = wanted(false);
    if (!hold || !hold->pace)
        return m_speed->problemText();
    const stepper::SetParameters& parameters = *m_context.state().stepper.parameters;
    return texts::profiledSpeed(StepperSpeed(parameters.speedMode), hold->pace->speed,
                                parameters.minimumProfileSpeed, m_speed->scale());
}

QString JogBox::reasonFor(bool reverse) const {
    if (const auto hold = wanted(reverse))
        return m_context.reasonFor(*hold);
    const QString reason = m_context.reasonFor(IntentKind::Hold);
    return reason.isEmpty() ? m_speed->problemText() : reason;
}

std::optional<bus::HoldToMove> JogBox::wanted(bool reverse, double share) const {
    const auto speed = m_speed->native();
    return speed ? jog(m_context.state(), m_context.settings(), std::max(*speed * share, m_range.slowest),
                       m_context.chipReverse(reverse))
                 : std::nullopt;
}

}  // namespace nmc
