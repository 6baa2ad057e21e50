// SPDX-License-Identifier: GPL-3.0-or-later
// faults.md H-02: while a connection only looks, no rule lets anything through but the question itself.
#include <gtest/gtest.h>

#include "intents.h"
#include "model/intent/homingplan.h"
#include "model/machinefile/machinegroups.h"
#include "model/procedure/procedures.h"
#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

HomingRecipe recipe(const ModuleState& module) {
    return firstRecipe(module.info.identity);
}

/// What one takes when it is in order, as this one is.
std::vector<Intent> forServo(const ModuleState& module) {
    return {intent::GoTo(kGoTo),
            intent::GoHome{CountsPerTick(1 << 16), CountsPerTickSquared(100)},
            intent::RunAtVelocity{CountsPerTick(1 << 16), CountsPerTickSquared(100)},
            intent::StopSmoothly{},
            intent::StopAbruptly{},
            intent::MotorOff{},
            intent::ApplyGains{*module.gains},
            intent::ClearStickyBits{},
            intent::ResetPosition{},
            intent::SaveAsHome{},
            intent::LoadMove{kGoTo},
            intent::StopHere{},
            intent::SetAmplifier{true},
            intent::ControlIo{},
            intent::Home{recipe(module)},
            intent::MoveBy{{100}, CountsPerTick(1 << 16), CountsPerTickSquared(100)},
            intent::StepResponse{100, ResponseMethod::Profile, 0.1},
            intent::ArmLimitStop{true}};
}

ModuleState servoWithPower() {
    ModuleState module = holdingServo();
    module.apply(sampleOf(1, kMoveDone | kPower, kServoOn));
    module.home.found(0, module.latestTime);
    module.apply(executedAt(1, servo::StopMotor{true, servo::StopManner::Here, Counts(0)}));
    return module;
}

TEST(H02_ReadOnly, AServoIsToldNothing) {
    ModuleState module = servoWithPower();
    for (const Intent& intent : forServo(module)) {
        module.readOnly = false;
        EXPECT_TRUE(plan(intent, module).has_value()) << "intent " << intent.index();
        module.readOnly = true;
        const auto planned = plan(intent, module);
        ASSERT_FALSE(planned) << "intent " << intent.index();
        EXPECT_EQ(planned.error(), Refusal::ReadOnly) << "intent " << intent.index();
        EXPECT_EQ(procedureFor(intent, module), nullptr) << "intent " << intent.index();
    }
}

TEST(H02_ReadOnly, EveryControlSaysSo) {
    ModuleState module = servoWithPower();
    module.readOnly = true;
    for (int kind = 0; kind <= static_cast<int>(IntentKind::SetOutputs); ++kind)
        EXPECT_EQ(whyNot(static_cast<IntentKind>(kind), module), Refusal::ReadOnly) << kind;
}

TEST(H02_ReadOnly, AQuestionIsAllowed) {
    ModuleState module = holdingServo();
    module.readOnly = true;
    const auto steps = plan(intent::AskAnew{}, module);
    ASSERT_TRUE(steps);
    EXPECT_TRUE(std::holds_alternative<Nop>(std::get<ServoCommand>(steps->front().command)));
}

TEST(H02_ReadOnly, TheChainAsAWholeIsToldNothing) {
    LinkState link;
    EXPECT_EQ(whyNotTold(link), Refusal::NotConnected);
    link.phase = LinkPhase::Connected;
    EXPECT_EQ(whyNotTold(link), std::nullopt);
    link.readOnly = true;
    EXPECT_EQ(whyNotTold(link), Refusal::ReadOnly);
}

TEST(H02_ReadOnly, NoModuleIsPutIntoTheGroupsOfAMachine) {
    Machine machine;
    machine.groups.push_back({0x81, "gantry", {ModuleIndex(0)}, {}});
    std::vector<ModuleState> modules{holdingServo()};
    EXPECT_EQ(groupChanges(machine, modules).size(), 1U);
    modules.front().readOnly = true;
    EXPECT_TRUE(groupChanges(machine, modules).empty());
}

}  // namespace
}  // namespace nmc
