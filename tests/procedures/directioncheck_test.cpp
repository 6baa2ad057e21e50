// SPDX-License-Identifier: GPL-3.0-or-later
// The direction check, DS-V 4.4 PWM mode: what the motor really does is read from the simulator.
#include "model/intent/directionplan.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Input = sim::Input;
using Verdict = DirectionVerdict;

/// A servo as it is after connecting: no gains, servo and amplifier off. Records how long and how strongly
/// the motor is driven.
class CheckBench : public ProcedureBench {
public:
    explicit CheckBench(std::uint32_t baud = 115'200, std::uint8_t version = servoVersion())
        : ProcedureBench(servos(1, version), {}, baud) {
        bus.onTime = [this, before = bus.onTime] {
            before();
            const auto now = truth();
            strongest = std::max(strongest, std::abs(now.pwm));
            farthest = std::max(farthest, std::abs(now.shaftCounts - start));
            if (now.pwm == 0)
                pushedSince.reset();
            else if (!pushedSince)
                pushedSince = bus.now;
            else
                longest = std::max(longest, bus.now - *pushedSince);
        };
    }
    [[nodiscard]] bool ready() {
        if (!connect())
            return false;
        settle();
        start = truth().shaftCounts;
        return true;
    }
    ProcedureReport check() { return run(intent::CheckDirection{directionReach({})}, 20.0); }
    void expectOff() {
        const auto now = truth();
        EXPECT_EQ(now.pwm, 0);
        EXPECT_FALSE(now.servoOn);
        EXPECT_FALSE(now.ampEnabled);
        EXPECT_EQ(module().amplifierEnabled, false);
        EXPECT_FALSE(module().moving());
        EXPECT_FALSE(module().switchedItselfOff);
    }

    int strongest = 0;
    double start = 0.0;
    double farthest = 0.0;
    Duration longest{};
    std::optional<TimePoint> pushedSince;
};

class DirectionCheckAt : public testing::TestWithParam<std::uint32_t> {};

TEST_P(DirectionCheckAt, FindsThatAllIsRight) {
    for (const int version : {1, int{servoVersion()}}) {
        CheckBench bench(GetParam(), static_cast<std::uint8_t>(version));
        ASSERT_TRUE(bench.ready());
        const ProcedureReport report = bench.check();
        EXPECT_EQ(report.stage, ProcedureStage::Done);
        ASSERT_TRUE(report.direction);
        EXPECT_EQ(report.direction->verdict, Verdict::Right);
        EXPECT_GE(report.direction->forward, kMovedCounts);
        EXPECT_LE(report.direction->reverse, -kMovedCounts);
        bench.expectOff();
        EXPECT_LE(bench.strongest, 64) << "a quarter of 255";
        // At 19 200 Bd: the answer to the start has 10 bytes, four queries have 5 each with answers of 7, and
        // a stop has 5. That is 63 bytes of 0.52 ms; with 6 times up to 0.51 ms it makes 36 ms, plus the time
        // of a byte between any two.
        EXPECT_LE(bench.longest, GetParam() == 19'200 ? 41ms : 10ms);
        EXPECT_LT(bench.farthest, directionReach({}));
        bench.bus.expectNoViolations();
    }
}

TEST_P(DirectionCheckAt, FindsThatOneIsReversed) {
    CheckBench bench(GetParam());
    ASSERT_TRUE(bench.ready());
    bench.fault(sim::FaultKind::Reverse);
    const ProcedureReport report = bench.check();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::Reversed);
    EXPECT_LE(report.direction->forward, -kMovedCounts);
    EXPECT_GE(report.direction->reverse, kMovedCounts);
    bench.expectOff();
    EXPECT_LT(bench.farthest, directionReach({}));
    bench.bus.expectNoViolations();
}

INSTANTIATE_TEST_SUITE_P(Rates, DirectionCheckAt, testing::Values(19'200U, 115'200U));

TEST(DirectionCheck, TurnsAHeavyLoadToo) {
    for (const double inertia : {0.5e-5, 6e-5, 4e-4})
        for (const double friction : {0.001, 0.02, 0.1}) {
            SCOPED_TRACE(inertia);
            SCOPED_TRACE(friction);
            CheckBench bench;
            ASSERT_TRUE(bench.ready());
            bench.set(Input::Inertia, inertia);
            bench.set(Input::Friction, friction);
            const ProcedureReport report = bench.check();
            ASSERT_TRUE(report.direction);
            EXPECT_EQ(report.direction->verdict, Verdict::Right);
            EXPECT_LT(bench.farthest, directionReach({}));
            bench.expectOff();
        }
}

TEST(DirectionCheck, OfAJammedMotorEndsAtTheStrongestPush) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.fault(sim::FaultKind::Stall);
    const ProcedureReport report = bench.check();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::NoMovement);
    EXPECT_EQ(report.direction->strongestPush, kStrongestPush);
    EXPECT_EQ(bench.strongest, kStrongestPush);
    bench.expectOff();
}

