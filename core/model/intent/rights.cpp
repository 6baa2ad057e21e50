// SPDX-License-Identifier: MIT
#include "model/intent/rights.h"

#include <utility>

namespace nmc {

bool allows(const OperatorRights& rights, Request request) {
    switch (request) {
        case Request::StopMotion:
        case Request::MotorOff:
            return true;
        case Request::Enable:
        case Request::ClearStickyBits:
            return rights.enable;
        case Request::Hold:
            return rights.jog;
        case Request::Move:
        case Request::Load:
        case Request::GoHome:
        case Request::Run:
        case Request::StartLoaded:
            return rights.moves;
        case Request::Home:
        case Request::ResetPosition:
        case Request::SaveAsHome:
            return rights.homing;
        case Request::SetOutputs:
            return rights.outputs;
        case Request::ApplyGains:
        case Request::StopHere:  // it lets the motor turn to another place
        case Request::DrivePwm:
        case Request::CheckDirection:
        case Request::SetAmplifier:
        case Request::ControlIo:
        case Request::ControlSc:
        case Request::ArmLimitStop:
        case Request::SetParameters:
        case Request::ResetModule:
        case Request::DeclarePosition:
            return false;
    }
    return false;
}

std::optional<Refusal> whyNotEdited(const std::optional<OperatorRights>& rights) {
    return rights ? std::optional(Refusal::OperatorMode) : std::nullopt;
}

ModuleState asOfSequence(ModuleState module) {
    constexpr OperatorRights kNothing{false, false, false, false, false, false};
    if (module.rights && module.rights->points)
        module.rights.reset();
    else if (module.rights)
        module.rights = kNothing;
    return module;
}

std::vector<ModuleState> asOfSequence(std::vector<ModuleState> modules) {
    for (ModuleState& module : modules)
        module = asOfSequence(std::move(module));
    return modules;
}

ModuleState asOfPanel(ModuleState module) {
    module.rights.reset();
    return module;
}

}  // namespace nmc
