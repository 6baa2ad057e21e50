// SPDX-License-Identifier: GPL-3.0-or-later
// Gains that are tried, and the safety net under them. Engine and simulator in virtual time, checked against
// the shaft of the simulator.
#include "model/procedure/trygains.h"

#include <random>

#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

constexpr double kPush = 0.05;  ///< N·m: half of what stalls the motor
constexpr servo::SetGain kGood{200, 2'000, 20, 200, 255, 0, 16'000, 1, std::uint8_t{0}};
constexpr servo::SetGain kOther{250, 2'000, 20, 200, 255, 0, 16'000, 1, std::uint8_t{0}};
constexpr servo::SetGain kApplied{300, 2'000, 20, 200, 255, 0, 16'000, 1, std::uint8_t{0}};

class TriedGains : public testing::Test {
protected:
    [[nodiscard]] bool hold() {
        return bench.connect() && bench.perform(intent::ApplyGains{kGood}) && bench.perform(intent::Enable{});
    }
    /// Begins a trial, and runs until the gains are in force.
    void tryOther(double seconds) {
        ASSERT_TRUE(hold());
        bench.begin(intent::TryGains{kOther, seconds});
        ASSERT_TRUE(bench.runTo(ProcedureStage::Trying));
    }
    /// Keeps the gains as the panel does.
    void keep() {
        bench.procedure->keep();
        bench.bus.engine.keepTrial(ModuleIndex(0), bench.bus.now);
    }
    /// Watches the shaft from now on.
    void watch() {
        stood = bench.truth().position;
        farthest = 0;
        halfCycles = side = 0;
        third.reset();
        back.reset();
        bench.bus.onTime = [this] {
            const int off = bench.truth().position - stood;
            farthest = std::max(farthest, std::abs(off));
            const int here = off > 8 ? 1 : off < -8 ? -1 : side;
            halfCycles += here != side ? 1 : 0;
            side = here;
            if (halfCycles == 3 && !third)
                third = bench.bus.now;
            const bool good = bench.truth().gains.kp == kGood.kp;
            if (good && !before && !back)
                back = bench.bus.now;
            before = good;
        };
    }
    /// Pushes the shaft from outside, for so short a time that a stable servo hardly moves.
    void push(Duration lasts = 4ms) {
        bench.set(sim::Input::Load, kPush);
        bench.bus.runFor(lasts);
        bench.set(sim::Input::Load, 0.0);
    }
    /// True if the chip has these gains; its output limit may be lower during a trial.
    [[nodiscard]] bool hasGains(const servo::SetGain& gains) {
        const auto now = bench.truth().gains;
        return now.kp == gains.kp && now.kd == gains.kd && now.ki == gains.ki &&
               (now.ol == gains.ol || bench.procedure->report().stage == ProcedureStage::Trying);
    }
    /// From now on no command arrives for this long.
    void deafen(Duration lasts) {
        sim::FaultSpec deaf;
        deaf.kind = sim::FaultKind::MuteTx;
        deaf.lasts = lasts;
        ASSERT_TRUE(bench.bus.chain.inject(deaf, bench.bus.now));
    }
    ServoBench bench;
    int stood = 0, farthest = 0, halfCycles = 0, side = 0;
    bool before = true;                    ///< kGood was in force
    std::optional<TimePoint> third, back;  ///< third half cycle; when kGood was in force again
};

TEST_F(TriedGains, AreTakenBackWhenTheTimeIsOver) {
    ASSERT_TRUE(hold());
    const TimePoint began = bench.bus.now;
    const ProcedureReport report = bench.run(intent::TryGains{kOther, 10.0});
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_FALSE(report.kept);
    EXPECT_TRUE(bench.stages.count(ProcedureStage::Trying));
    EXPECT_TRUE(hasGains(kGood));
    // Plus half a second to calm down after Enable, and 0.3 s of the bench.
    EXPECT_NEAR(toSeconds(bench.bus.now - began), 10.8, 0.2);
    bench.bus.expectNoViolations();
}

TEST_F(TriedGains, StayWhenTheyAreKept) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    bench.bus.engine.keepTrial(ModuleIndex(0), bench.bus.now);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(report.kept);
    EXPECT_TRUE(hasGains(kOther));
}

/// Gains on trial have a lower output limit, so they are not what the user had before.
TEST_F(TriedGains, AreNotTheGainsBefore) {
    ASSERT_TRUE(hold());
    const auto good = bench.module().gains;
    ASSERT_EQ(bench.run(intent::TryGains{kOther, 0.2}).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.module().gains, good);
    EXPECT_FALSE(bench.module().gainsBefore) << "as before the trial";
    bench.begin(intent::TryGains{kOther, 10.0});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Trying));
    ASSERT_TRUE(bench.turn());
    keep();
    ASSERT_EQ(bench.goOn().stage, ProcedureStage::Done);
    ASSERT_TRUE(hasGains(kOther));
    EXPECT_EQ(bench.module().gainsBefore, good);
}

