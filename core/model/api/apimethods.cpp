// SPDX-License-Identifier: MIT
#include "model/api/apimethods.h"

#include <algorithm>
#include <cmath>
#include <concepts>

#include "base/enumname.h"
#include "base/text.h"
#include "model/intent/gainsplan.h"
#include "model/intent/jog.h"
#include "model/intent/pace.h"
#include "model/module/modulescale.h"
#include "model/module/servodefaults.h"
#include "model/module/stepperdefaults.h"
#include "model/sequence/sequencecheck.h"

namespace nmc::api {

namespace {

using Kind = Field::Kind;

template <typename T>
using Or = tl::expected<T, Problem>;

std::string_view unitOf(Kind kind) {
    switch (kind) {
        case Kind::Position:
        case Kind::Distance:
            return "of the axis";
        case Kind::Velocity:
            return "of the axis, per second; counts per tick if it is in counts";
        case Kind::Acceleration:
            return "of the axis, per second squared; counts per tick squared if it is in counts";
        case Kind::Axis:
        case Kind::Whole:
        case Kind::Flag:
        case Kind::Text:
            break;
    }
    return {};
}

/// Limits beyond which no value of an axis makes sense; they keep what follows within its range.
constexpr double kMostValue = 1e12;

bool fits(const Field& field, const Json& value) {
    switch (field.kind) {
        case Kind::Axis:
            return value.is_string() || value.is_number_integer();
        case Kind::Position:
        case Kind::Distance:
        case Kind::Velocity:
        case Kind::Acceleration:
            return value.is_number() && std::abs(value.get<double>()) <= kMostValue;
        case Kind::Whole:
            // What is too large for that becomes negative, and no range begins below 0.
            return value.is_number_integer() && field.range->contains(value.get<std::int64_t>());
        case Kind::Flag:
            return value.is_boolean();
        case Kind::Text:
            return value.is_string();
    }
    return false;
}

/// The request, its parameters, a value, and one more so that a list is not taken for what is in it.
constexpr int kDeepest = 3;
/// Absorbs the rounding of units, and of numbers that were read from a sentence.
constexpr double kGrain = 1 + 1e-9;

Problem wrong(std::string field, std::optional<NumberRange> range = {}) {
    return {Problem::Kind::FieldWrong, std::move(field), {}, std::move(range)};
}

/// Empty if what is wrong with the value is not its size.
std::optional<NumberRange> rangeOf(const Field& field, const Json& value) {
    if (!field.range || !value.is_number_integer())
        return std::nullopt;
    return NumberRange{static_cast<double>(field.range->min), static_cast<double>(field.range->max)};
}

}  // namespace

/// One call about one axis: its parameters in the chip's numbers.
struct AxisCall {
    const Json& parameters;
    const ModuleState& module;
    const AxisSettings& settings;
    AxisScale scale = scaleOf(module, settings);

    [[nodiscard]] bool has(const std::string& field) const { return parameters.contains(field); }
    [[nodiscard]] double value(const char* field) const { return parameters.at(field).get<double>(); }

    [[nodiscard]] std::string velocityUnit() const { return velocitySymbolOf(scale, module.isStepper()); }

