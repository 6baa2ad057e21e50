// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepdetailsbox.h"

#include <QLabel>

#include "model/module/stepdefaults.h"
#include "widgets/common/homewords.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/command.h"
#include "widgets/panels/stepwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString statusMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        StepDetailsBox::tr("Step pulses are coming."),
        StepDetailsBox::tr("The module received a garbled command and did not carry it out."),
        StepDetailsBox::tr("The driver is enabled (AMP_EN is high)."),
        StepDetailsBox::tr("Motor power is present (PWR_SENSE is high)."),
        StepDetailsBox::tr("The motor has reached its commanded speed."),
        StepDetailsBox::tr("Runs with a ramp: velocity profile mode."),
        StepDetailsBox::tr("Moves to a position with a ramp: trapezoidal profile mode."),
        StepDetailsBox::tr("Waiting for the home position.")};
    return meanings[bit];
}

QString inputMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{StepDetailsBox::tr("High stops the motor, unless it is ignored."),
                                          StepDetailsBox::tr("General purpose input."),
                                          StepDetailsBox::tr("General purpose input."),
                                          StepDetailsBox::tr("High blocks forward, unless it is ignored."),
                                          StepDetailsBox::tr("High blocks reverse, unless it is ignored."),
                                          StepDetailsBox::tr("For homing."),
                                          QString(),
                                          QString()};
    return meanings[bit];
}

QString modeName(bus::StepMode mode) {
    switch (mode) {
        case bus::StepMode::Stopped:
            return StepDetailsBox::tr("stopped");
        case bus::StepMode::Trapezoidal:
            return StepDetailsBox::tr("trapezoidal profile");
        case bus::StepMode::VelocityProfile:
            return StepDetailsBox::tr("velocity profile");
        case bus::StepMode::UnprofiledWithStop:
            return StepDetailsBox::tr("unprofiled, with stop");
        case bus::StepMode::Unprofiled:
            return StepDetailsBox::tr("unprofiled, without stop");
        case bus::StepMode::Unknown:
            return StepDetailsBox::tr("moving, commanded by another program");
    }
    return {};
}

}  // namespace

StepDetailsBox::StepDetailsBox(ModuleContext& context, QWidget* parent)
    : StatusTable(parent),
      m_context(context),
      m_zero(new Command({.name = u"stepZeroHereButton"_s,
                          .icon = u"eraser"_s,
                          .text = tr("&Zero here"),
                          .accessible = tr("Zero here: set the present position to 0")},
                         this, [this] { m_context.ask(intent::ResetPosition{}); })),
      m_saveHome(new Command({.name = u"stepSaveHomeButton"_s,
                              .icon = u"home"_s,
                              .text = tr("Save as home"),
                              .accessible = tr("Save as home: the present position")},
                             this, [this] { m_context.ask(intent::SaveAsHome{}); })) {
    look::name(this, u"stepDetailsBox"_s, tr("Details"));
    addBits(Byte::First, tr("Status byte"), step::kStatusBitNames, statusMeaning, u"stepBit_"_s);
    addBits(Byte::Second, tr("Inputs byte"), step::kInputBitNames, inputMeaning, u"stepBit_"_s);
    m_mode = addValue(tr("Mode"), u"stepModeLabel"_s);
    m_timer = addValue(tr("Timer count"), u"stepTimerLabel"_s);
    m_analog = addValue(tr("A/D (temperature)"), u"stepAnalogLabel"_s);
    m_home = addValue(tr("Home register"), u"stepHomeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(tr("Raw"), u"stepRawLabel"_s);
    addButtons({m_zero->button(), m_saveHome->button()});
    m_context.whenSeen(this, [this] { refresh(); });
}

QString StepDetailsBox::timer() const {
    const ModuleState& module = m_context.state();
    if (!module.latest || !module.latest->timerCount)
        return u"–"_s;
    const QString count = texts::grouped(*module.latest->timerCount);
    // At rest the count is what the last motion left there.
    if (!module.stepper.parameters() || !module.moving())
        return count;
    const double rate = StepSpeed(module.stepper.parameters()->speedMode).ofCount(*module.latest->timerCount);
    return tr("%1 = %2").arg(count, texts::stepsPerSecond(rate, m_context.scale()));
}

void StepDetailsBox::refresh() {
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
        raw = tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", inputs %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
    m_zero->setPossible(m_context.reasonNow(Request::ResetPosition),
                        texts::zeroMeaning(module, m_context.scale()));
    m_saveHome->setPossible(m_context.reasonNow(Request::SaveAsHome),
                            tr("Saves the present position as home. The motor does not move."));
}

}  // namespace nmc
