// SPDX-License-Identifier: MIT
#include "model/procedure/homingchip.h"

#include <algorithm>
#include <cmath>

#include "module/profiledload.h"
#include "module/stepperspeed.h"

namespace nmc {

namespace {

using Stop = HomingRecipe::Stop;

/// 16.16 fixed point, rounded down so that it is never faster than requested.
[[nodiscard]] std::uint32_t fixed(double value) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(value * kFixedPointOne), 1.0, 2'147'483'647.0));
}

[[nodiscard]] servo::SetHoming servoHoming(const HomeConditions& c) {
    return {.onLimit1Change = c.limit1,
            .onLimit2Change = c.limit2,
            .onIndexChange = c.index,
            .onPositionError = c.positionError,
            .onCurrentLimit = c.currentLimit};
}

[[nodiscard]] stepper::SetHoming stepperHoming(const HomeConditions& c) {
    return {.onLimit1Change = c.limit1, .onLimit2Change = c.limit2, .onHomeSwitchChange = c.homeSwitch};
}

}  // namespace

HomingChip::HomingChip(const ModuleState& module)
    : m_module(module.info.index), m_identity(module.info.identity) {
    if (module.stepper.parameters)
        m_speedUnit = StepperSpeed(module.stepper.parameters->speedMode).unit();
    m_offOnLimit = module.stepper.parameters && module.stepper.parameters->motorOffOnLimitOrEstop &&
                   !module.stepper.parameters->ignoreLimits;
}

bool HomingChip::goesOff(const HomingRecipe& recipe) const {
    return recipe.stop == Stop::Off || (m_offOnLimit && (recipe.onLimit1 || recipe.onLimit2));
}

template <typename... Commands>
HomingChip::Orders HomingChip::orders(const Commands&... commands) const {
    return {bus::Order{m_module, forChip(m_identity.type, commands)}...};
}

std::optional<HomingLook> HomingChip::look(const ModuleState& module) const {
    if (!module.latest || !module.latest->position || !module.latest->aux)
        return std::nullopt;
    HomingLook seen;
    seen.time = module.latestTime;
    seen.position = *module.latest->position;
    if (m_identity.type == ModuleType::Stepper) {
        const stepper::StatusByte status = module.latest->stepperStatus();
        const stepper::InputsByte inputs{*module.latest->aux};
        seen.on = status.amplifierEnabled();
        seen.moving = status.moving();
        seen.waiting = status.homing();
        seen.active.limit1 = inputs.limit1();
        seen.active.limit2 = inputs.limit2();
        seen.active.homeSwitch = inputs.homeSwitch();
        return seen;
    }
    const servo::StatusByte status = module.latest->servoStatus();
    seen.on = module.servoOn();
    seen.moving = seen.on && !status.moveDone();
    seen.waiting = status.homeInProgress();
    seen.active.limit1 = status.limit1();
    seen.active.limit2 = status.limit2();
    seen.active.index = !servo::AuxByte{*module.latest->aux}.indexComplement();
    return seen;
}

HomingChip::Orders HomingChip::clearStickyBits() const {
    return orders(servo::ClearStickyBits{});
}

HomingChip::Orders HomingChip::run(const Motion& motion, std::optional<std::int32_t> goal) const {
    if (m_identity.type == ModuleType::Stepper)
        return orders(
            profiledLoad(speed(motion.velocity), accelerationTime(motion.acceleration), goal, motion.reverse),
            StartMotion{});
    return orders(profiledLoad(CountsPerTick(fixed(motion.velocity)),
                               CountsPerTickSquared(fixed(motion.acceleration)), goal, motion.reverse),
                  StartMotion{});
}

HomingChip::Orders HomingChip::watch(const HomeConditions& conditions, Stop stop) const {
    if (m_identity.type == ModuleType::Stepper)
        return orders(stoppingBy(stop, stepperHoming(conditions)));
    // An older servo does not stop by itself when home is found: the host must stop it.
    return m_identity.version >= servo::kAutoStopVersion ? orders(stoppingBy(stop, servoHoming(conditions)))
                                                         : orders(servoHoming(conditions));
}

HomingChip::Orders HomingChip::search(const HomeConditions& conditions, Stop stop,
                                      const Motion& motion) const {
    Orders all = watch(conditions, stop);
    const Orders motionSteps = run(motion);
    all.insert(all.end(), motionSteps.begin(), motionSteps.end());
    return all;
}

HomingChip::Orders HomingChip::stop(Stop manner) const {
    return {{m_module, stopMotor(m_identity.type, manner, true)}};
}

HomingChip::Orders HomingChip::disarm() const {
    return m_identity.type == ModuleType::Stepper ? orders(stepper::SetHoming{}) : orders(servo::SetHoming{});
}

HomingChip::Orders HomingChip::enable() const {
    if (m_identity.type == ModuleType::Stepper)
        return orders(stepper::StopMotor{true, stepper::StopManner::AmplifierOnly});
    // If the position error bit were still set, the next search would find it at once.
    return orders(servo::StopMotor{true, servo::StopManner::Abruptly, {}}, servo::ClearStickyBits{});
}

HomingChip::Orders HomingChip::zero() const {
    return orders(ResetPosition{});
}

HomingChip::Orders HomingChip::read(bool second) const {
    return orders(ReadStatus{StatusItems(second ? std::uint8_t{StatusItems::Position | StatusItems::Home}
                                                : std::uint8_t{StatusItems::All})});
}

std::uint8_t HomingChip::speed(double stepsPerSecond) const {
    return static_cast<std::uint8_t>(std::clamp(std::floor(stepsPerSecond / m_speedUnit), 1.0, 250.0));
}

/// The acceleration time in units of 0.25 ms per unit of speed (DS-S 4.2), rounded up so that it is never
/// steeper.
std::uint8_t HomingChip::accelerationTime(double stepsPerSecondSquared) const {
    const double quarters = m_speedUnit / (stepsPerSecondSquared * 0.25e-3);
    return static_cast<std::uint8_t>(std::clamp(std::ceil(quarters), 1.0, 255.0));
}

}  // namespace nmc
