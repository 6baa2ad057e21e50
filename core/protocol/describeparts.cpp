// SPDX-License-Identifier: MIT
#include "protocol/describeparts.h"

#include <array>
#include <charconv>

#include "protocol/payloadcheck.h"

namespace nmc::describe {

namespace {

/// A 16.16 fixed-point number with six significant digits.
std::string fixedPoint(std::uint32_t value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(),
                                   static_cast<double>(value) / 65'536.0, std::chars_format::general, 6);
    return {text.data(), end.ptr};
}

std::string number(std::string_view name, std::int64_t value) {
    return std::string(name) + ' ' + std::to_string(value);
}

std::string_view amplifier(bool enabled) {
    return enabled ? "amplifier on" : "amplifier off";
}

}  // namespace

Phrases& Phrases::add(std::string_view phrase) {
    if (!m_text.empty())
        m_text += m_separator;
    m_text += phrase;
    return *this;
}

std::string counted(std::size_t count, std::string_view thing) {
    return std::to_string(count) + ' ' + std::string(thing) + (count == 1 ? "" : "s");
}

std::string pinNames(std::uint16_t pins, std::string_view none) {
    Phrases phrases(" ");
    for (unsigned pin = 0; pin < io::kPins; ++pin)
        phrases.addIf((unsigned{pins} >> pin & 1U) != 0, "IO" + std::to_string(pin + 1));
    return phrases.empty() ? std::string(none) : phrases.text();
}

std::string ownWords(const servo::LoadTrajectory& load) {
    Phrases phrases;
    if (load.position)
        phrases.add(number("position", load.position->value()));
    if (load.velocity)
        phrases.add("velocity " + fixedPoint(load.velocity->value()));
    if (load.acceleration)
        phrases.add("acceleration " + fixedPoint(load.acceleration->value()));
    if (load.pwm)
        phrases.add(number("PWM", *load.pwm));
    const bool trapezoidal = load.profile == servo::ProfileMode::Trapezoidal;
    phrases.add(!load.servo ? "PWM mode" : trapezoidal ? "trapezoidal" : "velocity mode");
    phrases.addIf(load.relative, "relative");
    return phrases.addIf(load.reverse, "reverse").addIf(load.startNow, "start now").text();
}

std::string ownWords(const servo::SetGain& gains) {
    Phrases phrases;
    phrases.add(number("Kp", gains.kp)).add(number("Kd", gains.kd)).add(number("Ki", gains.ki));
    phrases.add(number("IL", gains.il)).add(number("OL", gains.ol)).add(number("CL", gains.cl));
    phrases.add(number("EL", gains.el)).add(number("SR", gains.sr));
    if (gains.db)
        phrases.add(number("DB", *gains.db));
    if (gains.sm)
        phrases.add(number("SM", *gains.sm));
    return phrases.text();
}

std::string ownWords(const servo::StopMotor& stop) {
    Phrases phrases;
    switch (stop.manner) {
        case servo::StopManner::AmplifierOnly:
            break;
        case servo::StopManner::MotorOff:
            phrases.add("motor off");
            break;
        case servo::StopManner::Abruptly:
            phrases.add("stop abruptly");
            break;
        case servo::StopManner::Smoothly:
            phrases.add("stop smoothly");
            break;
        case servo::StopManner::Here:
            phrases.add(number("stop here, position", stop.here.value()));
            break;
    }
    return phrases.add(amplifier(stop.amplifierEnable))
        .addIf(stop.advancedFeatures, "advanced features")
        .text();
}

std::string ownWords(const servo::IoControl& io) {
    const auto pin = [](bool input, bool output) {
        return input ? "input" : output ? "output 1" : "output 0";
    };
    return Phrases()
        .add(std::string("limit1 ") + pin(io.limit1IsInput, io.limit1Output))
        .add(std::string("limit2 ") + pin(io.limit2IsInput, io.limit2Output))
        .addIf(io.fastPath, "fast path")
        .text();
}

std::string ownWords(const servo::SetHoming& homing) {
    Phrases phrases;
    phrases.addIf(homing.onLimit1Change, "change of limit1").addIf(homing.onLimit2Change, "change of limit2");
    phrases.addIf(homing.onIndexChange, "change of index").addIf(homing.onPositionError, "position error");
    phrases.addIf(homing.onCurrentLimit, "current limiting").addIf(homing.motorOff, "motor off");
    phrases.addIf(homing.stopAbruptly, "stop abruptly").addIf(homing.stopSmoothly, "stop smoothly");
    return phrases.empty() ? "cancel" : phrases.text();
}

std::string ownWords(const servo::ResetRelativeToHome&) {
    return "relative to home";
}

std::string ownWords(const servo::SetPosition& set) {
    return number("to position", set.position.value());
}

std::string ownWords(const servo::ScIoControl& io) {
    Phrases phrases;
    phrases.addIf(io.limitStop == servo::LimitStop::MotorOff, "motor off on limit");
    phrases.addIf(io.limitStop == servo::LimitStop::Abruptly, "stop abruptly on limit");
    phrases.addIf(io.threePhase, "3-phase").addIf(io.antiphase, "antiphase");
    phrases.addIf(io.fastPath, "fast path").addIf(io.stepAndDirection, "step and direction");
    return phrases.empty() ? "all off" : phrases.text();
}

std::string ownWords(const servo::AddPathPoints& add) {
    if (add.startsPath())
        return "start the path";
    // How long each lasts hangs on the fast path bit, which is not at hand; the speeds do not.
    Phrases speeds;
    for (const std::uint16_t word : add.words()) {
        const bool reverse = detail::bitOf(static_cast<std::uint8_t>(word), 0);
        const bool longer = detail::bitOf(static_cast<std::uint8_t>(word), 1);
        speeds.add((reverse ? "-" : "") + fixedPoint((word & ~0x03U) << 8U) + (longer ? " long" : ""));
    }
    return counted(add.words().size(), "point") + " at " + speeds.text();
}

std::string ownWords(const servo::HardReset& reset) {
    Phrases phrases;
    phrases.add(reset.save ? "save configuration" : "erase configuration");
    phrases.addIf(reset.restoreAddresses, "restore addresses").addIf(reset.amplifierOn, "amplifier on");
    phrases.addIf(reset.servoOn, "servo on").addIf(reset.stepAndDirection, "step and direction");
    phrases.addIf(reset.limitProtection, "limit protection");
    return phrases.addIf(reset.threePhase, "3-phase").addIf(reset.antiphase, "antiphase").text();
}

std::string ownWords(const stepper::LoadTrajectory& load) {
    Phrases phrases;
    if (load.position)
        phrases.add(number("position", load.position->value()));
    if (load.speed)
        phrases.add(number("speed", *load.speed));
    if (load.accelerationTime)
        phrases.add(number("acceleration time", *load.accelerationTime));
    if (load.timer) {
        phrases.add(number("timer count", load.timer->count));
        phrases.add(number("nearest speed", load.timer->nearestSpeed));
    }
    phrases.addIf(load.reverse, "reverse").addIf(load.startNow, "start now");
    return phrases.empty() ? "nothing loaded" : phrases.text();
}

std::string ownWords(const stepper::SetParameters& parameters) {
    Phrases phrases;
    switch (parameters.speedMode) {
        case stepper::SpeedMode::X8:
            phrases.add("8x");
            break;
        case stepper::SpeedMode::X4:
            phrases.add("4x");
            break;
        case stepper::SpeedMode::X2:
            phrases.add("2x");
            break;
        case stepper::SpeedMode::X1:
            phrases.add("1x");
            break;
    }
    phrases.addIf(parameters.ignoreLimits, "ignore limits").addIf(parameters.ignoreEstop, "ignore E-stop");
    phrases.addIf(parameters.motorOffOnLimitOrEstop, "motor off on limit or E-stop");
    phrases.add(number("minimum profile speed", parameters.minimumProfileSpeed));
    phrases.add(number("run current", parameters.runCurrent))
        .add(number("hold current", parameters.holdCurrent));
    return phrases.add(number("thermal limit", parameters.thermalLimit)).text();
}

std::string ownWords(const stepper::StopMotor& stop) {
    Phrases phrases;
    switch (stop.manner) {
        case stepper::StopManner::AmplifierOnly:
            break;
        case stepper::StopManner::Abruptly:
            phrases.add("stop abruptly");
            break;
        case stepper::StopManner::Smoothly:
            phrases.add("stop smoothly");
            break;
    }
    return phrases.add(amplifier(stop.amplifierEnable)).text();
}

std::string ownWords(const stepper::SetOutputs& outputs) {
    static constexpr std::array<std::string_view, 5> kNames{"OUT1", "OUT2", "OUT3", "OUT4", "OUT5"};
    Phrases phrases;
    for (unsigned i = 0; i < kNames.size(); ++i)
        phrases.addIf((outputs.outputs & (1U << i)) != 0, kNames[i]);
    return phrases.empty() ? "all low" : phrases.text() + " high";
}

std::string ownWords(const stepper::SetHoming& homing) {
    Phrases phrases;
    phrases.addIf(homing.onLimit1Change, "change of limit1").addIf(homing.onLimit2Change, "change of limit2");
    phrases.addIf(homing.onHomeSwitchChange, "change of home switch").addIf(homing.motorOff, "motor off");
    phrases.addIf(homing.stopAbruptly, "stop abruptly").addIf(homing.stopSmoothly, "stop smoothly");
    return phrases.empty() ? "cancel" : phrases.text();
}

std::string ownWords(const io::SetDirection& set) {
    return "inputs " + pinNames(set.inputs, "none");
}

std::string ownWords(const io::SetPwm& set) {
    return Phrases().add(number("PWM1", set.pwm1)).add(number("PWM2", set.pwm2)).text();
}

std::string ownWords(const io::SetOutput& set) {
    return "high " + pinNames(set.outputs, "none");
}

std::string ownWords(const io::SetSynchOutput& set) {
    return Phrases()
        .add("high " + pinNames(set.outputs, "none"))
        .add(number("PWM1", set.pwm1))
        .add(number("PWM2", set.pwm2))
        .text();
}

std::string ownWords(const io::SetTimerMode& set) {
    if (!set.enable)
        return "off";
    return Phrases()
        .add(set.counter ? "counter" : "timer")
        .add(number("prescaler", io::divisor(set.prescaler)))
        .text();
}

}  // namespace nmc::describe
