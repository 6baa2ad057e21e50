// SPDX-License-Identifier: MIT
#include "model/procedure/procedures.h"

#include <algorithm>
#include <functional>

#include "model/intent/backlash.h"
#include "model/intent/homingplan.h"
#include "model/intent/stepperplan.h"
#include "model/procedure/approach.h"
#include "model/procedure/changemotion.h"
#include "model/procedure/directioncheck.h"
#include "model/procedure/frequencyrun.h"
#include "model/procedure/homingrun.h"
#include "model/procedure/moveby.h"
#include "model/procedure/pathrun.h"
#include "model/procedure/squarewave.h"
#include "model/procedure/stepresponse.h"
#include "model/procedure/stepseries.h"
#include "model/procedure/trygains.h"

namespace nmc {

namespace {

/// A move that has to turn round on its way; null where it goes straight.
template <typename Move>
std::unique_ptr<Procedure> approachFor(const Move& move, std::optional<std::int64_t> goal,
                                       const ModuleState& module) {
    if (!goal || !plan(move, module) || !module.latest->position || module.moving())
        return nullptr;
    const auto turn = turningPoint(*module.latest->position, *goal, module);
    return turn ? std::make_unique<Approach>(move, static_cast<std::int32_t>(*turn), module) : nullptr;
}
std::unique_ptr<Procedure> approachFor(const intent::GoTo& goTo, const ModuleState& module) {
    return approachFor(goTo, goTo.position.value(), module);
}
std::unique_ptr<Procedure> approachFor(const stepperintent::Move& move, const ModuleState& module) {
    return approachFor(move, goalOf(move.motion, module), module);
}

}  // namespace

std::unique_ptr<Procedure> procedureFor(const Intent& intent, const ModuleState& module) {
    if (const auto* home = std::get_if<intent::Home>(&intent))
        return whyNotHome(home->recipe, module)
                   ? nullptr
                   : std::make_unique<HomingRun>(home->recipe, home->tolerance, module);
    if (const auto* goTo = std::get_if<intent::GoTo>(&intent))
        return approachFor(*goTo, module);
    if (const auto* home = std::get_if<intent::GoHome>(&intent))
        return plan(intent, module)
                   ? approachFor({Counts(module.home.place()->counts), home->velocity, home->acceleration},
                                 module)
                   : nullptr;
    if (const auto* move = std::get_if<stepperintent::Move>(&intent))
        return approachFor(*move, module);
    if (const auto* home = std::get_if<stepperintent::GoHome>(&intent))
        return plan(intent, module) ? approachFor(stepperintent::Move{*motionOf(*home, module)}, module)
                                    : nullptr;
    if (const auto* moveBy = std::get_if<intent::MoveBy>(&intent))
        return plan(intent, module) ? std::make_unique<MoveByRun>(*moveBy, module) : nullptr;
    if (const auto* moveBy = std::get_if<stepperintent::MoveBy>(&intent))
        return plan(intent, module) ? std::make_unique<MoveByRun>(*moveBy, module) : nullptr;
    if (const auto* step = std::get_if<intent::StepResponse>(&intent))
        return plan(intent, module) ? std::make_unique<StepResponseRun>(*step, module) : nullptr;
    if (const auto* series = std::get_if<intent::StepSeries>(&intent))
        return plan(intent, module) ? std::make_unique<StepSeriesRun>(*series, module) : nullptr;
    if (const auto* wave = std::get_if<intent::SquareWave>(&intent))
        return plan(intent, module) ? std::make_unique<SquareWaveRun>(*wave, module) : nullptr;
    if (const auto* sines = std::get_if<intent::FrequencyResponse>(&intent))
        return plan(intent, module) ? std::make_unique<FrequencyRun>(*sines, module) : nullptr;
    if (const auto* wanted = std::get_if<intent::TryGains>(&intent))
        return plan(intent, module) ? std::make_unique<TryGainsRun>(*wanted, module) : nullptr;
    if (const auto* follow = std::get_if<intent::FollowPath>(&intent))
        return plan(intent, module) ? std::make_unique<PathRun>(*follow, module) : nullptr;
    if (const auto* check = std::get_if<intent::CheckDirection>(&intent))
        return plan(intent, module) ? std::make_unique<DirectionCheck>(*check, module) : nullptr;
    if (const auto* change = std::get_if<stepperintent::ChangeMotion>(&intent))
        return whyNotFromStandstill(change->motion, module)
                   ? nullptr
                   : std::make_unique<ChangeMotion>(module.info.index, change->motion);
    return nullptr;
}

void keepWhatIsHarmless(std::vector<bus::Order>& orders) {
    const auto harmless = [](const bus::Order& step) {
        const auto* servo = std::get_if<ServoCommand>(&step.command);
        const auto* stepper = std::get_if<StepperCommand>(&step.command);
        const auto* stop = servo != nullptr ? std::get_if<servo::StopMotor>(servo) : nullptr;
        return (stop != nullptr && stop->manner == servo::StopManner::MotorOff && !stop->amplifierEnable) ||
               (servo != nullptr && std::holds_alternative<servo::SetHoming>(*servo)) ||
               (servo != nullptr && std::holds_alternative<servo::SetGain>(*servo)) ||
               (stepper != nullptr && std::holds_alternative<stepper::SetHoming>(*stepper));
    };
    orders.erase(std::remove_if(orders.begin(), orders.end(), std::not_fn(harmless)), orders.end());
}

}  // namespace nmc
