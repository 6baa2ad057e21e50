// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/operator.h"

namespace nmc::test {

using namespace bus;
using namespace std::chrono_literals;

namespace {

constexpr std::uint32_t kAcceleration = 655;  // 0.01 counts per tick squared
constexpr std::uint8_t kStepRamp = 4;

[[nodiscard]] bool isStep(ModuleIdentity identity) {
    return identity.type == ModuleType::Stepper;
}

[[nodiscard]] Order toStep(std::uint8_t index, StepperCommand command) {
    return {ModuleIndex(index), std::move(command)};
}

/// 10 to 60 units: 250 to 1500 steps per second in 1x.
[[nodiscard]] std::uint8_t stepperSpeed(unsigned speed) {
    return static_cast<std::uint8_t>(10 + speed * 50 / 256);
}

}  // namespace

std::vector<Order> switchOn(std::uint8_t index, ModuleIdentity identity) {
    if (isStep(identity))
        return {
            toStep(index, stepper::SetParameters{stepper::SpeedMode::X1, false, false, false, 5, 200, 50, 0}),
            toStep(index, stepper::StopMotor{true, stepper::StopManner::AmplifierOnly})};
    servo::SetGain gain{200, 2000, 20, 200, 255, 0, 4000, 1, {}};
    if (identity.version >= servo::kDeadbandVersion)
        gain.db = std::uint8_t{0};
    return {toServo(index, gain), enable(index)};
}

std::vector<Order> switchOff(std::uint8_t index, ModuleIdentity identity) {
    if (isStep(identity))
        return {toStep(index, stepper::StopMotor{false, stepper::StopManner::Abruptly})};
    return {motorOff(index)};
}

Order loadFar(std::uint8_t index, ModuleIdentity identity, unsigned far) {
    if (isStep(identity)) {
        stepper::LoadTrajectory load;
        load.position = Counts(static_cast<std::int32_t>(far) * 1'000);
        load.speed = stepperSpeed(far);
        load.accelerationTime = kStepRamp;
        return toStep(index, load);
    }
    return loadMove(index, static_cast<std::int32_t>(far) * 1'000);
}

std::vector<Order> moveFar(std::uint8_t index, ModuleIdentity identity, unsigned far) {
    if (isStep(identity))
        return {loadFar(index, identity, far), toStep(index, StartMotion{})};
    return {loadFar(index, identity, far), start(index)};
}

std::vector<Order> runOn(std::uint8_t index, ModuleIdentity identity, unsigned speed) {
    if (isStep(identity)) {
        stepper::LoadTrajectory load;
        load.speed = stepperSpeed(speed);
        load.accelerationTime = kStepRamp;
        load.startNow = true;
        return {toStep(index, load)};
    }
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(kOnePerTick / 2 + speed * kOnePerTick / 64);
    load.acceleration = CountsPerTickSquared(kAcceleration);
    load.profile = servo::ProfileMode::Velocity;
    load.startNow = true;
    return {toServo(index, load)};
}

HoldToMove holdOn(std::uint8_t index, ModuleIdentity identity, unsigned speed) {
    HoldToMove hold{ModuleIndex(index), CountsPerTick(kOnePerTick / 2 + speed * kOnePerTick / 64),
                    CountsPerTickSquared(kAcceleration), false};
    if (isStep(identity))
        hold.pace = StepperPace{stepperSpeed(speed), kStepRamp};
    return hold;
}

bool connectAndWait(Rig& rig) {
    rig.known.reset();
    rig.connect();
    static_cast<void>(rig.runUntil([&] { return !rig.searching(); }, StopOath::kSearchBound));
    return rig.known.has_value();
}

bool setRunning(Rig& rig, std::size_t moving) {
    if (!connectAndWait(rig) || rig.known->modules.size() != rig.size())
        return false;
    for (std::uint8_t i = 0; i < rig.size(); ++i)
        rig.submit(switchOn(i, rig.world.chain[i]));
    for (std::uint8_t i = 0; i < moving && i < rig.size(); ++i)
        rig.submit(runOn(i, rig.world.chain[i], 32U + i * 16U));
    const auto done = [&] {
        return rig.bus.count<OperationFinished>() == rig.size() + std::min(moving, rig.size());
    };
    if (!rig.runUntil(done, 10s))
        return false;
    rig.run(150ms);
    for (std::uint8_t i = 0; i < moving && i < rig.size(); ++i)
        if (rig.atRest(i))
            return false;
    return true;
}

}  // namespace nmc::test
