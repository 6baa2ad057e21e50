// SPDX-License-Identifier: GPL-3.0-or-later
// Stopping, waiting and starting again, with the real bus engine and the simulated chip in virtual time; the
// results are compared with the simulator's own state.
#include "model/procedure/changemotion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/intent/stepperplan.h"
#include "model/procedure/procedures.h"
#include "module/stepperspeed.h"
#include "tests/support/virtualbus.h"

namespace nmc {
namespace {

using namespace std::chrono_literals;
using test::VirtualBus;

class ChangingMotion : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(bus.connect());
        module.info = bus.last<bus::ChainFound>()->modules[0];
        stepper::SetParameters parameters;
        parameters.speedMode = stepper::SpeedMode::X1;
        parameters.minimumProfileSpeed = 4;
        parameters.runCurrent = 100;
        parameters.holdCurrent = 50;
        perform(stepperintent::SetParameters{parameters});
        perform(intent::Enable{});
        bus.runFor(50ms);
        takeNews();
    }

    void takeNews() {
        for (; m_taken < bus.events.size(); ++m_taken) {
            const bus::Event& event = bus.events[m_taken];
            if (const auto* sample = std::get_if<bus::Sample>(&event))
                module.apply(*sample);
            else if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
                module.apply(*executed);
            else if (const auto* silence = std::get_if<bus::ModuleUnresponsive>(&event))
                module.silent = silence->silent;
        }
    }
    void perform(const Intent& intent) {
        takeNews();
        auto steps = plan(intent, module);
        ASSERT_TRUE(steps) << static_cast<int>(steps.error());
        ASSERT_EQ(bus.perform(std::move(*steps)), bus::Outcome::Done);
        bus.runFor(50ms);
        takeNews();
    }
    /// Runs the procedure until it has ended, as the procedure controller does.
    ProcedureReport run(Procedure& procedure, Duration limit = 30s) {
        for (const TimePoint end = bus.now + limit; bus.now < end; bus.runFor(10ms)) {
            takeNews();
            if (m_operation)
                if (const auto outcome = bus.outcomeOf(*m_operation)) {
                    m_operation.reset();
                    procedure.onFinished(*outcome);
                }
            if (m_operation)
                continue;
            Procedure::Next next = procedure.next(module, bus.now);
            if (auto* send = std::get_if<Procedure::Send>(&next))
                m_operation = bus.submit(std::move(send->orders));
            else if (std::holds_alternative<Procedure::End>(next))
                break;
            if (onTurn)
                onTurn(procedure);
        }
        return procedure.report();
    }
    sim::StepperSnapshot truth() { return bus.chain.snapshot(ModuleIndex(0), bus.now).stepper.value(); }

    VirtualBus bus{std::vector<ModuleIdentity>{{ModuleType::Stepper, 1}}};
    ModuleState module;
    std::function<void(Procedure&)> onTurn;

private:
    std::size_t m_taken = 0;
    std::optional<bus::OperationId> m_operation;
};

const StepperMotion kRunForward = steppermotion::VelocityProfile{40, 40, false};
const StepperMotion kRunReverse = steppermotion::VelocityProfile{40, 40, true};

