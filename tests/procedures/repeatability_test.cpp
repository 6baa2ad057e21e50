// SPDX-License-Identifier: GPL-3.0-or-later
// Approaches of a switch and of the index from both sides (DS-V 5.2 Set Homing Mode). The truth is the play
// that the simulator's load has behind the encoder.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;
using Input = sim::Input;

// ---- the figures, from closed forms ----

TEST(Repeatability, IsMeanDeviationAndRangeOfEachDirection) {
    EdgeCaptures edges;
    edges.forward = {10, 12, 11};
    edges.reverse = {-20, -20, -19};
    edges.perReading = 2;
    edges.readings = 4;
    const auto found = repeatabilityOf(edges);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->forward.mean, 11 - 0.25) << "a capture is late by half a reading on average";
    EXPECT_DOUBLE_EQ(found->forward.deviation, 1.0);
    EXPECT_DOUBLE_EQ(found->forward.range, 2.0);
    EXPECT_NEAR(found->reverse.mean, -59.0 / 3 + 0.25, 1e-12);
    EXPECT_NEAR(found->reverse.deviation, std::sqrt(1.0 / 3), 1e-12);
    EXPECT_DOUBLE_EQ(found->reverse.range, 1.0);
    EXPECT_NEAR(found->backlash, 11 + 59.0 / 3 - 0.5, 1e-12);
    // The standard errors squared are 1/3 and 1/9; Student's t for 4 degrees of freedom is 2.776.
    EXPECT_NEAR(found->uncertainty, 1 + 2 + 2.776 * 2 / 3, 0.01);
}

TEST(Repeatability, IsTheLessCertainTheFewerApproachesThereAre) {
    EdgeCaptures edges;
    for (int i = 0; i < 2; ++i) {
        edges.forward.push_back(2 * i);
        edges.reverse.push_back(2 * i);
    }
    EXPECT_NEAR(repeatabilityOf(edges)->uncertainty, 1 + 4.303 * std::sqrt(2.0), 0.06);
    for (int i = 2; i < 10; ++i) {
        edges.forward.push_back(2 * (i % 2));
        edges.reverse.push_back(2 * (i % 2));
    }
    EXPECT_NEAR(repeatabilityOf(edges)->uncertainty, 1 + 2.101 * std::sqrt(2.0 / 9), 0.01);
}

TEST(Repeatability, CountsOnWhereThePositionWraps) {
    EdgeCaptures edges;
    edges.forward = {std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};
    edges.reverse = {2'147'483'617, 2'147'483'617};
    const auto found = repeatabilityOf(edges);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->forward.range, 1.0);
    EXPECT_DOUBLE_EQ(found->backlash, 30.5);
}

TEST(Repeatability, NeedsTwoCapturesInEachDirection) {
    EdgeCaptures edges;
    EXPECT_FALSE(repeatabilityOf(edges));
    edges.forward = {1, 2, 3};
    edges.reverse = {1};
    EXPECT_FALSE(repeatabilityOf(edges));
    edges.reverse.push_back(1);
    EXPECT_TRUE(repeatabilityOf(edges));
}

// ---- the run ----

[[nodiscard]] intent::MeasureRepeatability atLimit1(double velocity = 0.5, unsigned times = 3) {
    HomingRecipe recipe = slowRecipe();
    recipe.onLimit1 = true;
    recipe.reverse = false;
    recipe.velocity = velocity;
    return {recipe, times};
}

class Measuring : public testing::Test {
protected:
    [[nodiscard]] bool prepare(double switchAt = 300, double play = 40) {
        bench.set(Input::HomeSwitchAt, switchAt);
        bench.set(Input::LoadPlay, play);
        return bench.enable();
    }
    void expectQuiet() {
        bench.bus.runFor(2s);
        bench.take();
        EXPECT_EQ(bench.truth().commandVelocity, 0);
        EXPECT_NEAR(bench.truth().velocity, 0, 0.05);
        EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
        EXPECT_EQ(bench.bus.sends("AA 01 00"), 0U) << "zero is not set";
    }
    void expectFailure(const ProcedureReport& report, ProcedureFailure failure) {
        EXPECT_EQ(report.stage, ProcedureStage::Failed);
        EXPECT_EQ(report.failure, failure) << static_cast<int>(report.failure.value_or(failure));
        expectQuiet();
    }
    ServoBench bench;
};