    [[nodiscard]] Or<std::int32_t> counts(const char* field) const {
        const double counts = std::round(scale.counts(value(field)));
        if (counts < static_cast<double>(servo::kPositionRange.min) ||
            counts > static_cast<double>(servo::kPositionRange.max))
            return tl::unexpected(refused(Refusal::GoalOutOfRange));
        return static_cast<std::int32_t>(counts);
    }
    /// Without its sign, which only a jog may have, in the chip's unit.
    [[nodiscard]] Or<double> velocity(double slowest, double fastest, bool isJogged = false) const {
        if (module.isIo())
            return tl::unexpected(refused(Refusal::NoMotor));
        const auto native = scale.nativeVelocity(std::abs(value("velocity")));
        if (!native)
            return tl::unexpected(refused(Refusal::ServoRateUnknown));
        if (*native * kGrain < slowest || *native > fastest * kGrain || (!isJogged && value("velocity") < 0))
            return tl::unexpected(
                wrong("velocity", NumberRange{scale.velocity(slowest).value(),
                                              scale.velocity(fastest).value(), velocityUnit(), isJogged}));
        return *native;
    }
    /// At the velocity and acceleration given, or else at those of the axis.
    [[nodiscard]] Or<Pace> pace() const {
        AxisSettings axis = settings;
        if (has("velocity")) {
            const StepperSpeed mode = stepperdefaults::speedMode(module.stepper, settings);
            const auto native =
                module.isStepper()
                    ? velocity(stepperdefaults::slowestProfile(module.stepper, settings), mode.fastest())
                    : velocity(servodefaults::kSmallest, servodefaults::kLargest);
            if (!native)
                return tl::unexpected(native.error());
            axis.motion.velocity = module.isStepper() ? mode.ofSpeed(mode.speedBelow(*native)) : *native;
        }
        if (has("acceleration")) {
            const auto native = scale.nativeAcceleration(value("acceleration"));
            if (!native)
                return tl::unexpected(refused(Refusal::ServoRateUnknown));
            if (module.isStepper())
                return tl::unexpected(wrong("acceleration"));
            if (*native * kGrain < servodefaults::kSmallest || *native > servodefaults::kLargest * kGrain)
                return tl::unexpected(wrong(
                    "acceleration",
                    NumberRange{scale.acceleration(servodefaults::kSmallest).value(),
                                scale.acceleration(servodefaults::kLargest).value(), velocityUnit() + '2'}));
            axis.motion.acceleration = *native;
        }
        return paceOf(module, axis);
    }
    [[nodiscard]] unsigned whole(const std::string& name) const {
        return parameters.at(name).get<unsigned>();
    }
    /// For a method without parameters other than its axis.
    template <typename T>
    [[nodiscard]] Or<Call> request() const {
        return call(T{});
    }
    [[nodiscard]] Or<Call> call(Intent intent) const { return Call{module.info.index, std::move(intent)}; }

