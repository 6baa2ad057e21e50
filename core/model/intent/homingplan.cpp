// SPDX-License-Identifier: MIT
#include "model/intent/homingplan.h"

#include "model/intent/rights.h"
#include "model/intent/travel.h"
#include "model/module/stepperdefaults.h"

namespace nmc {

namespace {

[[nodiscard]] bool hasCondition(const HomingRecipe& r) {
    return r.onLimit1 || r.onLimit2 || r.onIndex || r.onPositionError || r.onCurrentLimit || r.onHomeSwitch;
}

[[nodiscard]] std::optional<Refusal> whyNotHomeServo(const ModuleState& module) {
    return firstUnmet({{module.latest->servoStatus().powerOn(), Refusal::NoPower},
                       {module.servoOn(), Refusal::ServoOff},
                       {module.speedsKnown(), Refusal::ServoRateUnknown},
                       {!module.moving(), Refusal::Moving}});
}

[[nodiscard]] std::optional<Refusal> whyNotHomeStep(const ModuleState& module) {
    const stepper::StatusByte status = module.latest->stepperStatus();
    return firstUnmet({{status.powerOn(), Refusal::NoPower},
                       {module.stepper.parameters.has_value(), Refusal::ParametersUnknown},
                       {status.amplifierEnabled(), Refusal::AmplifierOff},
                       {!status.moving(), Refusal::Moving}});
}

/// A PIC-STEP would go faster than that.
[[nodiscard]] bool isTooSlow(double velocity, const ModuleState& module) {
    return module.isStepper() && velocity < stepperdefaults::slowestProfile(module.stepper, {});
}

/// The condition that the chip could not watch for now, or that would stop the motor when it leaves a switch.
[[nodiscard]] std::optional<Refusal> whyNotWatched(const intent::ArmLimitStop& arm,
                                                   const ModuleState& module) {
    if (module.io &&
        ((arm.onLimit1 && !module.io->limit1IsInput) || (arm.onLimit2 && !module.io->limit2IsInput)))
        return Refusal::LimitIsOutput;
    const servo::StatusByte status = module.latest->servoStatus();
    if ((arm.onLimit1 && status.limit1()) || (arm.onLimit2 && status.limit2()))
        return Refusal::LimitActive;
    const bool unlimited = arm.onCurrentLimit && (!module.gains || module.gains->cl == 0);
    return unlimited ? std::optional(Refusal::NoCurrentLimit) : std::nullopt;
}

/// What the axis wants to be armed, without the conditions that cannot be: the others still protect it.
[[nodiscard]] intent::ArmLimitStop possibleStop(const ModuleState& module) {
    const auto can = [&module](const intent::ArmLimitStop& one) { return !whyNotWatched(one, module); };
    intent::ArmLimitStop stop = module.limitStop.stop;
    stop.onLimit1 = stop.onLimit1 && can({.onLimit1 = true});
    stop.onLimit2 = stop.onLimit2 && can({.onLimit2 = true});
    stop.onCurrentLimit = stop.onCurrentLimit && can({.onCurrentLimit = true});
    return stop;
}

}  // namespace

std::optional<Refusal> whyNotHome(const ModuleState& module) {
    if (const auto refusal = whyInaccessible(IntentKind::Home, module))
        return refusal;
    if (module.hasRestarted)
        return Refusal::Unresponsive;
    if (!module.latest->position || !module.latest->aux)
        return Refusal::PositionUnknown;
    switch (module.info.identity.type) {
        case ModuleType::Servo:
            return whyNotHomeServo(module);
        case ModuleType::Stepper:
            return whyNotHomeStep(module);
        case ModuleType::Adc:
        case ModuleType::Io:
            break;
    }
    return Refusal::NotAServo;
}

std::optional<Refusal> whyNotHome(const HomingRecipe& recipe, const ModuleState& module) {
    if (const auto refusal = whyNotHome(module))
        return refusal;
    const HomingRecipe r = effective(recipe, module.info.identity);
    const bool fast = r.velocity > 0.0 && (!r.thenIndex || r.indexVelocity > 0.0);
    if (const auto refusal =
            firstUnmet({{hasCondition(r), Refusal::NothingToFind},
                        {fast, Refusal::NoVelocity},
                        {!isTooSlow(r.velocity, module), Refusal::TooSlow},
                        {r.acceleration > 0.0, Refusal::NoAcceleration},
                        {r.travelLimit > 0.0 && r.timeLimit > 0.0, Refusal::NoSearchLimits}}))
        return refusal;
    if (const auto problem = travelProblem(intent::Home{r}, module))
        return problem->refusal;
    const bool output =
        module.io && ((r.onLimit1 && !module.io->limit1IsInput) || (r.onLimit2 && !module.io->limit2IsInput));
    return output ? std::optional(Refusal::LimitIsOutput) : std::nullopt;
}

std::optional<Refusal> whyNot(const intent::MeasureRepeatability& wanted, const ModuleState& module) {
    const HomingRecipe& r = wanted.recipe;
    const int inputs = int{r.onLimit1} + int{r.onLimit2} + int{r.onIndex} + int{r.onHomeSwitch};
    if (const auto refusal = whyNotHome(r, module))
        return refusal;
    return firstUnmet(
        {{inputs == 1 && !r.onPositionError && !r.onCurrentLimit && !r.thenIndex, Refusal::NoSingleInput},
         {wanted.times >= kFewestApproaches && wanted.times <= kMostApproaches, Refusal::TooFewOrMany}});
}

std::optional<Refusal> whyNotArm(const intent::ArmLimitStop& arm, const ModuleState& module) {
    if (const auto refusal = whyNot(IntentKind::ArmLimitStop, module))
        return refusal;
    return whyNotWatched(arm, module);
}

std::optional<intent::ArmLimitStop> limitStopDue(const ModuleState& module) {
    const intent::ArmLimitStop& wanted = module.limitStop.stop;
    if (!module.limitStop.eachMotion || !module.isServo() || !module.servoOn() || module.moving())
        return std::nullopt;
    const intent::ArmLimitStop arm = possibleStop(module);
    const HomeWatch& watch = module.homing;
    // What is armed stays armed, even if it could not be armed now: a switch that has just closed has tripped
    // the stop, which shows only in the following reply (bus/trust.h), and CL may have become unknown.
    const auto asWanted = [](bool watched, bool want, bool possible) { return watched ? want : !possible; };
    const bool armed = watch.state() == HomeWatch::State::Armed && watch.manner() == wanted.manner &&
                       asWanted(watch.onLimit1(), wanted.onLimit1, arm.onLimit1) &&
                       asWanted(watch.onLimit2(), wanted.onLimit2, arm.onLimit2) &&
                       asWanted(watch.onPositionError(), wanted.onPositionError, arm.onPositionError) &&
                       asWanted(watch.onCurrentLimit(), wanted.onCurrentLimit, arm.onCurrentLimit);
    return armed || !arm.any() || whyNotArm(arm, asOfPanel(module)) ? std::nullopt : std::optional(arm);
}

servo::SetHoming limitStop(const intent::ArmLimitStop& arm) {
    if (!arm.any())
        return {};
    return stoppingBy(arm.manner, servo::SetHoming{.onLimit1Change = arm.onLimit1,
                                                   .onLimit2Change = arm.onLimit2,
                                                   .onPositionError = arm.onPositionError,
                                                   .onCurrentLimit = arm.onCurrentLimit});
}

HomingRecipe firstRecipe(const ModuleIdentity& identity) {
    HomingRecipe recipe;
    recipe.timeLimit = 60.0;
    if (identity.type == ModuleType::Stepper) {
        recipe.onHomeSwitch = true;
        recipe.velocity = 400.0;  // steps/s: two turns of a common motor in full steps
        recipe.acceleration = 2'000.0;
        recipe.travelLimit = 20'000.0;
    } else {
        // It searches in reverse, and the reverse limit of an SC is LIMIT2 (docs/family.md).
        (isSc(identity) ? recipe.onLimit2 : recipe.onLimit1) = true;
        recipe.velocity = 0.5;  // counts/tick: about 980 counts/s at the fastest servo rate
        recipe.indexVelocity = 0.1;
        recipe.acceleration = 0.002;
        recipe.travelLimit = 50'000.0;
    }
    return recipe;
}

HomingRecipe effective(HomingRecipe recipe, const ModuleIdentity& identity) {
    if (identity.type == ModuleType::Stepper) {
        recipe.onIndex = recipe.onPositionError = recipe.onCurrentLimit = recipe.thenIndex = false;
    } else {
        recipe.onHomeSwitch = false;
        if (recipe.onPositionError)
            recipe.stop = HomingRecipe::Stop::Off;
        // A search for the index alone has no vicinity to find first.
        if (recipe.onIndex)
            recipe.thenIndex = false;
    }
    recipe.makeZero = recipe.makeZero && recipe.goToHome;
    return recipe;
}

}  // namespace nmc