/// The other request arrives before the panel knows that they are kept.
TEST_F(TriedGains, StayWhenTheyAreKeptAndSomethingElseIsAskedForAtOnce) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    EXPECT_TRUE(hasGains(kOther));
}

TEST_F(TriedGains, StayWhenSomethingElseIsAskedForWhileAllOfOlIsSent) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    ASSERT_TRUE(bench.turn());  // the panel is informed of that, and sends
    bench.procedure->cancel();
    (void)bench.goOn();
    EXPECT_TRUE(hasGains(kOther));
}

/// They would be overwritten if they were sent while all of OL of the kept ones is still to come.
TEST_F(TriedGains, GiveWayToThoseThatAreAppliedRightAfterTheyWereKept) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    EXPECT_FALSE(bench.procedure->take(kApplied)) << "they are not kept yet";
    EXPECT_EQ(bench.procedure->report().gains->kp, kGood.kp);
    keep();
    EXPECT_EQ(bench.procedure->report().gains->kp, kOther.kp);
    EXPECT_TRUE(bench.procedure->take(kApplied));
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(report.kept);
    EXPECT_TRUE(hasGains(kApplied));
}

TEST_F(TriedGains, GiveWayToThoseThatAreAppliedWhileAllOfOlIsSent) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    ASSERT_TRUE(bench.turn());  // the panel is informed of that, and sends
    EXPECT_TRUE(bench.procedure->take(kApplied));
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Done);
    EXPECT_TRUE(hasGains(kApplied));
}

TEST_F(TriedGains, GiveWayToThoseThatAreAppliedEvenIfItWasTooLateToKeepThem) {
    ASSERT_NO_FATAL_FAILURE(tryOther(0.2));
    bench.bus.runFor(300ms);
    keep();
    EXPECT_TRUE(bench.procedure->take(kApplied));
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Done);
    EXPECT_TRUE(hasGains(kApplied));
}

/// All of OL is sent into a line that is deaf for longer than a command is repeated, then once more.
TEST_F(TriedGains, StayWithAllOfOlWhenTheyAreKeptAndTheLinkFailsForAMoment) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    ASSERT_NO_FATAL_FAILURE(deafen(400ms));
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(report.kept);
    EXPECT_FALSE(report.failure);
    EXPECT_TRUE(hasGains(kOther));
}

TEST_F(TriedGains, StayWhenTheyAreKeptAndTheLinkIsSuspectedBeforeThePanelKnowsIt) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    bench.procedure->onLinkSuspect();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_TRUE(report.kept);
    EXPECT_TRUE(hasGains(kOther));
}

TEST_F(TriedGains, AreReportedAsKeptWhenTheLinkFailsForTooLongForAllOfOl) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    ASSERT_TRUE(bench.turn());
    keep();
    ASSERT_NO_FATAL_FAILURE(deafen(1'500ms));
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_TRUE(report.kept);
    EXPECT_EQ(bench.truth().gains.kp, kOther.kp);
    EXPECT_LT(bench.truth().gains.ol, kOther.ol);
}

TEST_F(TriedGains, TooLateToKeepTheyAreThoseFromBefore) {
    ASSERT_NO_FATAL_FAILURE(tryOther(0.2));
    bench.bus.runFor(300ms);  // the time has ended, and the panel does not know it yet
    keep();
    bench.procedure->cancel();
    (void)bench.goOn();
    EXPECT_TRUE(hasGains(kGood));
}

TEST_F(TriedGains, AreTakenBackAtAStop) {
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    for (int i = 0; i < 5; ++i)
        ASSERT_TRUE(bench.turn());
    ASSERT_TRUE(hasGains(kOther));
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    EXPECT_TRUE(hasGains(kGood));
}

/// From shortly before the end of the trial no command arrives, for longer than a command is repeated.
TEST_F(TriedGains, AreTakenBackBehindADeafLine) {
    ASSERT_NO_FATAL_FAILURE(tryOther(1.0));
    for (int i = 0; i < 50; ++i)
        ASSERT_TRUE(bench.turn());
    ASSERT_EQ(bench.truth().gains.kp, kOther.kp);
    ASSERT_NO_FATAL_FAILURE(deafen(1'500ms));
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Failed);
    bench.bus.runFor(3s);  // the line is back, and the module has been found again
    EXPECT_EQ(bench.truth().gains.kp, kGood.kp);
}

TEST_F(TriedGains, AreTakenBackWhenTheServoGoesOff) {
    ASSERT_TRUE(hold());
    servo::SetGain weak = kGood;
    weak.kp = weak.kd = weak.ki = 0;  // nothing holds it
    weak.el = 20;
    bench.begin(intent::TryGains{weak, 10.0});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Trying));
    bench.set(sim::Input::Load, kPush);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_TRUE(report.failure == ProcedureFailure::WentOff ||
                report.failure == ProcedureFailure::TravelLimit);
    EXPECT_TRUE(hasGains(kGood));
}

