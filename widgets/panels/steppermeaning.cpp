// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/steppermeaning.h"

#include <QCoreApplication>

#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
class StepperMeaning {
    Q_DECLARE_TR_FUNCTIONS(StepperMeaning)
};
}  // namespace

int stepperParameter(const stepper::SetParameters& parameters, StepperParameter parameter) {
    switch (parameter) {
        case StepperParameter::SpeedMode:
            return static_cast<int>(parameters.speedMode);
        case StepperParameter::MinimumSpeed:
            return parameters.minimumProfileSpeed;
        case StepperParameter::RunCurrent:
            return parameters.runCurrent;
        case StepperParameter::HoldCurrent:
            return parameters.holdCurrent;
        case StepperParameter::ThermalLimit:
            return parameters.thermalLimit;
        case StepperParameter::IgnoreLimits:
            return parameters.ignoreLimits ? 1 : 0;
        case StepperParameter::IgnoreEstop:
            return parameters.ignoreEstop ? 1 : 0;
        case StepperParameter::MotorOff:
            return parameters.motorOffOnLimitOrEstop ? 1 : 0;
    }
    return 0;
}

void setStepParameter(stepper::SetParameters& parameters, StepperParameter parameter, int value) {
    const auto byte = static_cast<std::uint8_t>(value);
    switch (parameter) {
        case StepperParameter::SpeedMode:
            parameters.speedMode = static_cast<stepper::SpeedMode>(byte);
            break;
        case StepperParameter::MinimumSpeed:
            parameters.minimumProfileSpeed = byte;
            break;
        case StepperParameter::RunCurrent:
            parameters.runCurrent = byte;
            break;
        case StepperParameter::HoldCurrent:
            parameters.holdCurrent = byte;
            break;
        case StepperParameter::ThermalLimit:
            parameters.thermalLimit = byte;
            break;
        case StepperParameter::IgnoreLimits:
            parameters.ignoreLimits = value != 0;
            break;
        case StepperParameter::IgnoreEstop:
            parameters.ignoreEstop = value != 0;
            break;
        case StepperParameter::MotorOff:
            parameters.motorOffOnLimitOrEstop = value != 0;
            break;
    }
}

QString stepperParameterName(StepperParameter parameter) {
    switch (parameter) {
        case StepperParameter::SpeedMode:
            return StepperMeaning::tr("Speed mode");
        case StepperParameter::MinimumSpeed:
            return StepperMeaning::tr("Minimum profile speed");
        case StepperParameter::RunCurrent:
            return StepperMeaning::tr("Run current");
        case StepperParameter::HoldCurrent:
            return StepperMeaning::tr("Hold current");
        case StepperParameter::ThermalLimit:
            return StepperMeaning::tr("Thermal limit");
        case StepperParameter::IgnoreLimits:
            return StepperMeaning::tr("Limit switches");
        case StepperParameter::IgnoreEstop:
            return Common::tr("E-stop input");
        case StepperParameter::MotorOff:
            return StepperMeaning::tr("On limit or E-stop");
    }
    return {};
}

QString stepperParameterMeaning(StepperParameter parameter) {
    switch (parameter) {
        case StepperParameter::SpeedMode:
            return StepperMeaning::tr(
                "The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.");
        case StepperParameter::MinimumSpeed:
            return StepperMeaning::tr(
                "The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.");
        case StepperParameter::RunCurrent:
            return StepperMeaning::tr(
                "Motor current while moving; 255 is the driver's full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.");
        case StepperParameter::HoldCurrent:
            return StepperMeaning::tr(
                "Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and no holding torque.");
        case StepperParameter::ThermalLimit:
            return StepperMeaning::tr(
                "The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.");
        case StepperParameter::IgnoreLimits:
            return StepperMeaning::tr(
                "Normally the chip stops the motor at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches do not stop the motor, and it can run into the end of its travel.");
        case StepperParameter::IgnoreEstop:
            return StepperMeaning::tr(
                "Normally the chip stops the motor when its E-stop input goes high. When ignored, the input does not stop the motor.");
        case StepperParameter::MotorOff:
            return StepperMeaning::tr(
                "A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.");
    }
    return {};
}

QString stepperParameterRemark(StepperParameter parameter, std::optional<int> value,
                               std::optional<std::uint8_t> analog) {
    const QString now = analog ? StepperMeaning::tr("A/D now %1").arg(*analog) : QString();
    if (parameter == StepperParameter::ThermalLimit && value == 0)
        return now.isEmpty() ? Common::tr("off") : StepperMeaning::tr("off; %1").arg(now);
    if (parameter == StepperParameter::ThermalLimit)
        return now;
    if (!value)
        return {};
    if (parameter == StepperParameter::MinimumSpeed)
        return StepperMeaning::tr("speed %1").arg(*value);
    if (parameter == StepperParameter::RunCurrent || parameter == StepperParameter::HoldCurrent)
        return *value == 0 ? StepperMeaning::tr("no current")
                           : StepperMeaning::tr("%1 % of full").arg(qRound(*value * 100.0 / 255));
    return {};
}

QString stepperParameterObject(StepperParameter parameter) {
    switch (parameter) {
        case StepperParameter::SpeedMode:
            return u"stepperSpeedMode"_s;
        case StepperParameter::MinimumSpeed:
            return u"stepperMinimumSpeed"_s;
        case StepperParameter::RunCurrent:
            return u"stepperRunCurrent"_s;
        case StepperParameter::HoldCurrent:
            return u"stepperHoldCurrent"_s;
        case StepperParameter::ThermalLimit:
            return u"stepperThermalLimit"_s;
        case StepperParameter::IgnoreLimits:
            return u"stepperIgnoreLimits"_s;
        case StepperParameter::IgnoreEstop:
            return u"stepperIgnoreEstop"_s;
        case StepperParameter::MotorOff:
            return u"stepperMotorOffOnStop"_s;
    }
    return {};
}

stepper::SetParameters stepperStartingValues() {
    stepper::SetParameters parameters;
    parameters.speedMode = stepper::SpeedMode::X1;
    parameters.minimumProfileSpeed = 4;
    parameters.runCurrent = 64;
    parameters.holdCurrent = 32;
    return parameters;
}

}  // namespace nmc