/// At up to one count per tick, from either side of the switch, on each version.
TEST(Measurement, FindsRandomBacklashWithinOneCount) {
    std::mt19937 random(34);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    constexpr std::array<std::uint8_t, 6> kVersions{1, 2, 3, 4, 5, 10};
    double worst = 0.0;
    for (unsigned run = 0; run < 42; ++run) {
        const std::uint8_t version = kVersions[run % kVersions.size()];
        const double play = run == 0 ? 0.0 : std::floor(between(0, 300));
        const double place = std::floor(between(200, 600));
        const double velocity = between(0.2, 1.0);
        ServoBench bench(version);
        SCOPED_TRACE("play " + std::to_string(play) + ", switch at " + std::to_string(place) + ", " +
                     std::to_string(velocity) + " counts/tick, version " + std::to_string(version));
        bench.set(Input::HomeSwitchAt, place);
        bench.set(Input::LoadPlay, play);
        bench.set(Input::Friction, between(0, 0.008));
        ASSERT_TRUE(bench.enable());
        if (random() % 3 == 1) {
            ASSERT_TRUE(bench.moveTo(static_cast<std::int32_t>(place + play) + 100));
        }
        bench.module().home.declare(bench.module().latestTime);
        const ProcedureReport report = bench.run(atLimit1(velocity));
        ASSERT_EQ(report.stage, ProcedureStage::Done);
        EXPECT_EQ(report.edges.forward.size(), 3U);
        EXPECT_EQ(report.edges.reverse.size(), 3U);
        EXPECT_FALSE(report.edges.index);
        EXPECT_FALSE(report.home);
        const auto found = repeatabilityOf(report.edges);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->backlash, play, 1.0);
        EXPECT_NEAR(found->backlash, play, found->uncertainty);
        EXPECT_NEAR(found->forward.mean, place + play, 1.5);
        EXPECT_NEAR(found->reverse.mean, place, 1.5);
        worst = std::max(worst, std::abs(found->backlash - play));
        EXPECT_EQ(bench.module().home.counts(), 0) << "home is what it was";
        EXPECT_EQ(bench.module().homing.state(), HomeWatch::State::Idle);
        EXPECT_TRUE(bench.truth().servoOn);
        EXPECT_EQ(bench.truth().commandVelocity, 0);
        bench.bus.expectNoViolations();
    }
    std::printf("42 backlashes: off by up to %.2f counts\n", worst);
}

/// The simulator reads its inputs in each tick of 0.512 ms, whatever SR is; the data sheet does not say
/// so.
TEST_F(Measuring, IsAsExactAtALowerServoRate) {
    for (const std::uint8_t sr : {std::uint8_t{4}, std::uint8_t{8}}) {
        ServoBench slow;
        slow.set(Input::HomeSwitchAt, 600.0);
        slow.set(Input::LoadPlay, 40.0);
        ASSERT_TRUE(slow.connect());
        const servo::SetGain gains{
            40, static_cast<std::uint16_t>(2'000 / sr), 0, 0, 255, 0, 4'000, sr, std::uint8_t{0}};
        ASSERT_TRUE(slow.perform(intent::ApplyGains{gains}) && slow.perform(intent::Enable{}));
        intent::MeasureRepeatability wanted = atLimit1(0.5 * sr, 5);  // half a count in 0.512 ms
        wanted.recipe.acceleration = 0.01 * sr;
        const ProcedureReport report = slow.run(wanted);
        ASSERT_EQ(report.stage, ProcedureStage::Done);
        const auto found = repeatabilityOf(report.edges);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->backlash, 40, 1.0) << "SR " << int{sr};
        EXPECT_NEAR(found->forward.mean, 640, 1.5);
        EXPECT_NEAR(found->reverse.mean, 600, 1.5);
        EXPECT_GE(found->uncertainty, 1 + 0.5 * sr) << "it may read only once per servo tick";
    }
}

