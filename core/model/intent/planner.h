// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/homingplan.h"
#include "model/intent/intent.h"

/// What the visitors behind plan() share. For .cpp files of this folder only.
namespace nmc {

struct Planner {
    const ModuleState& module;

    /// The commands, unless something prevents the request.
    template <typename... Commands>
    [[nodiscard]] Plan unless(std::optional<Refusal> refusal, const Commands&... commands) const {
        if (refusal)
            return tl::unexpected(*refusal);
        return Orders{{module.info.index, forChip(module.info.identity.type, commands)}...};
    }
    /// The commands, if the precondition of the control is met: a command whose control is greyed out is not
    /// sent from anywhere else either.
    template <typename... Commands>
    [[nodiscard]] Plan as(IntentKind kind, const Commands&... commands) const {
        return unless(whyNot(kind, module), commands...);
    }
};

/// The requests that are the same for both motor chips. Lists of requests in derived planners are taken by
/// value: clang 14 compares only the parameters of templates, not what they require, and would hide the ones
/// here.
struct MotorPlanner : Planner {
    Plan operator()(const intent::StopAbruptly&) const { return stop(StopManner::Abruptly); }
    Plan operator()(const intent::MotorOff&) const {
        return as(IntentKind::MotorOff, stopMotor(module.info.identity.type, StopManner::Off, false));
    }
    Plan operator()(const intent::ResetPosition&) const {
        return as(IntentKind::ResetPosition, nmc::ResetPosition{});
    }
    Plan operator()(const intent::SaveAsHome&) const { return as(IntentKind::SaveAsHome, nmc::SaveAsHome{}); }
    /// Sends nothing; the owner of the module's state handles it.
    Plan operator()(const intent::DeclarePosition&) const { return as(IntentKind::DeclarePosition); }
    Plan operator()(const intent::StartLoaded&) const { return as(IntentKind::StartLoaded, StartMotion{}); }
    // Procedures are planned elsewhere (model/procedure/procedures.h); this only determines why one is not
    // possible.
    Plan operator()(const intent::Home& home) const { return unless(whyNotHome(home.recipe, module)); }
    Plan operator()(const intent::MeasureRepeatability& wanted) const {
        return unless(whyNot(wanted, module));
    }
    // Planned for all chips in plan().
    Plan operator()(const In<AnyModuleIntent> auto&) const { return Orders{}; }
    Plan operator()(const intent::GoHome&) const { return Orders{}; }
    Plan operator()(const In<IoIntent> auto&) const { return tl::unexpected(Refusal::NotAnIoModule); }

    /// The amplifier is left as it is.
    [[nodiscard]] Plan stop(StopManner manner) const {
        return as(IntentKind::StopMotion,
                  stopMotor(module.info.identity.type, manner, module.amplifierKept()));
    }
};

/// Why a goal, if there is one, is too far away: by the 32 bits of the chip, it is on the other side
/// (DS-V 5.2 and DS-S 5.1, footnote of Load Trajectory). Pure.
[[nodiscard]] std::optional<Refusal> whyNotThatFar(std::optional<std::int64_t> goal,
                                                   const ModuleState& module);

/// plan() and whyNot() for a PIC-I/O. Pure.
[[nodiscard]] Plan planIo(const Intent& intent, const ModuleState& module);
[[nodiscard]] std::optional<Refusal> whyNotIo(IntentKind kind, const ModuleState& module);

}  // namespace nmc
