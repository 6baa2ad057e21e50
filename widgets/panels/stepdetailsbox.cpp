// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepdetailsbox.h"

#include <QLabel>
#include <QPushButton>

#include "widgets/common/homewords.h"
#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/panels/stepdefaults.h"
#include "widgets/panels/stepwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

QString statusMeaning(std::size_t bit) {
    const std::array<QString, 8> meanings{
        StepDetailsBox::tr("Step pulses are coming."),
        StepDetailsBox::tr("The module could not read the last command; it was not carried out."),
        StepDetailsBox::tr("The driver is enabled (AMP_EN is high)."),
        StepDetailsBox::tr("Motor power is present (PWR_SENSE is high)."),
        StepDetailsBox::tr("The motor has the speed that was asked for."),
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
            return StepDetailsBox::tr("moving as another program told it to");
    }
    return {};
}

}  // namespace

StepDetailsBox::StepDetailsBox(QWidget* parent)
    : StatusTable(parent),
      m_zero(new QPushButton(icons::tinted(u"eraser"_s), tr("&Zero here"), this)),
      m_saveHome(new QPushButton(icons::tinted(u"home"_s), tr("Save as home"), this)) {
    look::name(this, u"stepDetailsBox"_s, tr("Details"));
    look::name(m_zero, u"stepZeroHereButton"_s, tr("Make the present position zero"));
    look::name(m_saveHome, u"stepSaveHomeButton"_s, tr("Save the present position as home"));
    addBits(Byte::First, tr("Status byte"), step::kStatusBitNames, statusMeaning, u"stepBit_"_s);
    addBits(Byte::Second, tr("Inputs byte"), step::kInputBitNames, inputMeaning, u"stepBit_"_s);
    m_mode = addValue(tr("Mode"), u"stepModeLabel"_s);
    m_timer = addValue(tr("Timer count"), u"stepTimerLabel"_s);
    m_analog = addValue(tr("A/D (temperature)"), u"stepAnalogLabel"_s);
    m_home = addValue(tr("Home register"), u"stepHomeLabel"_s);
    m_home->setToolTip(texts::homeRegisterMeaning());
    m_raw = addValue(tr("Raw"), u"stepRawLabel"_s);
    addButtons({m_zero, m_saveHome});
    connect(m_zero, &QPushButton::clicked, this, [this] { emit intentRequested(intent::ResetPosition{}); });
    connect(m_saveHome, &QPushButton::clicked, this, [this] { emit intentRequested(intent::SaveAsHome{}); });
    refresh();
}

void StepDetailsBox::showModule(const PanelView& view) {
    const std::optional<StatusReport>& report = view.module.latest;
    showBits(Byte::First, report ? std::optional(report->status) : std::nullopt);
    showBits(Byte::Second, report ? report->aux : std::nullopt);
    showValues(view);
    m_whyNotZero = view.whyNot(Request::ResetPosition);
    m_zeroMeaning = texts::zeroMeaning(view.module, view.scale());
    m_whyNotHome = view.whyNot(Request::SaveAsHome);
    refresh();
}

void StepDetailsBox::showValues(const PanelView& view) {
    const QString dash = u"–"_s;
    const StatusReport report = view.module.latest.value_or(StatusReport{});
    look::setText(m_mode, view.module.latest ? modeName(view.module.stepper.mode()) : dash);
    QString timer = dash;
    if (report.timerCount) {
        timer = texts::grouped(*report.timerCount);
        if (view.module.stepper.parameters()) {
            const double rate =
                StepSpeed(view.module.stepper.parameters()->speedMode).ofCount(*report.timerCount);
            timer = tr("%1, stands for %2").arg(timer, texts::stepsPerSecond(rate, view.scale()));
        }
    }
    look::setText(m_timer, timer);
    look::setText(m_analog,
                  report.analog ? texts::analogReading(view.settings.analog, *report.analog) : dash);
    look::setText(m_home, report.home ? texts::position(view.scale(), *report.home) : dash);
    QString raw = dash;
    if (view.module.latest) {
        raw = tr("status %1").arg(report.status, 2, 16, QChar(u'0'));
        if (report.aux)
            raw += tr(", inputs %1").arg(*report.aux, 2, 16, QChar(u'0'));
    }
    look::setText(m_raw, raw);
}

void StepDetailsBox::setBusy(bool busy) {
    if (m_busy == busy)
        return;
    m_busy = busy;
    refresh();
}

void StepDetailsBox::refresh() {
    const auto reason = [this](const std::optional<Refusal>& refusal) {
        return refusal  ? texts::refusal(*refusal)
               : m_busy ? tr("Waiting for the module's answer.")
                        : QString();
    };
    look::setPossible(m_zero, reason(m_whyNotZero), m_zeroMeaning);
    look::setPossible(m_saveHome, reason(m_whyNotHome),
                      tr("Keeps the present position as home. The motor does not move."));
}

}  // namespace nmc