/// The stop and the delay are longer, and the uncertainty says so.
TEST_F(Measuring, SaysHowUncertainAFastApproachIs) {
    ASSERT_TRUE(prepare(2'000, 150));
    intent::MeasureRepeatability wanted = atLimit1(6.0, 5);
    wanted.recipe.acceleration = 0.05;
    const ProcedureReport report = bench.run(wanted);
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    const auto found = repeatabilityOf(report.edges);
    ASSERT_TRUE(found);
    EXPECT_GE(found->uncertainty, 7.0) << "a count, and 6 counts per tick";
    EXPECT_NEAR(found->backlash, 150, found->uncertainty);
}

TEST_F(Measuring, SeesTheNoiseOfTheEncoderAsSpread) {
    bench.set(Input::EncoderNoise, 0.6);
    ASSERT_TRUE(prepare());
    const ProcedureReport report = bench.run(atLimit1(0.5, 20));
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    const auto found = repeatabilityOf(report.edges);
    ASSERT_TRUE(found);
    for (const EdgeSpread& spread : {found->forward, found->reverse}) {
        EXPECT_GT(spread.deviation, 0.3);
        EXPECT_LT(spread.deviation, 1.5);
    }
    EXPECT_NEAR(found->backlash, 40, found->uncertainty);
}

TEST_F(Measuring, TheIndexShowsNothingOfTheLoadsBacklash) {
    ASSERT_TRUE(prepare(100'000, 300));
    ASSERT_TRUE(bench.truth().index) << "it is left first";
    intent::MeasureRepeatability wanted = atLimit1(0.4, 4);
    wanted.recipe.onLimit1 = false;
    wanted.recipe.onIndex = true;
    const ProcedureReport report = bench.run(wanted);
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(bench.stages.count(ProcedureStage::BackingOff), 1U);
    EXPECT_TRUE(report.edges.index);
    const auto found = repeatabilityOf(report.edges);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->backlash, 0, found->uncertainty);
    EXPECT_NEAR(found->forward.mean, 0, 1);
    EXPECT_LE(found->forward.range, 1);
    bench.bus.expectNoViolations();
}

TEST(Measurement, MeasuresAtTheHomeSwitchOfAStepper) {
    for (const double play : {0.0, 17.0, 120.0}) {
        ProcedureBench bench({{ModuleType::Stepper, 1}});
        ASSERT_TRUE(bench.connect());
        bench.bus.runFor(200ms);
        bench.take();
        ASSERT_TRUE(bench.perform(
            stepperintent::SetParameters{{stepper::SpeedMode::X1, false, false, false, 4, 200, 50, 0}}));
        ASSERT_TRUE(bench.perform(intent::Enable{}));
        bench.set(Input::HomeSwitchAt, 250.0);
        bench.set(Input::LoadPlay, play);
        HomingRecipe recipe;
        recipe.onHomeSwitch = true;
        recipe.reverse = false;
        recipe.velocity = 400;
        recipe.acceleration = 2'000;
        recipe.travelLimit = 2'000;
        recipe.timeLimit = 20;
        const ProcedureReport report = bench.run(intent::MeasureRepeatability{recipe, 4});
        ASSERT_EQ(report.stage, ProcedureStage::Done);
        const auto found = repeatabilityOf(report.edges);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->backlash, play, 1.0);
        EXPECT_FALSE(bench.stepperTruth().moving);
        EXPECT_FALSE(bench.searches());
        bench.bus.expectNoViolations();
    }
}

// ---- what is refused ----

TEST_F(Measuring, IsRefusedBeforeAnythingMoves) {
    ASSERT_TRUE(prepare());
    const auto refusal = [&](auto change) {
        intent::MeasureRepeatability wanted = atLimit1();
        ModuleState module = bench.module();
        change(wanted, module);
        const auto orders = plan(wanted, module);
        EXPECT_EQ(procedureFor(wanted, module) == nullptr, !orders);
        return orders ? std::nullopt : std::optional(orders.error());
    };
    using Wanted = intent::MeasureRepeatability;
    EXPECT_EQ(refusal([](Wanted&, ModuleState&) {}), std::nullopt);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.times = 1; }), Refusal::TooFewOrMany);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.times = 101; }), Refusal::TooFewOrMany);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.onLimit1 = false; }), Refusal::NothingToFind);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.onLimit2 = true; }), Refusal::NoSingleInput);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.onIndex = true; }), Refusal::NoSingleInput);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.onCurrentLimit = true; }),
              Refusal::NoSingleInput);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.onPositionError = true; }),
              Refusal::NoSingleInput);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.thenIndex = true; }), Refusal::NoSingleInput);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.velocity = 0; }), Refusal::NoVelocity);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.acceleration = 0; }), Refusal::NoAcceleration);
    EXPECT_EQ(refusal([](Wanted& w, ModuleState&) { w.recipe.travelLimit = 0; }), Refusal::NoSearchLimits);
    EXPECT_EQ(refusal([](Wanted&, ModuleState& m) { m.travel.fastest = 0.4; }), Refusal::TooFast);
    EXPECT_EQ(refusal([](Wanted&, ModuleState& m) {
                  m.io.emplace();
                  m.io->limit1IsInput = false;
              }),
              Refusal::LimitIsOutput);
    EXPECT_EQ(refusal([](Wanted&, ModuleState& m) { m.silent = true; }), Refusal::Unresponsive);
    EXPECT_EQ(refusal([](Wanted&, ModuleState& m) { m.readOnly = true; }), Refusal::ReadOnly);
    ASSERT_TRUE(bench.perform(
        intent::Move{servomotion::VelocityProfile{CountsPerTick(1 << 14), CountsPerTickSquared(655)}}));
    bench.bus.runFor(100ms);
    bench.take();
    EXPECT_EQ(refusal([](Wanted&, ModuleState&) {}), Refusal::Moving);
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    bench.settle();
    EXPECT_EQ(refusal([](Wanted&, ModuleState&) {}), Refusal::ServoOff);
    EXPECT_EQ(bench.bus.sends("AA 01 19"), 0U);
}

