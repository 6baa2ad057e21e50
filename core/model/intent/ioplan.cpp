// SPDX-License-Identifier: MIT
#include "model/intent/ioplan.h"

namespace nmc {

namespace {

using Orders = std::vector<bus::Order>;
using Plan = tl::expected<Orders, Refusal>;

constexpr StatusItems kLatched{StatusItems::LatchedPins | StatusItems::LatchedCounter};

struct Planner {
    const ModuleState& module;

    Plan operator()(const iointent::SetDirection& set) const {
        return allowed(Request::ControlIo, [&] {
            Orders orders = {step(io::SetDirection{set.inputs})};
            // Whether an input keeps what it was told as an output is not said: what becomes an output is
            // told its level on both sides of that.
            if (const auto levels = module.pins.levels(*module.latest)) {
                orders.insert(orders.begin(), step(io::SetOutput{*levels}));
                orders.push_back(step(io::SetOutput{*levels}));
            }
            return orders;
        });
    }
    Plan operator()(const iointent::SetOutput& set) const {
        const auto levels = module.latest ? module.pins.levels(*module.latest) : std::nullopt;
        if (!levels)
            return tl::unexpected(Refusal::Silent);
        const unsigned bit = 1U << set.pin;
        const unsigned outputs = set.high ? *levels | bit : *levels & ~bit;
        return allowed(Request::SetOutputs,
                       [&] { return Orders{step(io::SetOutput{static_cast<std::uint16_t>(outputs)})}; });
    }
    Plan operator()(const iointent::SetPwm& set) const {
        auto values = module.pins.pwm().value_or(std::array<std::uint8_t, 2>{});
        values.at(set.output) = set.value;
        return allowed(Request::SetOutputs, [&] { return Orders{step(io::SetPwm{values[0], values[1]})}; });
    }
    Plan operator()(const iointent::SetTimer& set) const {
        return allowed(Request::ControlIo, [&] { return Orders{step(set.mode)}; });
    }
    Plan operator()(const iointent::StoreOutputs& store) const {
        return allowed(Request::SetOutputs, [&] { return Orders{step(store.outputs)}; });
    }
    Plan operator()(const iointent::SynchOutput&) const {
        return allowed(Request::SetOutputs, [&] { return Orders{step(io::SynchOutput{})}; });
    }
    Plan operator()(const iointent::SynchInput&) const {
        return allowed(Request::ControlIo, [&] {
            return Orders{step(io::SynchInput{}), step(ReadStatus{kLatched})};
        });
    }
    Plan operator()(const auto& /*of a motor*/) const { return tl::unexpected(Refusal::NoMotor); }

private:
    [[nodiscard]] bus::Order step(const IoCommand& command) const { return {module.info.index, command}; }
    template <typename MakeOrders>
    [[nodiscard]] Plan allowed(Request request, MakeOrders makeOrders) const {
        if (const auto refusal = whyNotIo(request, module))
            return tl::unexpected(*refusal);
        return makeOrders();
    }
};

}  // namespace

Plan planIo(const Intent& intent, const ModuleState& module) {
    return std::visit(Planner{module}, intent);
}

std::optional<Refusal> whyNotIo(Request request, const ModuleState& module) {
    switch (request) {
        case Request::SetOutputs:
        case Request::ControlIo:
        case Request::ResetModule:
            return whyNotTold(request, module);
        case Request::StartLoaded:  // of its group: Synch Output
            if (const auto refusal = whyNotTold(request, module))
                return refusal;
            return module.pins.stored() ? std::nullopt : std::optional(Refusal::NothingLoaded);
        case Request::Enable:
        case Request::Move:
        case Request::Load:
        case Request::GoHome:
        case Request::Run:
        case Request::Hold:
        case Request::StopMotion:
        case Request::MotorOff:
        case Request::ApplyGains:
        case Request::ClearStickyBits:
        case Request::ResetPosition:
        case Request::SaveAsHome:
        case Request::DeclarePosition:
        case Request::StopHere:
        case Request::DrivePwm:
        case Request::CheckDirection:
        case Request::SetAmplifier:
        case Request::ControlSc:
        case Request::Home:
        case Request::ArmLimitStop:
        case Request::SetParameters:
            break;
    }
    return Refusal::NoMotor;
}

}  // namespace nmc
