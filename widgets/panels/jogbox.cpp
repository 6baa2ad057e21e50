// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/jogbox.h"

#include <QGridLayout>
#include <QLabel>

#include "model/intent/travel.h"
#include "model/module/servodefaults.h"
#include "widgets/common/elidedlabel.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/motionbox.h"
#include "widgets/panels/quantitygrid.h"

namespace nmc {

using namespace Qt::StringLiterals;

JogBox::JogBox(ModuleContext& context, const MotionBox& motion, QWidget* parent)
    : QGroupBox(parent),
      m_context(context),
      m_motionBox(motion),
      m_motion(servodefaults::motionOf(context.settings())) {
    look::name(this, u"jogBox"_s, tr("Jog"));
    build();
    m_velocity->setScale(m_context.scale());
    showVelocity();
    connect(&m_context, &ModuleContext::holdMustEnd, this, &JogBox::endHold);
    connect(&m_context, &ModuleContext::lookedForAnew, this, &JogBox::lookedForAnew);
    connect(&m_motionBox, &MotionBox::accelerationEdited, this, &JogBox::endHold);
    m_context.whenSeen(this, [this] { showModule(); });
}

void JogBox::build() {
    QGridLayout* grid = quantitygrid::newGrid(this);
    int line = 0;
    m_velocity = new QuantityField(QuantityField::Kind::Velocity, this);
    m_velocity->setName(u"holdVelocityField"_s, tr("Jog speed"));
    m_velocity->setQuantity(tr("Jog speed"));
    m_velocity->setNativeStep(0.05);
    m_velocity->setMeaning(tr(
        "How fast the motor turns while you hold a button, or Space on it. Returns to a low value on every connect; set the max jog speed on the Axis page."));
    quantitygrid::addFirstRow(grid, line, tr("J&og speed"), m_velocity);
    m_reverse = new HoldButton(this);
    m_reverse->setIcon(icons::tinted(u"hand-stop"_s));
    m_reverse->setText(tr("◂ Hold"));
    look::name(m_reverse, u"holdReverseButton"_s, tr("Hold to move in reverse"));
    m_forward = new HoldButton(this);
    m_forward->setIcon(icons::tinted(u"hand-stop"_s));
    m_forward->setText(tr("Hold ▸"));
    look::name(m_forward, u"holdForwardButton"_s, tr("Hold to move forward"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_reverse);
    buttons->addWidget(m_forward);
    grid->addLayout(buttons, line++, quantitygrid::kButtonColumn);
    m_hint = new ElidedLabel(1, this);
    m_hint->setObjectName(u"jogHint"_s);
    grid->addWidget(m_hint, line++, 0, 1, quantitygrid::kColumns);

    connect(m_velocity, &QuantityField::nativeEdited, this, [this] {
        // A hold in progress was requested at another speed.
        endHold();
        if (const auto velocity = m_velocity->native())
            m_typed = velocity;
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
}

void JogBox::showVelocity() {
    m_velocity->setNativeRange(servodefaults::kSmallest, m_motion.holdCap);
    m_velocity->setRangeReason(texts::jogReason());
    m_velocity->showNative(m_typed.value_or(qMin(m_motion.holdVelocity, m_motion.holdCap)));
}

void JogBox::lookedForAnew() {
    endHold();
    m_typed.reset();
    showVelocity();
    refresh();
}

void JogBox::endHold() {
    m_forward->endHold();
    m_reverse->endHold();
}

void JogBox::showModule() {
    const MotionSettings motion = servodefaults::motionOf(m_context.settings());
    const bool otherCap = motion.holdCap != m_motion.holdCap;
    const bool others = otherCap || motion.holdVelocity != m_motion.holdVelocity;
    // A hold in progress was requested with another cap or scale.
    if (otherCap || m_context.scale() != m_velocity->scale())
        endHold();
    m_motion = motion;
    m_velocity->setScale(m_context.scale());
    if (others)
        showVelocity();
    refresh();
}

void JogBox::refresh() {
    // Never "busy": a hold in progress must not end because it waits for the answers to its own commands.
    look::setPossible(m_forward, reasonFor(false), tr("Moves forward while held, then stops."));
    look::setPossible(m_reverse, reasonFor(true), tr("Moves in reverse while held, then stops."));
    look::setText(m_hint, m_velocity->problemText());
}

QString JogBox::reasonFor(bool reverse) const {
    if (const QString reason = m_context.reasonFor(IntentKind::Hold); !reason.isEmpty())
        return reason;
    const auto hold = wanted(reverse);
    if (!hold)
        return m_motionBox.acceleration() ? m_velocity->problemText()
                                          : texts::refusal(Refusal::NoAcceleration);
    const auto within = withinTravel(*hold, m_context.state());
    return within ? QString() : texts::travelProblem(within.error(), m_velocity->scale());
}

std::optional<bus::HoldToMove> JogBox::wanted(bool reverse) const {
    const auto velocity = m_velocity->native();
    const auto acceleration = m_motionBox.acceleration();
    if (!velocity || !acceleration)
        return std::nullopt;
    bus::HoldToMove hold;
    hold.module = m_context.state().info.index;
    hold.velocity = CountsPerTick(servodefaults::toFixed(*velocity));
    hold.acceleration = *acceleration;
    hold.reverse = m_context.chipReverse(reverse);
    return hold;
}

void JogBox::hold(const HoldButton& button, bool reverse) {
    auto hold = wanted(reverse);
    if (!hold)
        return;
    hold->press = button.press();
    m_context.hold(*hold);
}

}  // namespace nmc
