// SPDX-License-Identifier: MIT
#pragma once

// The layout of a machine file, defined once: reader and writer are "forms" that are passed through it.
// Machines are compared by the writer's output. For .cpp files of core/model only.
//
// The structured bindings name every member, so that adding a member to a struct of model/settings/machine.h
// without adding it here is a compile error.

#include <array>
#include <concepts>
#include <string_view>
#include <variant>

#include "model/settings/machine.h"
#include "protocol/baud.h"

namespace nmc::layout {

inline constexpr int kVersion = 1;
inline constexpr std::string_view kFormat = "nmc-panel-machine";
inline constexpr std::size_t kMaxAxes = 32;     ///< modules on a line (DS-V 4.1)
inline constexpr std::size_t kMaxGroups = 127;  ///< addresses; one without members may still have a name
inline constexpr std::size_t kMaxPins = 12;  ///< of a PIC-I/O, which also has 2 PWM outputs and 3 A/D inputs
inline constexpr std::size_t kMaxPwm = 2;
inline constexpr std::size_t kMaxAnalog = 3;
// The panel sets no limits to these, and must be able to read what it has saved: more than anybody enters.
inline constexpr std::size_t kMaxPoints = 5'000;
inline constexpr std::size_t kMaxSequences = 1'000;
inline constexpr std::size_t kMaxRows = 5'000;

struct Bounds {
    double min;
    double max;
    bool ofModule = false;    ///< the range is that of the module
    bool eitherSign = false;  ///< the range applies to the magnitude
};

[[nodiscard]] constexpr Bounds takenByModule(ValueRange range) {
    return {static_cast<double>(range.min), static_cast<double>(range.max), true};
}

/// The largest 16.16 fixed-point number (DS-V 4.4).
inline constexpr double kMaxServoNumber = 0x7FFFFFFF / kFixedPointOne;
/// 250 units of 200 steps/s (DS-S 4.1).
inline constexpr double kMaxStepSpeed = 50'000.0;
/// One unit of 200 steps/s every 0.25 ms.
inline constexpr double kMaxStepAcceleration = 800'000.0;
inline constexpr Bounds kDistance{0, 0x7FFFFFFF, true};
inline constexpr Bounds kPlace{-0x7FFFFFFF, 0x7FFFFFFF, true};
inline constexpr Bounds kPerUnit{kMinCountsPerUnit, kMaxCountsPerUnit, false, true};
inline constexpr Bounds kSeconds{0, 86'400};
inline constexpr Bounds kAnyNumber{-1e12, 1e12};

[[nodiscard]] constexpr Bounds velocityBounds(bool steps) {
    return {0, steps ? kMaxStepSpeed : kMaxServoNumber, true};
}
[[nodiscard]] constexpr Bounds accelerationBounds(bool steps) {
    return {0, steps ? kMaxStepAcceleration : kMaxServoNumber, true};
}

/// Endings of keys that state the units of their numbers.
struct UnitSuffixes {
    std::string_view distance;
    std::string_view velocity;
    std::string_view acceleration;
    std::string_view perUnit;  ///< a whole key
};
inline constexpr UnitSuffixes kServoSuffixes{"_counts", "_counts_per_tick", "_counts_per_tick2",
                                             "counts_per_unit"};
inline constexpr UnitSuffixes kStepperSuffixes{"_steps", "_steps_per_s", "_steps_per_s2", "steps_per_unit"};

[[nodiscard]] constexpr const UnitSuffixes& suffixes(bool steps) {
    return steps ? kStepperSuffixes : kServoSuffixes;
}

/// Whether a field may be missing from an object; it then keeps its default.
enum class Need : std::uint8_t { Required, Optional };

template <typename T, typename U>
concept As = std::same_as<std::remove_const_t<T>, U>;

/// The words of an enum that counts from 0 to `Last`, by value.
template <auto Last>
using Words = std::array<std::string_view, static_cast<std::size_t>(Last) + 1>;

inline constexpr Words<UnitKind::Own> kUnitWords{"native", "turns", "degrees", "millimetres", "own"};
inline constexpr Words<HomingRecipe::Stop::Off> kStopWords{"abruptly", "smoothly", "motor off"};
/// 8, 4, 2 or 1 times the basic speed range (DS-S 4.1).
inline constexpr Words<stepper::SpeedMode::X1> kSpeedWords{"8x", "4x", "2x", "1x"};
/// Any other type is written as its number.
inline constexpr Words<ModuleType::Stepper> kTypeWords{"PIC-SERVO", "PIC-ADC", "PIC-I/O", "PIC-STEP"};

template <typename Form, As<ModuleIdentity> T>
void fields(Form& form, T& identity) {
    auto& [type, version] = identity;
    form.type("type", type);
    form.whole("version", version, {0, 255});
}

template <typename Form, As<AxisUnit> T>
void fields(Form& form, T& unit) {
    auto& [kind, countsPerUnit, ownSymbol] = unit;
    form.choice("kind", kind, kUnitWords);
    form.perUnit(countsPerUnit, kind == UnitKind::Native ? Need::Optional : Need::Required);
    form.text("symbol", ownSymbol);
}

template <typename Form, As<MotionSettings> T>
void fields(Form& form, T& motion) {
    auto& [velocity, acceleration, runVelocity, holdVelocity, holdCap, stepSize] = motion;
    form.velocity("velocity", velocity, Need::Optional);
    form.acceleration("acceleration", acceleration, Need::Optional);
    form.velocity("run_velocity", runVelocity, Need::Optional);
    form.velocity("hold_velocity", holdVelocity, Need::Optional);
    form.velocity("hold_cap", holdCap, Need::Optional);
    form.distance("step", stepSize, Need::Optional);
}

template <typename Form, As<TravelSettings> T>
void fields(Form& form, T& travel) {
    auto& [lowest, highest, fastest] = travel;
    form.place("lowest", lowest);
    form.place("highest", highest);
    form.velocity("fastest", fastest, Need::Optional);
}

template <typename Form, As<BacklashSettings> T>
void fields(Form& form, T& backlash) {
    auto& [distance, fromAbove] = backlash;
    form.distance("distance", distance);
    form.flag("from_above", fromAbove);
}

template <typename Form, As<ArrivalSettings> T>
void fields(Form& form, T& arrival) {
    auto& [tolerance, seconds] = arrival;
    form.distance("tolerance", tolerance);
    form.seconds("duration_s", seconds);
}

template <typename Form, As<LimitStopSettings> T>
void fields(Form& form, T& limitStop) {
    auto& [eachMotion, stop] = limitStop;
    auto& [onLimit1, onLimit2, manner, onPositionError, onCurrentLimit] = stop;
    form.flag("each_motion", eachMotion);
    form.flag("on_limit1", onLimit1);
    form.flag("on_limit2", onLimit2);
    form.flag("on_position_error", onPositionError);
    form.flag("on_current_limit", onCurrentLimit);
    form.choice("stop", manner, kStopWords);
}

template <typename Form, As<WorkOffset> T>
void fields(Form& form, T& offset) {
    auto& [name, counts] = offset;
    form.text("name", name);
    form.whole("from_home", counts, kPlace);
}

template <typename Form, As<HomingRecipe> T>
void fields(Form& form, T& recipe) {
    auto& [onLimit1, onLimit2, onIndex, onPositionError, onCurrentLimit, onHomeSwitch, thenIndex, reverse,
           velocity, indexVelocity, acceleration, stop, travelLimit, timeLimit, goToHome, makeZero] = recipe;
    form.flag("on_limit1", onLimit1);
    form.flag("on_limit2", onLimit2);
    form.flag("on_index", onIndex);
    form.flag("on_position_error", onPositionError);
    form.flag("on_current_limit", onCurrentLimit);
    form.flag("on_home_switch", onHomeSwitch);
    form.flag("then_index", thenIndex);
    form.flag("reverse", reverse);
    form.velocity("velocity", velocity);
    form.velocity("index_velocity", indexVelocity, Need::Optional);
    form.acceleration("acceleration", acceleration, Need::Optional);
    form.choice("stop", stop, kStopWords);
    form.distance("travel_limit", travelLimit);
    form.seconds("time_limit_s", timeLimit);
    form.flag("go_to_home", goToHome);
    form.flag("make_zero", makeZero);
}

template <typename Form, As<AnalogScale> T>
void fields(Form& form, T& scale) {
    auto& [perCount, atZero, unit] = scale;
    form.real("per_count", perCount, kAnyNumber);
    form.real("at_zero", atZero, kAnyNumber);
    form.text("unit", unit);
}

template <typename Form, As<servo::SetGain> T>
void fields(Form& form, T& gains) {
    auto& [kp, kd, ki, il, ol, cl, el, sr, db, sm] = gains;
    form.whole("Kp", kp, takenByModule(servo::kGainRange));
    form.whole("Kd", kd, takenByModule(servo::kGainRange));
    form.whole("Ki", ki, takenByModule(servo::kGainRange));
    form.whole("IL", il, takenByModule(servo::kGainRange));
    form.whole("OL", ol, takenByModule(servo::kByteRange));
    form.whole("CL", cl, takenByModule(servo::kByteRange));
    form.whole("EL_counts", el, takenByModule(servo::kPositionErrorRange));
    form.whole("SR", sr, takenByModule(servo::kServoRateRange));
    form.whole("DB", db, takenByModule(servo::kByteRange));
    form.whole("SM", sm, takenByModule(servo::kByteRange));
}

template <typename Form, As<servo::IoControl> T>
void fields(Form& form, T& io) {
    auto& [limit1Output, limit2Output, limit1IsInput, limit2IsInput, fastPath] = io;
    form.flag("limit1_is_input", limit1IsInput);
    form.flag("limit2_is_input", limit2IsInput);
    form.flag("limit1_output", limit1Output);
    form.flag("limit2_output", limit2Output);
    form.mark("fast_path", fastPath);
}

template <typename Form, As<stepper::SetParameters> T>
void fields(Form& form, T& parameters) {
    auto& [speedMode, ignoreLimits, ignoreEstop, motorOffOnLimitOrEstop, minimumProfileSpeed, runCurrent,
           holdCurrent, thermalLimit] = parameters;
    form.choice("speed_mode", speedMode, kSpeedWords);
    form.whole("minimum_profile_speed", minimumProfileSpeed, takenByModule(stepper::kSpeedRange));
    form.whole("run_current", runCurrent, takenByModule(stepper::kByteRange));
    form.whole("hold_current", holdCurrent, takenByModule(stepper::kByteRange));
    form.whole("thermal_limit", thermalLimit, takenByModule(stepper::kByteRange));
    form.flag("ignore_limits", ignoreLimits);
    form.flag("ignore_estop", ignoreEstop);
    form.flag("motor_off_on_limit_or_estop", motorOffOnLimitOrEstop);
}

template <typename Form, As<OutputSettings> T>
void fields(Form& form, T& output) {
    auto& [name, asks, offAtStop] = output;
    form.text("name", name);
    form.flag("asks", asks);
    form.flag("off_at_stop", offAtStop);
}

template <typename Form, As<AnalogInput> T>
void fields(Form& form, T& input) {
    auto& [name, scale] = input;
    form.text("name", name);
    form.part("scale", scale);
}

template <typename Form, As<PinSettings> T>
void fields(Form& form, T& settings) {
    auto& [pins, pwm, analog] = settings;
    form.list("pins", pins, kMaxPins);
    form.list("pwm", pwm, kMaxPwm);
    form.list("analog", analog, kMaxAnalog);
}

template <typename Form, As<AxisSettings> T>
void fields(Form& form, T& axis) {
    auto& [name, expected, unit, motion, travel, backlash, arrival, homing, limitStop, workOffsets, analog,
           gains, io, fastPath, parameters, accelerationTime, outputNames, inputNames, pins] = axis;
    form.text("name", name);
    form.part("expected", expected);
    // From here on, the names of the numbers depend on the chip's units.
    form.setSteps(expected.has_value() && expected->type == ModuleType::Stepper);
    form.part("unit", unit);
    form.part("motion", motion);
    form.part("travel", travel);
    form.part("backlash", backlash);
    form.part("arrival", arrival);
    form.part("homing", homing);
    form.part("limit_stop", limitStop);
    form.list("work_offsets", workOffsets, kMaxWorkOffsets);
    form.part("analog", analog);
    form.part("gains", gains);
    form.part("io", io);
    form.flag("fast_path", fastPath);
    form.part("parameters", parameters);
    form.real("acceleration_time", accelerationTime, {0, 255, true}, Need::Optional);
    form.names("output_names", outputNames);
    form.names("input_names", inputNames);
    form.part("pins", pins);
}

template <typename Form, As<GroupSettings> T>
void fields(Form& form, T& group) {
    auto& [address, name, members, leader] = group;
    form.whole("address", address, {0x80, 0xFE, true});
    form.text("name", name);
    form.modules("modules", members);
    form.module("leader", leader);
}

template <typename Form, As<OperatorRights> T>
void fields(Form& form, T& rights) {
    auto& [enable, jog, points, moves, homing, outputs] = rights;
    form.flag("enable", enable);
    form.flag("jog", jog);
    form.flag("points", points);
    form.flag("moves", moves);
    form.flag("homing", homing);
    form.flag("outputs", outputs);
}

template <typename Form, As<PointAxis> T>
void fields(Form& form, T& axis) {
    auto& [module, counts, fromHome] = axis;
    form.module("module", module);
    form.whole("counts", counts, takenByModule(servo::kPositionRange));
    form.flag("from_home", fromHome);
}

template <typename Form, As<Point> T>
void fields(Form& form, T& point) {
    auto& [name, axes] = point;
    form.text("name", name);
    form.list("axes", axes, kMaxAxes);
}

/// The actions of a row, in the order of Action.
inline constexpr std::array<std::string_view, std::variant_size_v<Action>> kActionWords{
    "move to", "wait", "wait for arrival", "wait for input", "set output", "home",
    "repeat",  "call", "wait for A/D"};
inline constexpr Words<InputPin::Io12> kPinWords{"limit 1", "limit 2", "IN1",  "IN2",  "home switch", "IO1",
                                                 "IO2",     "IO3",     "IO4",  "IO5",  "IO6",         "IO7",
                                                 "IO8",     "IO9",     "IO10", "IO11", "IO12"};

template <typename Form, As<action::MoveTo> T>
void fields(Form& form, T& move) {
    auto& [point, together, waits, percent] = move;
    form.text("point", point);
    form.flag("together", together);
    form.flag("waits", waits);
    form.whole("percent", percent, {1, 100});
}
template <typename Form, As<action::Wait> T>
void fields(Form& form, T& wait) {
    auto& [seconds] = wait;
    form.seconds("seconds", seconds);
}
template <typename Form, As<action::WaitForArrival> T>
void fields(Form& /*form*/, T& /*wait*/) {}
template <typename Form, As<action::WaitForInput> T>
void fields(Form& form, T& wait) {
    auto& [module, pin, active, timeout] = wait;
    form.module("module", module);
    form.choice("input", pin, kPinWords);
    form.flag("active", active);
    form.seconds("timeout_s", timeout);
}
template <typename Form, As<action::SetOutput> T>
void fields(Form& form, T& set) {
    auto& [module, output, on] = set;
    form.module("module", module);
    form.whole("output", output, {1, kMaxPins});
    form.flag("on", on);
}
template <typename Form, As<action::Home> T>
void fields(Form& form, T& home) {
    auto& [module] = home;
    form.module("module", module);
}
template <typename Form, As<action::Repeat> T>
void fields(Form& form, T& repeat) {
    auto& [from, times] = repeat;
    form.row("from_row", from, kMaxRows);
    form.whole("times", times, {0, 1'000'000});
}
template <typename Form, As<action::Call> T>
void fields(Form& form, T& call) {
    auto& [sequence] = call;
    form.text("sequence", sequence);
}

template <typename Form, As<action::WaitForAnalog> T>
void fields(Form& form, T& wait) {
    auto& [module, input, above, level, timeout] = wait;
    form.module("module", module);
    form.whole("input", input, {1, kMaxAnalog});
    form.flag("above", above);
    form.whole("level", level, {0, 255});
    form.seconds("timeout_s", timeout);
}

template <typename Form, As<Action> T>
void fields(Form& form, T& row) {
    form.alternative("do", row, kActionWords);
    std::visit([&form](auto& chosen) { fields(form, chosen); }, row);
}

template <typename Form, As<Sequence> T>
void fields(Form& form, T& sequence) {
    auto& [name, rows] = sequence;
    form.text("name", name);
    form.list("rows", rows, kMaxRows);
}

template <typename Form, As<Machine> T>
void fields(Form& form, T& machine) {
    auto& [name, baud, axes, groups, program, homeOrder, operatorRights] = machine;
    form.text("name", name);
    form.whole("rate_bd", baud, {0, kMaxBaud}, Need::Optional);
    form.list("axes", axes, kMaxAxes);
    form.list("groups", groups, kMaxGroups);
    auto& [points, sequences] = program;
    form.list("points", points, kMaxPoints);
    form.list("sequences", sequences, kMaxSequences);
    form.modules("home_order", homeOrder);
    form.part("operator", operatorRights);
}

}  // namespace nmc::layout
