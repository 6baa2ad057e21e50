// SPDX-License-Identifier: MIT
#include "model/procedure/procedures.h"

#include <algorithm>

#include "model/intent/backlash.h"
#include "model/intent/stepperplan.h"
#include "model/procedure/approach.h"
#include "model/procedure/changemotion.h"
#include "model/procedure/directioncheck.h"
#include "model/procedure/frequencyrun.h"
#include "model/procedure/homingrun.h"
#include "model/procedure/moveby.h"
#include "model/procedure/pathrun.h"
#include "model/procedure/repeatabilityrun.h"
#include "model/procedure/squarewave.h"
#include "model/procedure/stepsrun.h"
#include "model/procedure/trygains.h"
#include "module/stopmanner.h"

namespace nmc {

namespace {

using Made = std::unique_ptr<Procedure>;

/// Returns the procedure for a move that must turn round on the way; null if it goes straight.
Made approachFor(const MotionSpec& motion, const ModuleState& module) {
    const auto goal = module.latest->position ? goalOf(motion, *module.latest->position) : std::nullopt;
    const auto turn = goal ? turningPoint(*goal, module) : std::nullopt;
    return turn ? std::make_unique<Approach>(motion, *turn, module) : nullptr;
}

/// The procedure of an intent whose preconditions are met; null for one that is an operation.
struct ProcedureOf {
    const ModuleState& module;

    template <typename Run>
    [[nodiscard]] Made make(const auto&... wanted) const {
        return std::make_unique<Run>(wanted..., module);
    }
    Made operator()(const intent::Home& home) const { return make<HomingRun>(home.recipe, home.tolerance); }
    Made operator()(const intent::MeasureRepeatability& wanted) const {
        return make<RepeatabilityRun>(wanted);
    }
    Made operator()(const intent::Move& move) const { return approachFor(move.motion, module); }
    Made operator()(const intent::LoadMove&) const { return nullptr; }  // goes straight to its goal
    Made operator()(const intent::GoHome& home) const { return approachFor(*motionOf(home, module), module); }
    Made operator()(const intent::MoveBy& moveBy) const { return make<MoveByRun>(moveBy); }
    Made operator()(const intent::StepResponse& step) const { return make<StepsRun>(step); }
    Made operator()(const intent::StepSeries& series) const { return make<StepsRun>(series); }
    Made operator()(const intent::SquareWave& wave) const { return make<SquareWaveRun>(wave); }
    Made operator()(const intent::FrequencyResponse& sines) const { return make<FrequencyRun>(sines); }
    Made operator()(const intent::TryGains& wanted) const { return make<TryGainsRun>(wanted); }
    Made operator()(const intent::CheckDirection& check) const { return make<DirectionCheck>(check); }
    Made operator()(const intent::FollowPath& follow) const { return make<PathRun>(follow); }
    template <typename T>
    requires(!In<T, ServoProcedure> && !In<T, MoveIntent>) Made operator()(const T&) const { return nullptr; }
};

}  // namespace

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    // As an operation it is refused: from this motion it takes more than one.
    if (const auto* change = std::get_if<intent::ChangeMotion>(&intent))
        return whyNotFromStandstill(change->motion, module)
                   ? nullptr
                   : std::make_unique<ChangeMotion>(module.info.index, change->motion);
    return plan(intent, module) ? std::visit(ProcedureOf{module}, intent) : nullptr;
}

void keepWhatIsHarmless(std::vector<bus::Order>& orders) {
    const auto harmless = [](const bus::Order& step) {
        const auto* stop = getIf<servo::StopMotor>(step.command);
        return (stop != nullptr && stop->manner == servo::StopManner::MotorOff && !stop->amplifierEnable) ||
               is<servo::SetHoming>(step.command) || is<servo::SetGain>(step.command) ||
               is<stepper::SetHoming>(step.command);
    };
    std::erase_if(orders, std::not_fn(harmless));
}

std::vector<bus::Order> takeStops(std::vector<bus::Order>& orders) {
    const auto stops = [](const bus::Order& order) { return stopManner(order.command).has_value(); };
    const auto rest = std::ranges::find_if_not(orders, stops);
    if (rest == orders.end())
        return {};
    std::vector<bus::Order> taken(orders.begin(), rest);
    orders.erase(orders.begin(), rest);
    return taken;
}

}  // namespace nmc
