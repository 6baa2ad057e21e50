// SPDX-License-Identifier: MIT
#include "model/intent/rights.h"

#include <utility>

namespace nmc {

bool allows(const OperatorRights& rights, IntentKind kind) {
    switch (kind) {
        case IntentKind::StopMotion:
        case IntentKind::MotorOff:
            return true;
        case IntentKind::Enable:
        case IntentKind::ClearStickyBits:
            return rights.enable;
        case IntentKind::Hold:
            return rights.jog;
        case IntentKind::Move:
        case IntentKind::Load:
        case IntentKind::GoHome:
        case IntentKind::Run:
        case IntentKind::StartLoaded:
            return rights.moves;
        case IntentKind::Home:
        case IntentKind::ResetPosition:
        case IntentKind::SaveAsHome:
            return rights.homing;
        case IntentKind::SetOutputs:
            return rights.outputs;
        case IntentKind::ApplyGains:
        case IntentKind::StopHere:  // it lets the motor turn to another position
        case IntentKind::DrivePwm:
        case IntentKind::CheckDirection:
        case IntentKind::SetAmplifier:
        case IntentKind::ControlIo:
        case IntentKind::ControlSc:
        case IntentKind::ArmLimitStop:
        case IntentKind::SetParameters:
        case IntentKind::ResetModule:
        case IntentKind::DeclarePosition:
            return false;
    }
    return false;
}

std::optional<Refusal> whyNotEdited(const std::optional<OperatorRights>& rights) {
    return rights ? std::optional(Refusal::OperatorMode) : std::nullopt;
}

std::optional<Refusal> whyNotEdited(const ModuleState& module) {
    return module.otherType() ? Refusal::OtherType : whyNotEdited(module.rights);
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
