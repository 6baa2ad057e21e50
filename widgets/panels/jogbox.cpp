// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/jogbox.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/common/words.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/quantitygrid.h"
#include "widgets/panels/servodefaults.h"

namespace nmc {

using namespace Qt::StringLiterals;

JogBox::JogBox(QWidget* parent) : QGroupBox(parent), m_motion(servodefaults::motionOf(AxisSettings{})) {
    look::name(this, u"jogBox"_s, tr("Jog"));
    build();
    showVelocity(m_motion);
    refresh();
}

void JogBox::build() {
    QGridLayout* grid = quantitygrid::newGrid(this);
    int line = 0;
    quantitygrid::addTitle(grid, line++, tr("Hold to move"),
                           tr("moves only while a button, or Space on it, is held"));
    m_velocity = new QuantityField(QuantityField::Kind::Velocity, this);
    m_velocity->setName(u"holdVelocityField"_s, tr("Velocity while held"));
    m_velocity->setQuantity(tr("The velocity while held"));
    m_velocity->setNativeStep(0.05);
    m_velocity->setMeaning(tr(
        "How fast the motor turns while a button is held. Low again after every connect; the cap is set on "
        "the page Axis."));
    quantitygrid::addRow(grid, line, tr("Velocit&y"), m_velocity);
    m_reverse = new HoldButton(this);
    m_reverse->setIcon(icons::tinted(u"hand-stop"_s));
    m_reverse->setText(tr("◂ Hold"));
    look::name(m_reverse, u"holdReverseButton"_s, tr("Move in reverse while held"));
    m_forward = new HoldButton(this);
    m_forward->setIcon(icons::tinted(u"hand-stop"_s));
    m_forward->setText(tr("Hold ▸"));
    look::name(m_forward, u"holdForwardButton"_s, tr("Move forward while held"));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(look::gridUnit(this));
    buttons->addWidget(m_reverse);
    buttons->addWidget(m_forward);
    grid->addLayout(buttons, line++, quantitygrid::kButtonColumn);
    m_hint = new ElidedLabel(1, this);
    m_hint->setObjectName(u"jogHint"_s);
    grid->addWidget(m_hint, line++, 0, 1, quantitygrid::kColumns);

    connect(m_velocity, &QuantityField::nativeEdited, this, [this] {
        // What is held was asked for at another speed.
        endHold();
        if (const auto velocity = m_velocity->native(); velocity && m_module)
            m_typed[m_module->info.index.value()] = *velocity;
        refresh();
    });
    connect(m_forward, &HoldButton::held, this, [this] { hold(*m_forward, false); });
    connect(m_reverse, &HoldButton::held, this, [this] { hold(*m_reverse, true); });
    for (HoldButton* button : {m_forward, m_reverse})
        connect(button, &HoldButton::holdEnded, this, &JogBox::holdReleased);
}

void JogBox::showVelocity(const MotionSettings& motion) {
    m_velocity->setNativeRange(servodefaults::kSmallest, motion.holdCap);
    const int index = m_module ? m_module->info.index.value() : -1;
    m_velocity->showNative(m_typed.value(index, qMin(motion.holdVelocity, motion.holdCap)));
}

void JogBox::resetSpeeds() {
    endHold();
    m_typed.clear();
    showVelocity(m_motion);
    refresh();
}

void JogBox::endHold() {
    m_forward->endHold();
    m_reverse->endHold();
}

void JogBox::setHoldInterval(int milliseconds) {
    m_forward->setInterval(milliseconds);
    m_reverse->setInterval(milliseconds);
}

void JogBox::showModule(const PanelView& view, std::optional<CountsPerTickSquared> acceleration) {
    const bool another = !m_module || m_module->info.index != view.module.info.index;
    const MotionSettings motion = servodefaults::motionOf(view.settings);
    // What is held was asked for with other words.
    if (another || view.scale() != m_velocity->scale() || motion.holdCap != m_motion.holdCap)
        endHold();
    const bool otherSettings =
        motion.holdCap != m_motion.holdCap || motion.holdVelocity != m_motion.holdVelocity;
    m_module = view.module;
    m_motion = motion;
    m_acceleration = acceleration;
    m_connected = view.connected;
    m_velocity->setScale(view.scale());
    if (another || otherSettings)
        showVelocity(motion);
    refresh();
}

void JogBox::refresh() {
    QString reason = texts::refusal(Refusal::NotConnected);
    if (m_connected && m_module) {
        const std::optional<Refusal> refusal = whyNot(Request::Hold, *m_module);
        reason = refusal           ? texts::refusal(*refusal)
                 : !m_acceleration ? texts::refusal(Refusal::NoAcceleration)
                                   : m_velocity->problemText();
    }
    // Never "busy": a hold that is under way must not be cut off by the answers to its own commands.
    look::setPossible(m_forward, reason, tr("Moves forward while it is held, then stops."));
    look::setPossible(m_reverse, reason, tr("Moves in reverse while it is held, then stops."));
    const QString hint = m_velocity->problemText();
    look::setText(m_hint, hint);
}

void JogBox::hold(const HoldButton& button, bool reverse) {
    const auto velocity = m_velocity->native();
    if (!velocity || !m_acceleration || !m_module)
        return;
    emit holdRequested({m_module->info.index,
                        CountsPerTick(servodefaults::toFixed(*velocity)),
                        *m_acceleration,
                        reverse,
                        {},
                        button.press()});
}

}  // namespace nmc