TEST_F(TriedGains, AreRefusedWhereNothingIsHeldOrKnown) {
    const intent::TryGains wanted{kGood, 10.0};
    ASSERT_TRUE(bench.connect());
    EXPECT_EQ(plan(wanted, bench.module()).error(), Refusal::GainsUnknown);
    ASSERT_TRUE(bench.perform(intent::ApplyGains{kGood}));
    EXPECT_EQ(plan(wanted, bench.module()).error(), Refusal::ServoOff);
    ASSERT_TRUE(bench.perform(intent::Enable{}));
    EXPECT_TRUE(plan(wanted, bench.module()).has_value());
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::VelocityProfile{CountsPerTick(65'536), CountsPerTickSquared(1'311), false}}));
    EXPECT_EQ(plan(wanted, bench.module()).error(), Refusal::Moving);
}

/// 0.03 N·m takes 9 PWM counts, which the integral term supplies; a lowered output limit must leave it as
/// many.
TEST_F(TriedGains, ALoadIsHeldMeanwhile) {
    ASSERT_TRUE(hold());
    bench.set(sim::Input::Load, 0.03);
    bench.bus.runFor(2s);
    watch();
    EXPECT_EQ(bench.run(intent::TryGains{kOther, 2.0}).stage, ProcedureStage::Done);
    EXPECT_LE(farthest, 8);
}

/// Undamped: the delay of a tick outweighs the friction, and one count is enough to start a swing.
TEST_F(TriedGains, FiftyUnstableSetsAreTakenBackAtOnce) {
    ASSERT_TRUE(hold());
    std::mt19937 random(16);
    std::uniform_int_distribution<int> kp(2'000, 6'000), kd(0, 100);
    for (int set = 0; set < 50; ++set) {
        servo::SetGain bad = kGood;
        bad.kp = static_cast<std::uint16_t>(kp(random));
        bad.kd = static_cast<std::uint16_t>(kd(random));
        bad.ki = 0;
        SCOPED_TRACE(testing::Message() << "Kp " << bad.kp << " Kd " << bad.kd);
        watch();
        bench.begin(intent::TryGains{bad, 10.0});
        ASSERT_TRUE(bench.runTo(ProcedureStage::Trying));
        push();
        const ProcedureReport report = bench.goOn();
        const int withNet = farthest;
        EXPECT_TRUE(report.failure == ProcedureFailure::Swings ||
                    report.failure == ProcedureFailure::Saturates);
        ASSERT_TRUE(hasGains(kGood));
        EXPECT_LE(back.value() - third.value_or(*back), 300ms);
        ASSERT_TRUE(bench.truth().servoOn);
        bench.settle();
        EXPECT_NEAR(bench.truth().position, stood, 8) << "it is calm again";

        watch();
        ASSERT_TRUE(bench.perform(intent::ApplyGains{bad}));
        push();
        bench.bus.runFor(2s);
        EXPECT_LE(withNet, 0.2 * farthest);
        ASSERT_TRUE(bench.perform(intent::ApplyGains{kGood}));
        bench.settle();
    }
}

TEST_F(TriedGains, FiftyStableSetsAreNotTakenBackEarly) {
    ASSERT_TRUE(hold());
    std::mt19937 random(17);
    std::uniform_real_distribution<double> kp(30, 400), damping(6, 12), friction(0, 0.006), ki(0, 40);
    for (int set = 0; set < 50; ++set) {
        servo::SetGain good = kGood;
        good.kp = static_cast<std::uint16_t>(kp(random));
        good.kd = static_cast<std::uint16_t>(good.kp * damping(random));
        good.ki = static_cast<std::uint16_t>(ki(random));
        bench.set(sim::Input::Friction, friction(random));
        bench.begin(intent::TryGains{good, 2.0});
        ASSERT_TRUE(bench.runTo(ProcedureStage::Trying));
        ASSERT_TRUE(bench.turn());
        push();
        const ProcedureReport report = bench.goOn();
        EXPECT_EQ(report.stage, ProcedureStage::Done)
            << "Kp " << good.kp << " Kd " << good.kd << ' ' << static_cast<int>(report.failure.value());
        ASSERT_TRUE(hasGains(kGood));
    }
}

}  // namespace
}  // namespace nmc::test