TEST(DirectionCheck, AgainstAStopOnOneSideIsUnclear) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.set(Input::TravelMax, bench.start);
    const ProcedureReport report = bench.check();
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::Unclear);
    EXPECT_EQ(report.direction->forward, 0);
    EXPECT_LT(report.direction->reverse, 0);
    bench.expectOff();
}

TEST(DirectionCheck, EndsAtALimitThatCloses) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.putSwitch(Input::Limit2, bench.start + 5, false);
    const ProcedureReport report = bench.check();
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::LimitClosed);
    EXPECT_TRUE(report.direction->limit2);
    EXPECT_FALSE(report.direction->limit1);
    bench.expectOff();
}

TEST(DirectionCheck, ALimitThatIsActiveAllAlongIsHowItIsWired) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.set(Input::Limit1, 1.0);
    bench.settle();
    const ProcedureReport report = bench.check();
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::Right);
    EXPECT_TRUE(report.direction->limit1);
}

TEST(DirectionCheck, TellsMotorPowerThatGoesAway) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.fault(sim::FaultKind::Stall);
    bench.begin(intent::CheckDirection{directionReach({})});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.set(Input::Power, 0.0);
    const ProcedureReport report = bench.goOn();
    ASSERT_TRUE(report.direction);
    EXPECT_EQ(report.direction->verdict, Verdict::NoPower);
    bench.expectOff();
}

TEST(DirectionCheck, AMotorThatIsTurnedFartherThanItsReachIsNotJudged) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.begin(intent::CheckDirection{kMovedCounts / 2});
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
    EXPECT_FALSE(report.direction);
    bench.expectOff();
}

TEST(DirectionCheck, CancelledAtAnyTurnLeavesTheMotorOff) {
    for (int turns = 1; turns < 60; turns += 3) {
        SCOPED_TRACE(turns);
        CheckBench bench;
        ASSERT_TRUE(bench.ready());
        bench.fault(sim::FaultKind::Stall);
        bench.begin(intent::CheckDirection{directionReach({})});
        for (int i = 0; i < turns; ++i)
            ASSERT_TRUE(bench.turn());
        bench.procedure->cancel();
        EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
        bench.expectOff();
    }
}

TEST(DirectionCheck, AStopOfAllEndsItAndLeavesTheMotorOff) {
    for (int turns = 1; turns < 40; turns += 3) {
        SCOPED_TRACE(turns);
        CheckBench bench(19'200);
        ASSERT_TRUE(bench.ready());
        bench.fault(sim::FaultKind::Stall);
        bench.begin(intent::CheckDirection{directionReach({})});
        for (int i = 0; i < turns; ++i)
            ASSERT_TRUE(bench.turn());
        bench.bus.engine.stopAll(bench.bus.now);
        bench.procedure->cancel();
        ASSERT_TRUE(bench.bus.runUntil([&] { return bench.bus.count<bus::StopFinished>() > 0; }, 5s));
        EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
        bench.expectOff();
    }
}

TEST(DirectionCheck, ALinkInDoubtEndsItAndLeavesTheMotorOff) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    bench.fault(sim::FaultKind::Stall);
    bench.begin(intent::CheckDirection{directionReach({})});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.procedure->onLinkSuspect();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::LinkSuspect);
    bench.expectOff();
}