    [[nodiscard]] Or<Call> move() const {
        const auto to = counts("to");
        const auto pace = this->pace();
        if (!to || !pace)
            return tl::unexpected(to ? pace.error() : to.error());
        return call(intent::Move{moveTo(*to, *pace)});
    }
    [[nodiscard]] Or<Call> moveBy() const {
        const auto by = counts("by");
        const auto pace = this->pace();
        if (!by || !pace)
            return tl::unexpected(by ? pace.error() : by.error());
        return call(intent::MoveBy{{.counts = *by}, *pace});
    }
    [[nodiscard]] Or<Call> goHome() const {
        return pace().and_then([this](const Pace& pace) { return call(intent::GoHome{pace}); });
    }
    [[nodiscard]] Or<Call> home() const {
        if (!settings.homing)
            return tl::unexpected(refused(Refusal::NothingToFind));
        return call(intent::Home{*settings.homing, homeTolerance(settings.unit)});
    }
    [[nodiscard]] Or<Call> jog() const {
        const JogRange range = jogRange(module, settings);  // as for a held button
        const auto native = velocity(range.slowest, range.cap, true);
        if (!native)
            return tl::unexpected(native.error());
        const bool reverse = (value("velocity") < 0) != scale.reversed();
        const auto hold = nmc::jog(module, settings, *native, reverse);
        if (!hold)
            return tl::unexpected(refused(Refusal::ParametersUnknown));
        return Call{module.info.index, *hold};
    }
    [[nodiscard]] Or<Call> setGains() const {
        if (!module.isServo())
            return tl::unexpected(refused(Refusal::NotAServo));
        const auto& before = module.gains ? module.gains : settings.gains;
        servo::SetGain gains = before.value_or(servo::SetGain{});
        std::string missing;  // what a first Set Gain needs and is not given
        forEachGain(gains, [&]<typename T>(const std::string& name, T& gain, ValueRange /*range*/) {
            if (has(name))
                gain = static_cast<T>(whole(name));
            else if (std::integral<T>)
                missing += (missing.empty() ? "" : ", ") + name;
        });
        if (!before && !missing.empty())
            return tl::unexpected(Problem{Problem::Kind::FieldMissing, missing});
        // A gain that would not be sent must not be accepted.
        const bool lacksDb = has("db") && !gainsFor(module, gains).db;
        const bool lacksSm = has("sm") && !isSc(module.info.identity);
        if (lacksDb || lacksSm)
            return tl::unexpected(refused(Refusal::VersionLacksIt));
        if (has("sm") && !gains.db)
            return tl::unexpected(Problem{Problem::Kind::FieldMissing, "db"});
        return call(intent::ApplyGains{gains});
    }
    [[nodiscard]] Or<Call> setOutput() const {
        const auto intent =
            outputIntent({module.info.index, whole("output"), parameters.at("high").get<bool>()}, module);
        if (intent)
            return call(*intent);
        if (intent.error() == SequenceProblem::Kind::NoSuchPin)
            return tl::unexpected(wrong("output"));
        return tl::unexpected(Problem{intent.error() == SequenceProblem::Kind::NotAnOutput
                                          ? Problem::Kind::NotAnOutput
                                          : Problem::Kind::OutputsUnknown});
    }
    [[nodiscard]] Or<Call> setDirection() const {
        const bool input = parameters.at("input").get<bool>();
        if (!module.isIo())
            return tl::unexpected(refused(Refusal::NotAnIoModule));
        if (!has("pin") && !input)
            return tl::unexpected(Problem{Problem::Kind::FieldMissing, "pin"});
        if (has("pin") && !module.pins.inputs)
            return tl::unexpected(Problem{Problem::Kind::OutputsUnknown});
        const unsigned pins = has("pin") ? 1U << (whole("pin") - 1U) : io::kAllPins;
        const unsigned before = module.pins.inputs.value_or(0);
        return call(
            iointent::SetDirection{static_cast<std::uint16_t>(input ? before | pins : before & ~pins)});
    }
    [[nodiscard]] Or<Call> setPwm() const {
        // One command sets both outputs, and the other one may not change unasked.
        if (module.isIo() && !module.pins.pwm && !has("other"))
            return tl::unexpected(Problem{Problem::Kind::OutputsUnknown});
        iointent::SetPwm set{whole("output") - 1U, static_cast<std::uint8_t>(whole("value"))};
        if (has("other"))
            set.other = static_cast<std::uint8_t>(whole("other"));
        return call(set);
    }
};

namespace {

std::vector<Field> gainFields(const Field& axis) {
    std::vector<Field> all{axis};
    servo::SetGain gains{.db = std::uint8_t{0}};
    forEachGain(gains, [&](const std::string& name, const auto& /*gain*/, ValueRange range) {
        all.push_back(
            {name, Kind::Whole, false, "as it is if left out; needed while no gains are known", range});
    });
    return all;
}

std::vector<Method> makeMethods() {
    const Field axis{"axis", Kind::Axis, true, "name of the axis, or its number from 1"};
    const Field velocity{"velocity", Kind::Velocity, false, "that of the axis if left out"};
    const Field acceleration{"acceleration", Kind::Acceleration, false,
                             "PIC-SERVO; that of the axis if left out"};
    return {
        {"hello",
         Access::Read,
         "Must be called first.",
         {{"protocol", Kind::Text, true, "version that the client speaks, such as \"1.0\""},
          {"program", Kind::Text, true, "name of the client, for the user"}}},
        {"describe", Access::Read, "Lists all methods with their parameters."},
        {"state",
         Access::Read,
         "The chain and all its modules, or one of them.",
         {{"axis", Kind::Axis, false, "all modules if left out"}}},
        {"wait",
         Access::Read,
         "Answers once the axis is at rest, within its arrival tolerance if it has one, and nothing is pending "
         "for it.",
         {{"axis", Kind::Axis, false, "all axes, and a sequence that runs, if left out"}}},
        {"subscribe",
         Access::Read,
         "Selects what is sent without being asked for; calls replace one another.",
         {{"state", Kind::Flag, false, "\"state\" after changes, at most ten times a second"},
          {"events", Kind::Flag, false, "\"event\": every message that the window shows"},
          {"samples", Kind::Flag, false, "\"samples\": every status reply of every module"}}},
        {"request_control",
         Access::Read,
         "Asks the user for the right to move motors; answers once that is decided.",
         {{"on_disconnect", Kind::Text, false,
           "\"stop\" (default) or \"finish\": what becomes of its moves when the client disappears"}}},
        {"release_control", Access::Read, "Gives the right to move motors back."},
        {"stop",
         Access::Stop,
         "Stops all motors as STOP ALL does, or one axis smoothly.",
         {{"axis", Kind::Axis, false, "all motors if left out"}},
         &AxisCall::request<intent::StopSmoothly>},
        {"enable",
         Access::Control,
         "Switches amplifier and servo on.",
         {axis},
         &AxisCall::request<intent::Enable>},
        {"motor_off", Access::Stop, "Switches the motor off.", {axis}, &AxisCall::request<intent::MotorOff>},
        {"move",
         Access::Control,
         "Moves to a position.",
         {axis, {"to", Kind::Position, true, "goal"}, velocity, acceleration},
         &AxisCall::move},
        {"move_by",
         Access::Control,
         "Moves by a distance.",
         {axis, {"by", Kind::Distance, true, "signed"}, velocity, acceleration},
         &AxisCall::moveBy},
        {"jog",
         Access::Control,
         "Moves until 250 ms after the last call with the same axis and direction, or until another axis is jogged; call it every 100 ms or sooner.",
         {axis, {"velocity", Kind::Velocity, true, "signed; not above the max jog speed of the axis"}},
         &AxisCall::jog},
        {"go_home", Access::Control, "Moves to home.", {axis, velocity, acceleration}, &AxisCall::goHome},
        {"home", Access::Control, "Searches for home as set up for the axis.", {axis}, &AxisCall::home},
        {"zero",
         Access::Control,
         "Sets the present position to 0.",
         {axis},
         &AxisCall::request<intent::ResetPosition>},
        {"set_home",
         Access::Control,
         "Makes the present position home.",
         {axis},
         &AxisCall::request<intent::SaveAsHome>},
        {"clear_sticky_bits",
         Access::Control,
         "Clears the sticky bits of a PIC-SERVO.",
         {axis},
         &AxisCall::request<intent::ClearStickyBits>},
        {"set_gains", Access::Control, "Sends the gains of a PIC-SERVO.", gainFields(axis),
         &AxisCall::setGains},
        {"set_output",
         Access::Control,
         "Sets an output: a pin of a PIC-I/O, OUT1 to OUT5 of a PIC-STEP, or a limit pin of a PIC-SERVO.",
         {axis,
          {"output", Kind::Whole, true, "number of the pin", ValueRange{1, io::kPins}},
          {"high", Kind::Flag, true, ""}},
         &AxisCall::setOutput},
        {"set_direction",
         Access::Control,
         "Makes a pin of a PIC-I/O an input or an output.",
         {axis,
          {"input", Kind::Flag, true, ""},
          {"pin", Kind::Whole, false, "its number; all pins, as inputs, if left out",
           ValueRange{1, io::kPins}}},
         &AxisCall::setDirection},
        {"set_pwm",
         Access::Control,
         "Sets a PWM output of a PIC-I/O.",
         {axis,
          {"output", Kind::Whole, true, "its number", ValueRange{1, 2}},
          {"value", Kind::Whole, true, "255 is always on", ValueRange{0, 255}},
          {"other", Kind::Whole, false,
           "of the other output, if that is unknown; otherwise it stays as it is", ValueRange{0, 255}}},
         &AxisCall::setPwm},
        {"start_sequence",
         Access::Control,
         "Runs a sequence of the machine.",
         {{"name", Kind::Text, true, "its name"}}},
        {"go_to_point",
         Access::Control,
         "Moves the axes of a point there, all at once.",
         {{"name", Kind::Text, true, "its name"}}},
    };
}

}  // namespace

Json gainsOf(const std::optional<servo::SetGain>& gains) {
    if (!gains)
        return {};
    Json json = Json::object();
    forEachGain(*gains, [&](const std::string& name, const auto& gain, ValueRange /*range*/) {
        if (const std::optional<unsigned> number = gain)
            json[name] = *number;
    });
    return json;
}

const std::vector<Method>& methods() {
    static const std::vector<Method> all = makeMethods();
    return all;
}

const Method* findMethod(std::string_view name) {
    const auto found = std::ranges::find(methods(), name, &Method::name);
    return found != methods().end() ? &*found : nullptr;
}

Json describe() {
    Json list = Json::array();
    for (const Method& method : methods()) {
        Json fields = Json::array();
        for (const Field& field : method.fields) {
            Json entry{{"name", field.name},
                       {"kind", lowered(enumName<Kind::Text>(field.kind))},
                       {"required", field.required}};
            if (const std::string_view unit = unitOf(field.kind); !unit.empty())
                entry["unit"] = unit;
            if (field.range) {
                entry["min"] = field.range->min;
                entry["max"] = field.range->max;
            }
            if (!field.text.empty())
                entry["text"] = field.text;
            fields.push_back(std::move(entry));
        }
        list.push_back({{"name", method.name},
                        {"needs", lowered(enumName<Access::Stop>(method.access))},
                        {"text", method.text},
                        {"parameters", std::move(fields)}});
    }
    return {{"methods", std::move(list)}};
}

tl::expected<Request, BadRequest> readRequest(std::string_view line) {
    // What is nested more deeply is no parameter, and copying it would take as much stack as a program likes.
    const auto isShallow = [](int depth, Json::parse_event_t, Json&) { return depth <= kDeepest; };
    const Json json = Json::parse(line, isShallow, false);
    Request request;
    const auto bad = [&request](Problem problem) {
        return tl::unexpected(BadRequest{std::move(request.id), std::move(problem)});
    };
    if (json.is_discarded())
        return bad({Problem::Kind::NotJson});
    const auto part = [&json](const char* name) {
        return json.is_object() && json.contains(name) ? json.at(name) : Json();
    };
    const Json method = part("method"), parameters = part("params"), id = part("id");
    if (id.is_structured() || id.is_boolean())
        return bad({Problem::Kind::InvalidRequest});
    request.id = id;
    if (!method.is_string() || !(parameters.is_object() || parameters.is_null()))
        return bad({Problem::Kind::InvalidRequest});
    request.method = findMethod(method.get<std::string>());
    if (request.method == nullptr)
        return bad({Problem::Kind::NoMethod});
    for (const Field& field : request.method->fields) {
        const auto given = parameters.find(field.name);
        if (given == parameters.end() && field.required)
            return bad({Problem::Kind::FieldMissing, field.name});
        if (given == parameters.end())
            continue;
        if (!fits(field, *given))
            return bad(wrong(field.name, rangeOf(field, *given)));
        request.parameters[field.name] = *given;
    }
    return request;
}

Or<ModuleIndex> axisOf(const Json& parameters, const LinkState& link, const Machine& machine) {
    if (link.modules.empty())
        return tl::unexpected(refused(Refusal::NotConnected));
    const Json& axis = parameters.at("axis");
    const std::string name = axis.is_string() ? axis.get<std::string>() : std::string();
    std::optional<ModuleIndex> found;
    for (const ModuleState& module : link.modules) {
        const ModuleIndex index = module.info.index;
        // An axis without a name has only its number.
        const bool meant = axis.is_string() ? !name.empty() && name == machine.axis(index).name
                                            : axis.get<std::int64_t>() == index.value() + 1;
        if (meant && found)
            return tl::unexpected(Problem{Problem::Kind::AxisAmbiguous, "axis"});
        if (meant)
            found = index;
    }
    if (!found)
        return tl::unexpected(Problem{Problem::Kind::AxisUnknown, "axis"});
    return *found;
}

Or<Call> callOf(const Method& method, const Json& parameters, const LinkState& link, const Machine& machine) {
    const auto axis = axisOf(parameters, link, machine);
    if (!axis)
        return tl::unexpected(axis.error());
    const AxisCall call{parameters, link.modules[axis->value()], machine.axis(*axis)};
    return (call.*method.make)();
}

}  // namespace nmc::api
