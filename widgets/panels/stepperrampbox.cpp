// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperrampbox.h"

#include <QLabel>

#include "model/module/stepperdefaults.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/boxparts.h"
#include "widgets/panels/stagedform.h"
#include "widgets/panels/stepperwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperRampBox::StepperRampBox(ModuleContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_time(form::newNumber(
          {.name = u"stepperAccelerationTimeField"_s,
           .accessible = Common::tr("Acceleration time"),
           .words = tr("The acceleration time"),
           .min = static_cast<double>(stepper::kAccelerationTimeRange.min),
           .max = static_cast<double>(stepper::kAccelerationTimeRange.max),
           .digits = 8,
           .meaning = tr(
               "How long a ramp stays at each speed, in units of 0.25 ms; smaller is steeper. Sent with the next motion that has a ramp, and used by smooth stops after it.")},
          this)),
      m_acceleration(look::newMutedLabel({}, this, u"stepperAccelerationRemark"_s)),
      m_state(look::newMutedLabel({}, this, u"stepperAccelerationTimeState"_s)),
      m_cap(form::newQuantity(
          {.kind = QuantityField::Kind::Velocity,
           .name = u"stepperHoldCapField"_s,
           .accessible = Common::tr("Max jog speed"),
           .step = 100,
           .meaning = tr("Jog is never faster than this. Set a speed that you can react to.")},
          this)) {
    auto* grid = new FormGrid(this, 5, {.sides = 0, .ends = 0, .across = 1});
    grid->addWide(form::newHeading(tr("With every motion"), this));
    grid->addRow(Common::tr("Acceleration time"), m_time,
                 {new QLabel(tr("× 0.25 ms"), this), m_acceleration, m_state});
    grid->addRow(Common::tr("Max jog speed"), m_cap);
    grid->setColumnStretch(3, 0);
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
    showUnlessTyped(m_time, stepperdefaults::accelerationTime(settings));
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
    const auto loaded = stepper.accelerationTime;
    using Mark = StagedForm::Mark;
    StagedForm::showMark(m_state,
                         !loaded           ? Mark::Unknown
                         : *loaded == time ? Mark::Sent
                                           : Mark::Edited,
                         m_narrow);
}

}  // namespace nmc