/// Three answers in a row are lost: whatever was carried out, the check ends with the motor off.
TEST(DirectionCheck, AnswersThatAreLostLeaveTheMotorOff) {
    for (int first = 0; first < 8; ++first) {
        SCOPED_TRACE(first);
        CheckBench bench;
        ASSERT_TRUE(bench.ready());
        bench.fault(sim::FaultKind::Stall);
        bench.begin(intent::CheckDirection{directionReach({})});
        ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
        int lost = 0;
        int commands = 0;
        bench.bus.losesReply = [&](ByteSpan) { return commands++ >= first && lost++ < 3; };
        EXPECT_TRUE(bench.goOn().over());
        bench.settle();
        const auto truth = bench.truth();
        EXPECT_EQ(truth.pwm, 0);
        EXPECT_FALSE(truth.servoOn);
        EXPECT_LT(bench.longest, 1s);
        EXPECT_LE(bench.strongest, kStrongestPush);
    }
}

TEST(DirectionCheck, IsForAServoThatIsOffAndStands) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    const auto why = [&] { return whyNot(IntentKind::CheckDirection, bench.module()); };
    EXPECT_EQ(why(), std::nullopt);
    bench.module().readOnly = true;
    EXPECT_EQ(why(), Refusal::ReadOnly);
    bench.module().readOnly = false;
    ASSERT_TRUE(bench.perform(intent::DrivePwm{20, false}));
    EXPECT_EQ(why(), Refusal::Moving);
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    EXPECT_EQ(why(), Refusal::Moving) << "it is still coasting";
    bench.bus.runFor(3s);
    bench.take();
    EXPECT_EQ(why(), std::nullopt);
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    ASSERT_TRUE(bench.perform(intent::Enable{}));
    EXPECT_EQ(why(), Refusal::ServoOn);
    EXPECT_EQ(procedureFor(intent::CheckDirection{100}, bench.module()), nullptr);
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    bench.set(Input::Power, 0.0);
    bench.settle();
    EXPECT_EQ(why(), Refusal::NoPower);
}

TEST(DirectionCheck, EndsWhenSomebodyElseSwitchesTheServoOn) {
    CheckBench bench;
    ASSERT_TRUE(bench.ready());
    ASSERT_TRUE(bench.perform(intent::ApplyGains{{200, 2'000, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}}}));
    bench.fault(sim::FaultKind::Stall);
    bench.begin(intent::CheckDirection{directionReach({})});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bool enabled = false;
    for (int i = 0; i < 40 && !bench.procedure->report().over(); ++i) {
        std::ignore = bench.turn();
        if (i == 3)
            enabled = bench.perform(intent::Enable{});
    }
    EXPECT_TRUE(enabled);
    EXPECT_EQ(bench.procedure->report().stage, ProcedureStage::Cancelled);
}

TEST(DirectionCheck, ItsReachFollowsTheAxis) {
    EXPECT_EQ(directionReach({}), 250) << "an eighth of 2 000 counts";
    EXPECT_EQ(directionReach({UnitKind::Turns, 4'000.0, {}}), 500);
    EXPECT_EQ(directionReach({UnitKind::Degrees, 4'000.0 / 360.0, {}}), 500);
    EXPECT_EQ(directionReach({UnitKind::Turns, 64.0, {}}), 50);
    EXPECT_EQ(directionReach({UnitKind::Turns, 1e6, {}}), 1'000);
    EXPECT_EQ(directionReach({UnitKind::Millimetres, 400.0, {}}), 250);
}

}  // namespace
}  // namespace nmc::test
