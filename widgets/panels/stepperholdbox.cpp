// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperholdbox.h"

#include <QGridLayout>
#include <QLabel>

#include "model/intent/stepperplan.h"
#include "model/intent/travel.h"
#include "model/module/stepperdefaults.h"
#include "widgets/common/foldinggrid.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperHoldBox::StepperHoldBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_label(new QLabel(tr("J&og speed"), this)),
      m_speed(new QuantityField(QuantityField::Kind::Velocity, this)),
      m_outcome(look::newMutedLabel({}, this)),
      m_forward(new HoldButton(this)),
      m_reverse(new HoldButton(this)) {
    m_speed->setName(u"stepperHoldVelocityField"_s, tr("Jog speed"));
    m_speed->setQuantity(tr("Jog speed"));
    m_speed->setNativeStep(25);
    m_outcome->setObjectName(u"stepperHoldOutcome"_s);
    m_reverse->setIcon(icons::tinted(u"hand-stop"_s));
    m_reverse->setText(tr("◂ Hold"));
    look::name(m_reverse, u"stepperHoldReverseButton"_s, tr("Hold to move in reverse"));
    m_forward->setIcon(icons::tinted(u"hand-stop"_s));
    m_forward->setText(tr("Hold ▸"));
    look::name(m_forward, u"stepperHoldForwardButton"_s, tr("Hold to move forward"));

    const int unit = look::gridUnit(this);
    auto* title = new QLabel(tr("Jog"), this);
    QFont bold = font();
    bold.setBold(true);
    title->setFont(bold);
    m_label->setBuddy(m_speed);
    auto* grid = new FoldingGrid(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 2);
    grid->addWidget(title, 0, 0);
    auto* meaning = look::newMutedLabel(tr("Moves only while you hold a button, or Space on it"), this);
    // Labels with a buddy wrap if there is little room, like those of fields.
    for (QLabel* words : {meaning, m_outcome})
        words->setBuddy(m_speed);
    grid->addWidget(meaning, 0, 1, 1, 4);
    grid->addWidget(m_label, 1, 0);
    grid->addWidget(m_speed, 1, 1);
    grid->addWidget(m_speed->unitLabel(), 1, 2);
    grid->addWidget(m_speed->otherView(), 1, 3);
    grid->addWidget(m_outcome, 2, 1, 1, 4);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(unit);
    buttons->addWidget(m_reverse);
    buttons->addWidget(m_forward);
    grid->addLayout(buttons, 1, 4);
    grid->setColumnStretch(3, 1);

    connect(m_speed, &QuantityField::nativeEdited, this, [this] {
        // A hold in progress was requested at another speed.
        endHold();
        if (const auto speed = m_speed->native())
            m_typed = speed;
        refresh();
    });
    m_forward->setDirection(HoldButton::Direction::Forward);
    m_reverse->setDirection(HoldButton::Direction::Reverse);
    connect(m_forward, &HoldButton::held, this, [this] { hold(*m_forward, false); });
    connect(m_reverse, &HoldButton::held, this, [this] { hold(*m_reverse, true); });
    for (HoldButton* button : {m_forward, m_reverse}) {
        connect(button, &HoldButton::holdEnded, &m_context, &ModuleContext::release);
        connect(&m_context, &ModuleContext::holdIntervalChanged, button, &HoldButton::setInterval);
    }
    connect(&m_context, &ModuleContext::holdMustEnd, this, &StepperHoldBox::endHold);
    connect(&m_context, &ModuleContext::lookedForAnew, this, &StepperHoldBox::lookedForAnew);
    m_context.whenSeen(this, [this] { showModule(); });
}

int StepperHoldBox::labelWidth() const {
    return m_label->sizeHint().width();
}

void StepperHoldBox::showModule() {
    const StepperState& stepper = m_context.state().stepper;
    const AxisScale scale = m_context.scale();
    const double slowest = stepperdefaults::slowestProfile(stepper, m_context.settings());
    const double cap = stepperdefaults::holdCap(stepper, m_context.settings());
    const bool otherRange = m_slowest != slowest || m_cap != cap;
    // A hold in progress was requested with another range or scale.
    if (otherRange || scale != m_speed->scale())
        endHold();
    m_slowest = slowest;
    m_cap = cap;
    m_speed->setScale(scale);
    m_speed->setNativeRange(slowest, cap);
    m_speed->setMeaning(
        tr("How fast the motor turns while you hold a button: %1 to %2. Set the max jog speed on the Parameters page.")
            .arg(texts::stepsPerSecond(slowest, scale), texts::stepsPerSecond(cap, scale)));
    if (otherRange)
        showSpeed();
    refresh();
}

void StepperHoldBox::showSpeed() {
    m_speed->showNative(std::clamp(m_typed.value_or(stepperdefaults::kHold), m_slowest, m_cap));
}

void StepperHoldBox::lookedForAnew() {
    endHold();
    m_typed.reset();
    showSpeed();
    refresh();
}

void StepperHoldBox::endHold() {
    m_forward->endHold();
    m_reverse->endHold();
}

std::optional<steppermotion::VelocityProfile> StepperHoldBox::motion(bool reverse) const {
    const auto speed = m_speed->native();
    const auto& parameters = m_context.state().stepper.parameters();
    if (!speed || !parameters)
        return std::nullopt;
    const StepperSpeed mode(parameters->speedMode);
    // Never faster than the speed in the field.
    const auto whole = std::max(1.0, std::floor(*speed / mode.unit() + 1e-9));
    return steppermotion::VelocityProfile{static_cast<std::uint8_t>(std::min(whole, 250.0)),
                                          stepperdefaults::accelerationTime(m_context.settings()),
                                          m_context.chipReverse(reverse)};
}

QString StepperHoldBox::reasonFor(bool reverse) const {
    if (const QString reason = m_context.reasonFor(IntentKind::Hold); !reason.isEmpty())
        return reason;
    const auto wanted = motion(reverse);
    if (!wanted)
        return m_speed->problemText();
    const ModuleState& module = m_context.state();
    // For a hold towards a travel limit, the bus first stops a motor that moves.
    const auto refusal = travelEnd(module, wanted->reverse)
                             ? whyNotFromStandstill(*wanted, module, IntentKind::Hold)
                             : whyNot(*wanted, module, IntentKind::Hold);
    return refusal ? texts::refusal(*refusal, intent::Move{*wanted}, module, m_context.scale()) : QString();
}

void StepperHoldBox::refresh() {
    look::setPossible(m_forward, reasonFor(false), tr("Moves forward while held, then stops."));
    look::setPossible(m_reverse, reasonFor(true), tr("Moves in reverse while held, then stops."));
    const auto wanted = motion(false);
    QString outcome = m_speed->problemText();
    if (wanted) {
        const stepper::SetParameters& parameters = *m_context.state().stepper.parameters();
        outcome = texts::profiledSpeed(StepperSpeed(parameters.speedMode), wanted->speed,
                                       parameters.minimumProfileSpeed, m_speed->scale());
    }
    look::setText(m_outcome, outcome);
}

void StepperHoldBox::hold(const HoldButton& button, bool reverse) {
    const auto wanted = motion(reverse);
    if (!wanted)
        return;
    bus::HoldToMove hold;
    hold.module = m_context.state().info.index;
    hold.reverse = wanted->reverse;
    hold.pace = bus::StepperPace{wanted->speed, wanted->accelerationTime};
    hold.press = button.press();
    m_context.hold(hold);
}

}  // namespace nmc