TEST_F(ChangingMotion, ReversesByStoppingFirst) {
    perform(intent::Move{kRunForward});
    bus.runFor(1s);
    takeNews();
    EXPECT_NEAR(truth().stepRate, 1'000, 1e-6) << "40 x 25 steps/s";
    ASSERT_EQ(whyNot(kRunReverse, module), Refusal::NeedsStop);
    const auto procedure = procedureFor(intent::ChangeMotion{kRunReverse}, module);
    ASSERT_NE(procedure, nullptr);
    EXPECT_EQ(run(*procedure).stage, ProcedureStage::Done);
    bus.runFor(1s);
    EXPECT_NEAR(truth().stepRate, -1'000, 1e-6);
    bus.expectNoViolations();
}

TEST_F(ChangingMotion, GoesToAPositionOutOfARun) {
    perform(intent::Move{kRunForward});
    bus.runFor(1s);
    ChangeMotion change(ModuleIndex(0), steppermotion::Trapezoid{-200, false, 40, 10});
    EXPECT_EQ(run(change).stage, ProcedureStage::Done);
    bus.runFor(10s);
    EXPECT_EQ(truth().position, -200);
    EXPECT_FALSE(truth().moving);
    bus.expectNoViolations();
}

/// Required from below: it turns round 40 steps below its goal (homing.md, Backlash).
TEST_F(ChangingMotion, TakesUpTheBacklashOutOfARun) {
    module.backlash = {40, false};
    std::int32_t lowest = 0;
    bus.onTime = [&] { lowest = std::min(lowest, truth().position); };
    perform(intent::Move{kRunForward});
    bus.runFor(1s);
    ChangeMotion change(ModuleIndex(0), steppermotion::Trapezoid{-200, false, 40, 10});
    EXPECT_EQ(run(change).stage, ProcedureStage::Done);
    bus.runFor(5s);
    EXPECT_EQ(lowest, -240);
    EXPECT_EQ(truth().position, -200);
    EXPECT_FALSE(truth().moving);
    bus.expectNoViolations();
    bus.onTime = {};
}

/// It turns back at 1 000 steps or more, and is on its way to -1 040 when the limit is set.
TEST_F(ChangingMotion, EndsOnTheWayToWhereItTurnsIfALimitIsSetNearer) {
    module.backlash = {40, false};
    perform(intent::Move{kRunForward});
    bus.runFor(1s);
    takeNews();
    module.home.declare(module.latestTime);
    onTurn = [&](Procedure& procedure) {
        if (procedure.report().stage == ProcedureStage::TakingUpBacklash)
            module.travel.lowest = -100;
    };
    ChangeMotion change(ModuleIndex(0), steppermotion::Trapezoid{-1'000, false, 40, 10});
    EXPECT_EQ(run(change).failure, ProcedureFailure::SoftLimit);
    bus.runFor(3s);
    EXPECT_FALSE(truth().moving);
    EXPECT_GT(truth().position, -100);
    EXPECT_TRUE(truth().ampEnabled);
    bus.expectNoViolations();
}

TEST_F(ChangingMotion, CountsARelativeGoalFromWhereItHasStopped) {
    perform(intent::Move{kRunForward});
    bus.runFor(1s);
    std::optional<std::int32_t> stood;
    onTurn = [&](Procedure&) {
        if (!truth().moving && !stood)
            stood = truth().position;
    };
    ChangeMotion change(ModuleIndex(0), steppermotion::Trapezoid{-100, true, 40, 10});
    EXPECT_EQ(run(change).stage, ProcedureStage::Done);
    bus.runFor(5s);
    ASSERT_TRUE(stood);
    EXPECT_EQ(truth().position, *stood - 100);
}

TEST_F(ChangingMotion, StartsNothingOnceItIsCancelled) {
    perform(intent::Move{kRunForward});
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    onTurn = [&](Procedure& procedure) {
        if (procedure.report().stage == ProcedureStage::Stopping)
            procedure.cancel();
    };
    EXPECT_EQ(run(change).stage, ProcedureStage::Cancelled);
    bus.runFor(3s);
    EXPECT_FALSE(truth().moving) << "the smooth stop had already been sent";
    EXPECT_TRUE(truth().ampEnabled);
}

TEST_F(ChangingMotion, StopsWhatItHasStartedWhenItIsCancelledJustThen) {
    perform(intent::Move{kRunForward});
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    onTurn = [&](Procedure& procedure) {
        if (procedure.report().stage == ProcedureStage::Moving)
            procedure.cancel();
    };
    EXPECT_EQ(run(change).stage, ProcedureStage::Cancelled);
    bus.runFor(3s);
    EXPECT_FALSE(truth().moving);
    bus.expectNoViolations();
}

TEST_F(ChangingMotion, FailsWhenTheLinkIsSuspectAndStartsNothing) {
    perform(intent::Move{kRunForward});
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    onTurn = [](Procedure& procedure) { procedure.onLinkSuspect(); };
    const ProcedureReport report = run(change);
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::LinkSuspect);
    bus.runFor(3s);
    EXPECT_FALSE(truth().moving);
}

TEST_F(ChangingMotion, FailsWhereTheNewMotionIsNotPossibleAndLeavesTheOldOneAlone) {
    perform(intent::Move{kRunForward});
    bus.runFor(500ms);
    bus.chain.set(ModuleIndex(0), sim::Input::Limit2, 1.0, bus.now);
    bus.runFor(100ms);
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    const ProcedureReport report = run(change);
    EXPECT_EQ(report.failure, ProcedureFailure::Refused);
    EXPECT_NEAR(truth().stepRate, 1'000, 1e-6);
}

TEST_F(ChangingMotion, FailsWhenTheMotorGoesOffMeanwhile) {
    perform(intent::Move{kRunForward});
    bus.runFor(500ms);
    takeNews();
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    onTurn = [&](Procedure&) { bus.chain.set(ModuleIndex(0), sim::Input::Power, 0.0, bus.now); };
    EXPECT_EQ(run(change).failure, ProcedureFailure::WentOff);
    EXPECT_FALSE(truth().moving);
}

TEST_F(ChangingMotion, GivesUpOnAModuleThatDoesNotAnswer) {
    perform(intent::Move{kRunForward});
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    module.silent = true;
    EXPECT_EQ(run(change).failure, ProcedureFailure::ModuleUnresponsive);
}

TEST_F(ChangingMotion, GivesUpOnAMotorThatDoesNotStop) {
    perform(intent::Move{kRunForward});
    takeNews();
    ChangeMotion change(ModuleIndex(0), kRunReverse);
    ASSERT_TRUE(std::holds_alternative<Procedure::Send>(change.next(module, bus.now)));
    change.onFinished(bus::Outcome::Done);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(change.next(module, bus.now + 19s)));
    EXPECT_TRUE(std::holds_alternative<Procedure::End>(change.next(module, bus.now + 21s)));
    EXPECT_EQ(change.report().failure, ProcedureFailure::TimeLimit);
}

// The chip behaves as the panel forecasts.
TEST_F(ChangingMotion, AForecastIsKeptByTheChip) {
    for (const std::int32_t distance : {3'000, -300, 7}) {
        const auto steps = plan(intent::Move{steppermotion::Trapezoid{distance, true, 60, 20}}, module);
        ASSERT_TRUE(steps);
        (void)bus.submit(*steps);
        ASSERT_TRUE(bus.runUntil([&] { return truth().moving; }, 1s));
        const TimePoint began = bus.now;
        double peak = 0;
        ASSERT_TRUE(bus.runUntil(
            [&] {
                peak = std::max(peak, std::abs(truth().stepRate));
                return !truth().moving;
            },
            20s));
        const StepperForecast forecast =
            forecastMove(StepperSpeed(stepper::SpeedMode::X1), 4, 60, 20, distance);
        // The end is noticed only when a byte arrives, and the last step comes within the time of one step.
        EXPECT_NEAR(toSeconds(bus.now - began), forecast.seconds, 0.015) << distance;
        EXPECT_NEAR(peak, forecast.peak, 25.0) << distance;
        EXPECT_EQ(forecast.triangular, distance != 3'000);
        bus.runFor(50ms);
        takeNews();
    }
}

}  // namespace
}  // namespace nmc
