// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperrampbox.h"

#include <QGridLayout>
#include <QLabel>

#include "model/module/stepperdefaults.h"
#include "widgets/common/foldinggrid.h"
#include "widgets/common/look.h"
#include "widgets/common/quantityfield.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperRampBox::StepperRampBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_time(new NumberField(0, this)),
      m_acceleration(look::newMutedLabel({}, this)),
      m_state(look::newMutedLabel({}, this)),
      m_cap(new QuantityField(QuantityField::Kind::Velocity, this)) {
    look::name(m_time, u"stepperAccelerationTimeField"_s, tr("Acceleration time"));
    m_time->setRange(static_cast<double>(stepper::kAccelerationTimeRange.min),
                     static_cast<double>(stepper::kAccelerationTimeRange.max));
    m_time->setWords(tr("The acceleration time"), {});
    m_time->setDigits(8);
    m_time->setMeaning(tr(
        "How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it."));
    m_acceleration->setObjectName(u"stepperAccelerationRemark"_s);
    m_state->setObjectName(u"stepperAccelerationTimeState"_s);
    m_cap->setName(u"stepperHoldCapField"_s, tr("Max jog speed"));
    m_cap->setQuantity(tr("Max jog speed"));
    m_cap->setNativeStep(100);
    m_cap->setMeaning(tr("Jog is never faster than this. Set a speed that you can react to."));
    auto* heading = new QLabel(tr("With every motion"), this);
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    auto* timeLabel = new QLabel(tr("Acceleration time"), this);
    timeLabel->setBuddy(m_time);
    auto* capLabel = new QLabel(tr("Max jog speed"), this);
    capLabel->setBuddy(m_cap);
    const int unit = look::gridUnit(this);
    auto* grid = new FoldingGrid(this);
    grid->setContentsMargins(0, unit / 2, 0, 0);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit / 3);
    grid->addWidget(heading, 0, 0, 1, 5);
    grid->addWidget(timeLabel, 1, 0);
    grid->addWidget(m_time, 1, 1);
    grid->addWidget(new QLabel(tr("× 0.25 ms"), this), 1, 2);
    grid->addWidget(m_acceleration, 1, 3);
    grid->addWidget(m_state, 1, 4);
    grid->addWidget(capLabel, 2, 0);
    grid->addWidget(m_cap, 2, 1);
    grid->addWidget(m_cap->unitLabel(), 2, 2);
    grid->addWidget(m_cap->otherView(), 2, 3);
    grid->setColumnStretch(4, 1);

    connect(m_time, &NumberField::edited, this, [this] {
        if (const auto time = m_time->value())
            m_context.edit([time](AxisSettings& axis) { axis.accelerationTime = *time; });
        refresh();
    });
    connect(m_cap, &QuantityField::nativeEdited, this, [this] {
        if (const auto cap = m_cap->native())
            m_context.edit([cap](AxisSettings& axis) { axis.motion.holdCap = *cap; });
    });
    m_context.whenSeen(this, [this] { showModule(); });
}

void StepperRampBox::showModule() {
    const StepperState& stepper = m_context.state().stepper;
    const AxisSettings& settings = m_context.settings();
    m_cap->setScale(m_context.scale());
    m_cap->setNativeRange(stepperdefaults::slowestProfile(stepper, settings),
                          stepperdefaults::speedMode(stepper, settings).fastest());
    // A field that has the focus is not changed, because the user may be typing there.
    const double time = stepperdefaults::accelerationTime(settings);
    if (!m_time->hasFocus() && m_time->value() != time)
        m_time->showValue(time);
    const double cap = stepperdefaults::holdCap(stepper, settings);
    if (!m_cap->hasFocus() && m_cap->native() != cap)
        m_cap->showNative(cap);
    refresh();
}

void StepperRampBox::setNarrow(bool narrow) {
    m_narrow = narrow;
    refresh();
}

void StepperRampBox::refresh() {
    const StepperState& stepper = m_context.state().stepper;
    const StepperSpeed speeds = stepperdefaults::speedMode(stepper, m_context.settings());
    const auto time = m_time->value();
    look::setText(m_acceleration, time ? texts::acceleration(speeds, static_cast<int>(*time), m_cap->scale())
                                       : m_time->problemText());
    const auto loaded = stepper.accelerationTime();
    const QString state = !loaded ? tr("? unknown") : *loaded == time ? tr("✓ sent") : tr("● not sent");
    look::setText(m_state, m_narrow ? state.section(u' ', 0, 0) : state);
}

}  // namespace nmc
