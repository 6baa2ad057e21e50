// SPDX-License-Identifier: MIT
#include "model/intent/planner.h"

namespace nmc {

namespace {

constexpr StatusItems kLatched{StatusItems::LatchedPins | StatusItems::LatchedCounter};

struct IoPlanner : Planner {
    Plan operator()(const iointent::SetDirection& set) const {
        const io::SetDirection direction{set.inputs};
        // It is not documented whether an input retains the level that it was sent as an output, so new
        // outputs are sent their level both before and after the change of direction.
        if (const auto known = levels())
            return as(IntentKind::ControlIo, io::SetOutput{*known}, direction, io::SetOutput{*known});
        return as(IntentKind::ControlIo, direction);
    }
    Plan operator()(const iointent::SetOutput& set) const {
        const auto known = levels();
        if (!known)
            return tl::unexpected(Refusal::Unresponsive);
        const unsigned bit = 1U << set.pin;
        const unsigned outputs = set.high ? *known | bit : *known & ~bit;
        return as(IntentKind::SetOutputs, io::SetOutput{static_cast<std::uint16_t>(outputs)});
    }
    Plan operator()(const iointent::SetPwm& set) const {
        const std::uint8_t other = set.other.value_or(0);
        auto values = module.pins.pwm.value_or(std::array<std::uint8_t, 2>{other, other});
        values.at(set.output) = set.value;
        return as(IntentKind::SetOutputs, io::SetPwm{values[0], values[1]});
    }
    Plan operator()(const iointent::SetTimer& set) const { return as(IntentKind::ControlIo, set.mode); }
    Plan operator()(const iointent::StoreOutputs& store) const {
        return as(IntentKind::SetOutputs, store.outputs);
    }
    Plan operator()(const iointent::SynchOutput&) const {
        return as(IntentKind::SetOutputs, io::SynchOutput{});
    }
    Plan operator()(const iointent::SynchInput&) const {
        return as(IntentKind::ControlIo, io::SynchInput{}, ReadStatus{kLatched});
    }
    Plan operator()(const auto& /*of a motor*/) const { return tl::unexpected(Refusal::NoMotor); }

private:
    [[nodiscard]] std::optional<std::uint16_t> levels() const {
        return module.latest ? module.pins.levels(*module.latest) : std::nullopt;
    }
};

}  // namespace

Plan planIo(const Intent& intent, const ModuleState& module) {
    return std::visit(IoPlanner{{module}}, intent);
}

std::optional<Refusal> whyNotIo(IntentKind kind, const ModuleState& module) {
    using enum IntentKind;
    // StartLoaded: with its group, by Synch Output.
    if (kind != SetOutputs && kind != ControlIo && kind != ResetModule && kind != StartLoaded)
        return Refusal::NoMotor;
    if (const auto refusal = whyInaccessible(kind, module))
        return refusal;
    return kind == StartLoaded && !module.pins.stored ? std::optional(Refusal::NothingLoaded) : std::nullopt;
}

}  // namespace nmc
