// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperdetailsbox.h"

#include <QLabel>

#include "model/module/stepperdefaults.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString stepperStatusMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        StepperDetailsBox::tr("The module is sending step pulses."),
        Common::tr("The module received a garbled command and did not carry it out."),
        StepperDetailsBox::tr("The driver is enabled (AMP_EN is high)."),
        StepperDetailsBox::tr("Motor power is present (PWR_SENSE is high)."),
        StepperDetailsBox::tr("The motor has reached its commanded speed."),
        StepperDetailsBox::tr("Runs with a ramp: velocity profile mode."),
        StepperDetailsBox::tr("Moves to a position with a ramp: trapezoidal profile mode."),
        Common::tr("Waiting for the home position.")};
    return meanings[bit];
}

QString inputMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        StepperDetailsBox::tr("High stops the motor, unless it is ignored."),
        StepperDetailsBox::tr("General purpose input."),
        StepperDetailsBox::tr("General purpose input."),
        StepperDetailsBox::tr("High blocks counting up, unless it is ignored."),
        StepperDetailsBox::tr("High blocks counting down, unless it is ignored."),
        StepperDetailsBox::tr("For homing."),
        QString(),
        QString()};
    return meanings[bit];
}

QString modeName(StepperMode mode) {
    switch (mode) {
        case StepperMode::Stopped:
            return StepperDetailsBox::tr("stopped");
        case StepperMode::Trapezoidal:
            return StepperDetailsBox::tr("trapezoidal profile");
        case StepperMode::VelocityProfile:
            return StepperDetailsBox::tr("velocity profile");
        case StepperMode::UnprofiledWithStop:
            return StepperDetailsBox::tr("unprofiled, with stop");
        case StepperMode::Unprofiled:
            return StepperDetailsBox::tr("unprofiled, without stop");
        case StepperMode::Unknown:
            return StepperDetailsBox::tr("moving, commanded by another program");
    }
    return {};
}

}  // namespace

StepperDetailsBox::StepperDetailsBox(ModuleContext& context, QWidget* parent)
    : StatusTable(context, parent),
      m_zero(new Command({.name = u"stepperZeroHereButton"_s,
                          .icon = u"eraser"_s,
                          .text = tr("&Zero here"),
                          .accessible = Common::tr("Zero here: set the present position to 0")},
                         this, [this] { m_context.ask(intent::ResetPosition{}); })) {
    look::name(this, u"stepperDetailsBox"_s, Common::tr("Details"));
    addBits(Byte::First, Common::tr("Status byte"), stepper::kStatusBitNames, stepperStatusMeaning);
    addBits(Byte::Second, tr("Inputs byte"), stepper::kInputBitNames, inputMeaning);
    m_mode = addValue(tr("Mode"), u"modeLabel"_s);
    m_timer = addValue(tr("Timer count"), u"timerLabel"_s);
    addAnalog(Common::tr("A/D (temperature)"));
    addEnd(*m_zero);
    m_context.whenSeen(this, [this] { refresh(); });
}

QString StepperDetailsBox::timer() const {
    const ModuleState& module = m_context.state();
    if (!module.latest || !module.latest->timerCount)
        return u"–"_s;
    const QString count = texts::grouped(*module.latest->timerCount);
    // At rest, the count is left from the last motion.
    if (!module.stepper.parameters || !module.moving())
        return count;
    const double rate =
        StepperSpeed(module.stepper.parameters->speedMode).ofCount(*module.latest->timerCount);
    return tr("%1 = %2").arg(count, texts::stepsPerSecond(rate, m_context.scale()));
}

void StepperDetailsBox::refresh() {
    showStatus(tr(", inputs %1"));
    const ModuleState& module = m_context.state();
    look::setText(m_mode, module.latest ? modeName(module.stepper.mode()) : u"–"_s);
    look::setText(m_timer, timer());
    m_zero->setPossible(m_context.reasonNow(IntentKind::ResetPosition),
                        texts::zeroMeaning(module, m_context.scale()));
}

}  // namespace nmc
