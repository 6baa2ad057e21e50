// SPDX-License-Identifier: MIT
#include "model/api/apistate.h"

#include "base/enumname.h"
#include "base/text.h"
#include "model/intent/travel.h"
#include "model/module/modulescale.h"
#include "model/sequence/sequencecheck.h"
#include "model/settings/pinsof.h"

namespace nmc::api {

namespace {

template <typename T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

/// The levels of a motor module's inputs (DS-V 5.3, DS-S 5.2), as far as they are known. A limit switch of a
/// PIC-SERVO whose pin is an output is not.
Json inputsOf(const ModuleState& module) {
    Json inputs = Json::object();
    const auto& latest = module.latest;
    if (module.isServo()) {
        inputs["limit1"] = orNull(readPin(InputPin::Limit1, module));
        inputs["limit2"] = orNull(readPin(InputPin::Limit2, module));
        inputs["power"] = latest ? Json(latest->servoStatus().powerOn()) : Json();
    } else if (module.isStepper()) {
        const bool known = latest && latest->aux;
        const stepper::InputsByte pins{latest ? latest->aux.value_or(0) : std::uint8_t{0}};
        for (const auto& [name, high] :
             {std::pair{"estop", pins.estop()}, std::pair{"in1", pins.in1()}, std::pair{"in2", pins.in2()},
              std::pair{"limit1", pins.limit1()}, std::pair{"limit2", pins.limit2()},
              std::pair{"home", pins.homeSwitch()}})
            inputs[name] = known ? Json(high) : Json();
        inputs["power"] = latest ? Json(latest->stepperStatus().powerOn()) : Json();
    }
    return inputs;
}

/// The A/D inputs in their units: one of a motor module, three of a PIC-I/O.
Json analogOf(const ModuleState& module, const AxisSettings& axis) {
    Json list = Json::array();
    const auto add = [&list](const std::string& name, const AnalogScale& scale, auto counts) {
        list.push_back({{"name", name},
                        {"value", counts ? Json(scale.atZero + *counts * scale.perCount) : Json()},
                        {"unit", scale.unit},
                        {"per_count", scale.perCount},
                        {"at_zero", scale.atZero}});
    };
    const StatusReport report = module.latest.value_or(StatusReport{});
    if (module.isServo() || module.isStepper())
        add({}, axis.analog, report.analog);
    else if (module.isIo())
        for (std::size_t i = 0; i < report.analogs.size(); ++i) {
            const AnalogInput input = PinSettings::of(pinsOf(axis).analog, i);
            add(input.name, input.scale, report.analogs.at(i));
        }
    return list;
}

/// The pins of a PIC-I/O.
Json ioPinsOf(const ModuleState& module, const AxisSettings& axis) {
    Json list = Json::array();
    const auto levels = module.latest.value_or(StatusReport{}).pins;
    const auto bit = [](const auto& mask, unsigned pin) {
        return mask ? Json((unsigned{*mask} >> pin & 1U) != 0) : Json();
    };
    for (unsigned pin = 0; module.isIo() && pin < io::kPins; ++pin)
        list.push_back({{"number", pin + 1},
                        {"name", PinSettings::of(pinsOf(axis).pins, pin).name},
                        {"input", bit(module.pins.inputs, pin)},
                        {"high", bit(levels, pin)}});
    return list;
}

}  // namespace

Json stateOf(const ModuleState& module, const AxisSettings& axis) {
    const AxisScale scale = scaleOf(module, axis);
    const std::string unit = symbolOf(axis.unit, module.isStepper());
    const StatusReport report = module.latest.value_or(StatusReport{});
    const auto inUnits = [&](const std::optional<std::int32_t>& counts) {
        return counts ? Json(scale.position(*counts) + 0.0) : Json();  // + 0.0: no -0 on a reversed axis
    };
    const auto perSecond = module.speed.perSecond();
    const TravelForce force = travelForce(module);
    return {{"number", module.info.index.value() + 1},
            {"name", axis.name},
            {"unit", unit},
            {"velocity_unit", velocitySymbolOf(scale, module.isStepper())},
            {"counts_per_unit", scale.counts(1.0)},
            {"type", module.isKnown() ? Json(nameOf(module.info.identity.type)) : Json()},
            {"version", module.info.identity.version},
            {"state", enumName<Activity::Ready>(module.activity())},
            {"answers", !module.silent},
            {"on", module.driveOn()},
            {"moving", module.stillMoves()},
            {"position", inUnits(report.position)},
            {"counts", orNull(report.position)},
            {"counts_per_second", orNull(perSecond)},
            {"home", module.home.place() ? inUnits(module.home.place()->counts) : Json()},
            {"goal", inUnits(module.goal())},
            {"travel_limits_in_force",
             force == TravelForce::NotSet ? Json() : Json(force == TravelForce::InForce)},
            {"gains", gainsOf(module.gains)},
            {"inputs", inputsOf(module)},
            {"analog", analogOf(module, axis)},
            {"pins", ioPinsOf(module, axis)},
            {"pwm", module.isIo() && module.pins.pwm ? Json(*module.pins.pwm) : Json()},
            {"counter", orNull(report.counter)}};
}

std::string nameOf(ModuleType type) {
    return lowered(enumName<ModuleType::Stepper>(type));
}

Json stateOf(const LinkState& link, const Machine& machine) {
    Json modules = Json::array();
    for (const ModuleState& module : link.modules)
        modules.push_back(stateOf(module, machine.axis(module.info.index)));
    return {{"port", link.port},
            {"simulated", link.simulated},
            {"read_only", link.readOnly},
            {"phase", lowered(enumName<LinkPhase::Lost>(link.phase))},
            {"baud", link.baud},
            {"modules", std::move(modules)},
            {"lent", link.lent.has_value()}};
}

}  // namespace nmc::api
