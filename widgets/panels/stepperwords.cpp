// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperwords.h"

#include <QCoreApplication>

#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {
class StepperWords {
    Q_DECLARE_TR_FUNCTIONS(StepperWords)
};
}  // namespace

QString stepsPerSecond(double speed, const AxisScale& scale) {
    const QString native = StepperWords::tr("%1 steps/s").arg(readout(speed, 6));
    if (scale.native())
        return native;
    return u"%1 (%2)"_s.arg(native, velocity(scale, speed));
}

QString speedMode(stepper::SpeedMode mode) {
    const StepperSpeed speeds(mode);
    return StepperWords::tr("%1x: %2 to %3 steps/s")
        .arg(QString::number(speeds.multiplier()), readout(speeds.slowest()),
             grouped(qRound64(speeds.fastest())));
}

QString profiledSpeed(const StepperSpeed& mode, int speed, int minimum, const AxisScale& scale) {
    if (speed < minimum)
        return StepperWords::tr("Runs at %1: speed %2, the minimum profile speed.")
            .arg(stepsPerSecond(mode.ofSpeed(minimum), scale), QString::number(minimum));
    return StepperWords::tr("Runs at %1: speed %2 of 250.")
        .arg(stepsPerSecond(mode.ofSpeed(speed), scale), QString::number(speed));
}

QString timedSpeed(const StepperSpeed& mode, stepper::TimerCount timer, const AxisScale& scale) {
    return StepperWords::tr("Runs at %1: timer count %2.")
        .arg(stepsPerSecond(mode.ofCount(timer.count), scale), grouped(timer.count));
}

QString acceleration(const StepperSpeed& mode, int accelerationTime, const AxisScale& scale) {
    const double acceleration = mode.acceleration(accelerationTime);
    const QString native = StepperWords::tr("%1 steps/s²").arg(readout(acceleration));
    if (scale.native())
        return native;
    return u"%1 (%2)"_s.arg(native, texts::acceleration(scale, acceleration));
}

QString ramp(const StepperSpeed& mode, int accelerationTime, const AxisScale& scale) {
    return StepperWords::tr("Ramp of %1.").arg(acceleration(mode, accelerationTime, scale));
}

QString forecast(const StepperForecast& forecast, const AxisScale& scale) {
    if (forecast.peak == 0.0)
        return StepperWords::tr("The motor is already there.");
    const QString seconds = readout(forecast.seconds, 3);
    const QString peak = stepsPerSecond(forecast.peak, scale);
    return forecast.triangular
               ? StepperWords::tr("Takes %1 s. Too short for that speed: peaks at %2.").arg(seconds, peak)
               : StepperWords::tr("Takes %1 s, peak speed %2.").arg(seconds, peak);
}

}  // namespace nmc::texts
