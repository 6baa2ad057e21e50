// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperdetailsbox.h"

#include <QLabel>

#include "model/module/stepperdefaults.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"
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
    : StatusTable(parent),
      m_context(context),
      m_zero(new Command({.name = u"stepperZeroHereButton"_s,
                          .icon = u"eraser"_s,
                          .text = tr("&Zero here"),
                          .accessible = Common::tr("Zero here: set the present position to 0")},
                         this, [this] { m_context.ask(intent::ResetPosition{}); })),
      m_saveHome(new Command({.name = u"stepperSaveHomeButton"_s,
                              .icon = u"home"_s,
                              .text = Common::tr("Save as home"),
                              .accessible = Common::tr("Save as home: the present position")},
                             this, [this] { m_context.ask(intent::SaveAsHome{}); })) {
    look::name(this, u"stepperDetailsBox"_s, Common::tr("Details"));
    addBits(Byte::First, Common::tr("Status byte"), stepper::kStatusBitNames, stepperStatusMeaning,
            u"stepperBit_"_s);
    addBits(Byte::Second, tr("Inputs byte"), stepper::kInputBitNames, inputMeaning, u"stepperBit_"_s);
    m_mode = addValue(tr("Mode"), u"stepperModeLabel"_s);
    m_timer = addValue(tr("Timer count"), u"stepperTimerLabel"_s);
    m_analog = addValue(Common::tr("A/D (temperature)"), u"stepperAnalogLabel"_s);
    m_home = addValue(Common::tr("Home register"), u"stepperHomeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(Common::tr("Raw"), u"stepperRawLabel"_s);
    addButtons({m_zero->button(), m_saveHome->button()});
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
    const QString dash = u"–"_s;
    const ModuleState& module = m_context.state();
    const StatusReport report = module.latest.value_or(StatusReport{});
    showBits(Byte::First, module.latest ? std::optional(report.status) : std::nullopt);
    showBits(Byte::Second, report.aux);
    look::setText(m_mode, module.latest ? modeName(module.stepper.mode()) : dash);
    look::setText(m_timer, timer());
    look::setText(m_analog,
                  report.analog ? texts::analogReading(m_context.settings().analog, *report.analog) : dash);
    look::setText(m_home, report.home ? texts::position(m_context.scale(), *report.home) : dash);
    QString raw = dash;
    if (module.latest) {
        raw = Common::tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", inputs %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
    m_zero->setPossible(m_context.reasonNow(IntentKind::ResetPosition),
                        texts::zeroMeaning(module, m_context.scale()));
    m_saveHome->setPossible(m_context.reasonNow(IntentKind::SaveAsHome),
                            Common::tr("Saves the present position as home. The motor does not move."));
}

}  // namespace nmc
