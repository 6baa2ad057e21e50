// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepmeaning.h"

#include <QCoreApplication>

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
class StepMeaning {
    Q_DECLARE_TR_FUNCTIONS(StepMeaning)
};
}  // namespace

int stepParameter(const step::SetParameters& parameters, StepParameter parameter) {
    switch (parameter) {
        case StepParameter::SpeedMode:
            return static_cast<int>(parameters.speedMode);
        case StepParameter::MinimumSpeed:
            return parameters.minimumProfileSpeed;
        case StepParameter::RunCurrent:
            return parameters.runCurrent;
        case StepParameter::HoldCurrent:
            return parameters.holdCurrent;
        case StepParameter::ThermalLimit:
            return parameters.thermalLimit;
        case StepParameter::IgnoreLimits:
            return parameters.ignoreLimits ? 1 : 0;
        case StepParameter::IgnoreEstop:
            return parameters.ignoreEstop ? 1 : 0;
        case StepParameter::MotorOff:
            return parameters.motorOffOnLimitOrEstop ? 1 : 0;
    }
    return 0;
}

void setStepParameter(step::SetParameters& parameters, StepParameter parameter, int value) {
    const auto byte = static_cast<std::uint8_t>(value);
    switch (parameter) {
        case StepParameter::SpeedMode:
            parameters.speedMode = static_cast<step::SpeedMode>(byte);
            break;
        case StepParameter::MinimumSpeed:
            parameters.minimumProfileSpeed = byte;
            break;
        case StepParameter::RunCurrent:
            parameters.runCurrent = byte;
            break;
        case StepParameter::HoldCurrent:
            parameters.holdCurrent = byte;
            break;
        case StepParameter::ThermalLimit:
            parameters.thermalLimit = byte;
            break;
        case StepParameter::IgnoreLimits:
            parameters.ignoreLimits = value != 0;
            break;
        case StepParameter::IgnoreEstop:
            parameters.ignoreEstop = value != 0;
            break;
        case StepParameter::MotorOff:
            parameters.motorOffOnLimitOrEstop = value != 0;
            break;
    }
}

QString stepParameterName(StepParameter parameter) {
    switch (parameter) {
        case StepParameter::SpeedMode:
            return StepMeaning::tr("Speed mode");
        case StepParameter::MinimumSpeed:
            return StepMeaning::tr("Minimum profile speed");
        case StepParameter::RunCurrent:
            return StepMeaning::tr("Run current");
        case StepParameter::HoldCurrent:
            return StepMeaning::tr("Hold current");
        case StepParameter::ThermalLimit:
            return StepMeaning::tr("Thermal limit");
        case StepParameter::IgnoreLimits:
            return StepMeaning::tr("Limit switches");
        case StepParameter::IgnoreEstop:
            return StepMeaning::tr("E-stop input");
        case StepParameter::MotorOff:
            return StepMeaning::tr("On limit or E-stop");
    }
    return {};
}

QString stepParameterMeaning(StepParameter parameter) {
    switch (parameter) {
        case StepParameter::SpeedMode:
            return StepMeaning::tr(
                "The clock of the step timer. A faster clock reaches higher speeds in coarser steps: use the slowest one that is fast enough. Changing it changes the meaning of every speed and ramp.");
        case StepParameter::MinimumSpeed:
            return StepMeaning::tr(
                "The speed at which ramps start and end. The motor must be able to start and stop at this speed without losing steps. Runs and moves with a ramp are never slower.");
        case StepParameter::RunCurrent:
            return StepMeaning::tr(
                "Motor current while moving; 255 is the driver's full current. 0: no current, and the motor does not follow. Do not exceed the ratings of motor and driver.");
        case StepParameter::HoldCurrent:
            return StepMeaning::tr(
                "Motor current at rest, from about 0.25 s after a motion. Usually lower than the run current, to keep the motor cool. 0: no current, and the motor holds nothing.");
        case StepParameter::ThermalLimit:
            return StepMeaning::tr(
                "The module switches the motor off when the A/D value falls below this limit: the voltage of a thermistor bridge falls as the motor warms up. 0: off. To find the right limit, watch the A/D value of a warm motor.");
        case StepParameter::IgnoreLimits:
            return StepMeaning::tr(
                "Normally the chip stops at limit switch 1 going forward and at limit switch 2 in reverse. When ignored, the switches stop nothing, and the motor can run into the end of its travel.");
        case StepParameter::IgnoreEstop:
            return StepMeaning::tr(
                "Normally the chip stops the motor when its E-stop input goes high. When ignored, the input stops nothing.");
        case StepParameter::MotorOff:
            return StepMeaning::tr(
                "A limit switch or the E-stop input also switches the motor off: it is free to turn, and a load may fall.");
    }
    return {};
}

QString stepParameterRemark(StepParameter parameter, std::optional<int> value,
                            std::optional<std::uint8_t> analog) {
    const QString now = analog ? StepMeaning::tr("A/D now %1").arg(*analog) : QString();
    if (parameter == StepParameter::ThermalLimit && value == 0)
        return now.isEmpty() ? StepMeaning::tr("off") : StepMeaning::tr("off; %1").arg(now);
    if (parameter == StepParameter::ThermalLimit)
        return now;
    if (!value)
        return {};
    if (parameter == StepParameter::MinimumSpeed)
        return StepMeaning::tr("speed %1").arg(*value);
    if (parameter == StepParameter::RunCurrent || parameter == StepParameter::HoldCurrent)
        return *value == 0 ? StepMeaning::tr("no current")
                           : StepMeaning::tr("%1 % of full").arg(qRound(*value * 100.0 / 255));
    return {};
}

QString stepParameterObject(StepParameter parameter) {
    switch (parameter) {
        case StepParameter::SpeedMode:
            return u"stepSpeedMode"_s;
        case StepParameter::MinimumSpeed:
            return u"stepMinimumSpeed"_s;
        case StepParameter::RunCurrent:
            return u"stepRunCurrent"_s;
        case StepParameter::HoldCurrent:
            return u"stepHoldCurrent"_s;
        case StepParameter::ThermalLimit:
            return u"stepThermalLimit"_s;
        case StepParameter::IgnoreLimits:
            return u"stepIgnoreLimits"_s;
        case StepParameter::IgnoreEstop:
            return u"stepIgnoreEstop"_s;
        case StepParameter::MotorOff:
            return u"stepMotorOffOnStop"_s;
    }
    return {};
}

step::SetParameters stepStartingValues() {
    step::SetParameters parameters;
    parameters.speedMode = step::SpeedMode::X1;
    parameters.minimumProfileSpeed = 4;
    parameters.runCurrent = 64;
    parameters.holdCurrent = 32;
    return parameters;
}

}  // namespace nmc