// ---- what ends it ----

TEST_F(Measuring, EndsWhereThereIsNoSwitchWithinTheDistance) {
    ASSERT_TRUE(prepare(5'000));
    intent::MeasureRepeatability wanted = atLimit1();
    wanted.recipe.travelLimit = 1'000;
    expectFailure(bench.run(wanted), ProcedureFailure::TravelLimit);
    EXPECT_NEAR(bench.truth().position, 1'000, 100);
    EXPECT_TRUE(bench.truth().servoOn);
}

TEST_F(Measuring, EndsAtItsTimeLimit) {
    ASSERT_TRUE(prepare(5'000));
    intent::MeasureRepeatability wanted = atLimit1();
    wanted.recipe.timeLimit = 1;
    expectFailure(bench.run(wanted), ProcedureFailure::TimeLimit);
}

TEST_F(Measuring, EndsAtASwitchThatIsClosedOnBothSides) {
    bench.set(Input::Limit1, 1.0);
    ASSERT_TRUE(bench.enable());
    intent::MeasureRepeatability wanted = atLimit1();
    wanted.recipe.travelLimit = 600;
    expectFailure(bench.run(wanted), ProcedureFailure::TravelLimit);
    EXPECT_NEAR(bench.truth().position, -600, 100) << "it went where the switch should open";
}

TEST_F(Measuring, EndsAtTheTravelLimits) {
    ASSERT_TRUE(prepare(5'000));
    bench.module().home.declare(bench.module().latestTime);
    bench.module().travel.highest = 400;
    expectFailure(bench.run(atLimit1()), ProcedureFailure::SoftLimit);
    // As in a search for home: half a second at 977 counts/s and the stop beyond the limit, at most.
    EXPECT_LT(bench.truth().position, 400 + 489 + 100);
    EXPECT_EQ(bench.module().home.counts(), 0);
}

TEST_F(Measuring, EndsAtACamThatIsShorterThanTheStop) {
    ASSERT_TRUE(bench.enable());
    std::optional<bool> last;
    bench.onSlice = [&] {
        const double shaft = bench.truth().shaftCounts;
        const bool closed = shaft > 300 && shaft < 305;  // 0.5 counts/tick stop within 12 counts
        if (last != closed)
            bench.set(Input::Limit1, closed ? 1.0 : 0.0);
        last = closed;
    };
    expectFailure(bench.run(atLimit1()), ProcedureFailure::Bounced);
}

TEST_F(Measuring, EndsWhenTheMotorIsHeldFast) {
    bench.set(Input::HomeSwitchAt, 2'000);
    ASSERT_TRUE(bench.enable(200));
    bench.begin(atLimit1());
    ASSERT_TRUE(bench.runTo(ProcedureStage::Searching));
    bench.fault(sim::FaultKind::Stall);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::WentOff);
    EXPECT_FALSE(bench.truth().servoOn) << "it is not switched on again";
}

TEST_F(Measuring, EndsWhenTheLineIsLost) {
    ASSERT_TRUE(prepare());
    bench.begin(atLimit1(0.5, 10));
    while (bench.procedure->report().round < 3)
        ASSERT_TRUE(bench.turn());
    bench.bus.losesReply = [](ByteSpan) { return true; };
    const ProcedureReport report = bench.goOn(30);
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(bench.truth().commandVelocity, 0) << "the stop arrives although the answers do not";
    EXPECT_EQ(report.edges.forward.size(), 2U) << "what was captured is still there";
}

class MeasuringEndedIn : public testing::TestWithParam<ProcedureStage> {
protected:
    /// In the second round.
    [[nodiscard]] bool reach() {
        bench.set(Input::HomeSwitchAt, 300.0);
        bench.set(Input::LoadPlay, 40.0);
        if (!bench.enable())
            return false;
        bench.begin(atLimit1(0.5, 10));
        while (bench.procedure->report().round < 2)
            if (!bench.turn())
                return false;
        return bench.runTo(GetParam());
    }
    void expectEnded(const ProcedureReport& report) {
        EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
        EXPECT_FALSE(report.failure);
        EXPECT_GE(report.edges.forward.size(), 1U) << "what was captured is still there";
        bench.bus.runFor(3s);
        bench.take();
        EXPECT_EQ(bench.truth().commandVelocity, 0);
        EXPECT_NEAR(bench.truth().velocity, 0, 0.05);
        EXPECT_TRUE(bench.truth().servoOn) << "it still holds";
        bench.bus.expectNoViolations();
    }
    ServoBench bench;
};

TEST_P(MeasuringEndedIn, ByCancel) {
    ASSERT_TRUE(reach());
    bench.procedure->cancel();
    const ProcedureReport report = bench.goOn(5);
    EXPECT_FALSE(bench.module().latest->servoStatus().homeInProgress());
    expectEnded(report);
}

TEST_P(MeasuringEndedIn, ByStopAll) {
    ASSERT_TRUE(reach());
    const std::size_t before = bench.bus.sent.size();
    bench.procedure->cancel();
    ASSERT_TRUE(bench.bus.stopAll());
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(bench.bus.sends("AA 01 05", before), 0U) << "nothing is started any more";
    expectEnded(report);
}

INSTANTIATE_TEST_SUITE_P(Stages, MeasuringEndedIn,
                         testing::Values(ProcedureStage::Searching, ProcedureStage::Stopping,
                                         ProcedureStage::Reading));

}  // namespace
}  // namespace nmc::test
