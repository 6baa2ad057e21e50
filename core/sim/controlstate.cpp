// SPDX-License-Identifier: MIT
#include "sim/controlstate.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "base/enumname.h"
#include "base/text.h"

namespace nmc::sim {

namespace {

using Json = nlohmann::ordered_json;

// The words for the modes, by enum value.
constexpr std::array kServoModes{"pwm", "velocity", "trapezoidal", "stop-here"};
constexpr std::array kStepperModes{"stopped", "trapezoidal", "velocity", "unprofiled", "unprofiled"};
static_assert(kServoModes.size() == static_cast<std::size_t>(ServoMode::StopHere) + 1 &&
              kStepperModes.size() == static_cast<std::size_t>(StepperMode::Unprofiled) + 1);

Json gainsJson(const Gains& g) {
    return {{"kp", g.kp}, {"kd", g.kd}, {"ki", g.ki}, {"il", g.il}, {"ol", g.ol},
            {"cl", g.cl}, {"el", g.el}, {"sr", g.sr}, {"db", g.db}};
}

/// The value, or null when there is none.
template <typename T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// A hard stop, or null when there is none.
Json stopJson(double counts) {
    return std::isfinite(counts) ? Json(counts) : Json(nullptr);
}

/// The bits that Clear Sticky Bits clears, as the next status will show them (DS-V 5.3).
Json stickyJson(const ModuleSnapshot& s) {
    return {{"overcurrent", (s.status & 0x04U) != 0},
            {"pos_error", (s.status & 0x10U) != 0},
            {"pos_wrap", (s.pins & 0x02U) != 0},
            {"servo_overrun", (s.pins & 0x20U) != 0}};
}

/// The conditions that the current home search still waits for; empty when there is no search.
Json homingConditions(const ModuleSnapshot& s) {
    struct Condition {
        std::uint8_t bit;
        const char* name;
    };
    const std::array conditions{Condition{Homing::kLimit1, "limit1"}, Condition{Homing::kLimit2, "limit2"},
                                Condition{Homing::kIndex, s.stepper ? "home_switch" : "index"},
                                Condition{Homing::kPositionError, "position_error"},
                                Condition{Homing::kCurrentLimit, "current_limit"}};
    Json names = Json::array();
    for (const Condition& condition : conditions)
        if (s.homing.waitsFor(condition.bit))
            names.push_back(condition.name);
    return names;
}

/// What the home search will do to the motor. Versions 1 and 2 of the PIC-SERVO leave that to the host (DS-V
/// 5.2).
std::string homingStop(const ModuleSnapshot& s) {
    const bool stops = s.homing.inProgress() && (s.stepper || s.identity.version >= 3);
    return lowered(enumName<Homing::Stop::Smooth>(stops ? s.homing.stop() : Homing::Stop::None));
}

Json servoJson(const ModuleSnapshot& s) {
    const ServoSnapshot& servo = s.servo;
    return {{"position", servo.position},
            {"shaft", servo.shaftCounts},
            {"command_position", servo.commandPosition},
            {"position_error", servo.positionError},
            {"velocity", servo.velocity},
            {"command_velocity", servo.commandVelocity},
            {"pwm", servo.pwm},
            {"current_limit_adjustment", servo.currentLimitAdjustment},
            {"current", servo.amperes},
            {"analog", servo.analog},
            {"analog_input", orNull(servo.analogInput)},
            {"servo_on", servo.servoOn},
            {"amp_enabled", servo.ampEnabled},
            {"power", servo.power},
            {"mode", kServoModes[static_cast<std::size_t>(servo.mode)]},
            {"home", servo.home},
            {"sticky", stickyJson(s)},
            {"limit1", servo.limit1},
            {"limit2", servo.limit2},
            {"index", servo.index},
            {"load", servo.motor.loadNm},
            {"inertia", servo.motor.inertiaKgM2},
            {"friction", servo.motor.coulombNm},
            {"play", servo.motor.playCounts},
            {"load_play", servo.motor.loadPlayCounts},
            {"counts_per_turn", servo.motor.countsPerTurn},
            {"deadband", servo.motor.amplifierDeadbandPwm},
            {"gain", servo.motor.gain()},
            {"encoder_noise", servo.motor.encoderNoiseCounts},
            {"elastic_inertia", servo.motor.elasticInertiaKgM2},
            {"resonance", servo.motor.resonanceHz},
            {"travel_min", stopJson(servo.motor.travelMinCounts)},
            {"travel_max", stopJson(servo.motor.travelMaxCounts)},
            {"limits", servo.limitsAutomatic ? "auto" : "manual"},
            {"home_switch_at", orNull(servo.homeSwitchAt)},
            {"gains", gainsJson(servo.gains)}};
}

Json pinsJson(const StepperPins& pins) {
    return {{"estop", pins.estop},   {"in1", pins.in1},       {"in2", pins.in2},
            {"limit1", pins.limit1}, {"limit2", pins.limit2}, {"home_switch", pins.homeSwitch}};
}

Json parametersJson(const StepperParameters& p) {
    return {{"speed_mode", multiplier(p.speedMode())},
            {"ignore_limits", p.has(StepperParameters::kIgnoreLimits)},
            {"ignore_estop", p.has(StepperParameters::kIgnoreEstop)},
            {"motor_off_on_stop", p.has(StepperParameters::kMotorOff)},
            {"minimum_speed", p.minimumSpeed},
            {"running_current", p.runningCurrent},
            {"holding_current", p.holdingCurrent},
            {"thermal_limit", p.thermalLimit}};
}

Json stepperJson(const StepperSnapshot& stepper) {
    return {{"position", stepper.position},
            {"shaft", stepper.shaft},
            {"step_rate", stepper.stepRate},
            {"speed", stepper.speed},
            {"timer_count", stepper.timerCount},
            {"moving", stepper.moving},
            {"reverse", stepper.reverse},
            {"mode", kStepperModes[static_cast<std::size_t>(stepper.mode)]},
            {"amp_enabled", stepper.ampEnabled},
            {"power", stepper.inputs.power},
            {"analog", stepper.inputs.analog},
            {"home", stepper.home},
            {"parameters", stepper.parameters ? parametersJson(*stepper.parameters) : Json(nullptr)},
            {"inputs", pinsJson(stepper.inputs)},
            {"travel_min", orNull(stepper.travelMin)},
            {"travel_max", orNull(stepper.travelMax)},
            {"limits", stepper.limitsAutomatic ? "auto" : "manual"},
            {"home_switch_at", orNull(stepper.homeSwitchAt)},
            {"load_play", stepper.loadPlay},
            {"outputs", stepper.outputs},
            {"current_limit", stepper.currentLimit}};
}

/// Lists the pins, IO1 first.
Json pinList(std::uint16_t mask) {
    Json pins = Json::array();
    for (unsigned pin = 0; pin < 12; ++pin)
        pins.push_back((unsigned{mask} >> pin & 1U) != 0);
    return pins;
}

Json ioJson(const IoSnapshot& io) {
    return {{"pins", pinList(io.levels)},
            {"is_input", pinList(io.directions)},
            {"outputs", pinList(io.outputs)},
            {"analog", io.analog},
            {"pwm", io.pwm},
            {"stored_outputs", pinList(io.storedOutputs)},
            {"stored_pwm", io.storedPwm},
            {"timer_mode", !io.counting   ? "off"
                           : io.countsPin ? "counter"
                                          : "timer"},
            {"prescaler", io.prescaler},
            {"count", io.count},
            {"latched_pins", pinList(io.latchedPins)},
            {"latched_count", io.latchedCount}};
}

/// What CMC and SC have beyond every other PIC-SERVO.
Json laterServoJson(const ModuleIdentity& module, const ServoSnapshot& servo) {
    const LaterServoSnapshot& s = *servo.later;
    Json json{{"pwm_exact", s.pwm},
              {"path_points", s.pathPoints},
              {"path_mode", s.pathMode},
              {"fast_path", s.fastPath},
              {"advanced_features", s.advancedFeatures}};
    if (!isSc(module))
        return json;
    json.update({{"vsense", s.voltSense},
                 {"limit_stop", s.limitStopsOff        ? "off"
                                : s.limitStopsAbruptly ? "abrupt"
                                                       : "none"},
                 {"three_phase", s.threePhase},
                 {"antiphase", s.antiphase},
                 {"step_and_direction", s.stepAndDirection},
                 {"step_multiplier", servo.gains.sm},
                 {"saved", orNull(s.saved)}});
    return json;
}

}  // namespace

Json stateJson(const ModuleSnapshot& s, unsigned number) {
    Json json{{"module", number},
              {"type", s.stepper ? "step"
                       : s.io    ? "io"
                                 : "servo"},
              {"version", s.identity.version},
              {"address", s.address},
              {"group", s.group},
              {"leader", s.leader},
              {"baud", std::lround(s.baud)},
              {"listening", s.listening},
              {"addr_broken", s.addressLineBroken},
              {"time", toSeconds(s.time.time_since_epoch())},
              {"tick", s.tick},
              {"status", s.status},
              {"status_items", s.items}};
    if (s.io) {
        json.update(ioJson(*s.io));
        return json;
    }
    json[s.stepper ? "inputs_byte" : "auxiliary"] = s.pins;
    json["homing"] = s.homing.inProgress();
    json["homing_conditions"] = homingConditions(s);
    json["homing_stop"] = homingStop(s);
    json.update(s.stepper ? stepperJson(*s.stepper) : servoJson(s));
    if (s.servo.later)
        json.update(laterServoJson(s.identity, s.servo));
    return json;
}

}  // namespace nmc::sim
