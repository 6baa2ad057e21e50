// SPDX-License-Identifier: MIT
#include "model/intent/ioplan.h"

namespace nmc {

namespace {

using Orders = std::vector<bus::Order>;
using Plan = tl::expected<Orders, Refusal>;

constexpr StatusItems kLatched{StatusItems::LatchedPins | StatusItems::LatchedCounter};

struct IoPlanner {
    const ModuleState& module;

    Plan operator()(const iointent::SetDirection& set) const {
        return allowed(IntentKind::ControlIo, [&] {
            Orders orders = {step(io::SetDirection{set.inputs})};
            // It is not documented whether an input retains the level that it was sent as an output, so new
            // outputs are sent their level both before and after the change of direction.
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
            return tl::unexpected(Refusal::Unresponsive);
        const unsigned bit = 1U << set.pin;
        const unsigned outputs = set.high ? *levels | bit : *levels & ~bit;
        return allowed(IntentKind::SetOutputs,
                       [&] { return Orders{step(io::SetOutput{static_cast<std::uint16_t>(outputs)})}; });
    }
    Plan operator()(const iointent::SetPwm& set) const {
        auto values = module.pins.pwm.value_or(std::array<std::uint8_t, 2>{});
        values.at(set.output) = set.value;
        return allowed(IntentKind::SetOutputs, [&] {
            return Orders{step(io::SetPwm{values[0], values[1]})};
        });
    }
    Plan operator()(const iointent::SetTimer& set) const {
        return allowed(IntentKind::ControlIo, [&] { return Orders{step(set.mode)}; });
    }
    Plan operator()(const iointent::StoreOutputs& store) const {
        return allowed(IntentKind::SetOutputs, [&] { return Orders{step(store.outputs)}; });
    }
    Plan operator()(const iointent::SynchOutput&) const {
        return allowed(IntentKind::SetOutputs, [&] { return Orders{step(io::SynchOutput{})}; });
    }
    Plan operator()(const iointent::SynchInput&) const {
        return allowed(IntentKind::ControlIo, [&] {
            return Orders{step(io::SynchInput{}), step(ReadStatus{kLatched})};
        });
    }
    Plan operator()(const auto& /*of a motor*/) const { return tl::unexpected(Refusal::NoMotor); }

private:
    [[nodiscard]] bus::Order step(const IoCommand& command) const { return {module.info.index, command}; }
    template <typename MakeOrders>
    [[nodiscard]] Plan allowed(IntentKind kind, MakeOrders makeOrders) const {
        if (const auto refusal = whyNotIo(kind, module))
            return tl::unexpected(*refusal);
        return makeOrders();
    }
};

}  // namespace

Plan planIo(const Intent& intent, const ModuleState& module) {
    return std::visit(IoPlanner{module}, intent);
}

std::optional<Refusal> whyNotIo(IntentKind kind, const ModuleState& module) {
    switch (kind) {
        case IntentKind::SetOutputs:
        case IntentKind::ControlIo:
        case IntentKind::ResetModule:
            return whyInaccessible(kind, module);
        case IntentKind::StartLoaded:  // started with its group by Synch Output
            if (const auto refusal = whyInaccessible(kind, module))
                return refusal;
            return module.pins.stored ? std::nullopt : std::optional(Refusal::NothingLoaded);
        case IntentKind::Enable:
        case IntentKind::Move:
        case IntentKind::Load:
        case IntentKind::GoHome:
        case IntentKind::Run:
        case IntentKind::Hold:
        case IntentKind::StopMotion:
        case IntentKind::MotorOff:
        case IntentKind::ApplyGains:
        case IntentKind::ClearStickyBits:
        case IntentKind::ResetPosition:
        case IntentKind::SaveAsHome:
        case IntentKind::DeclarePosition:
        case IntentKind::StopHere:
        case IntentKind::DrivePwm:
        case IntentKind::CheckDirection:
        case IntentKind::SetAmplifier:
        case IntentKind::ControlSc:
        case IntentKind::Home:
        case IntentKind::ArmLimitStop:
        case IntentKind::SetParameters:
            break;
    }
    return Refusal::NoMotor;
}

}  // namespace nmc
