// SPDX-License-Identifier: GPL-3.0-or-later
// Square waves and sines of the command position: what is sent, what they find, and how they end. Engine and
// simulator in virtual time, compared with the state of the simulator and with the analytic loop.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/frequency/frequencyresponse.h"
#include "model/intent/looptestplan.h"
#include "model/response/edgefold.h"
#include "model/tuning/predict.h"
#include "tests/procedures/procedurebench.h"
#include "tests/support/tunedservo.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

constexpr servo::SetGain kGains{200, 2'000, 0, 0, 255, 0, 4'000, 1, std::uint8_t{0}};

/// The motor of the simulator without dry friction: its linear behaviour can be calculated.
[[nodiscard]] MotorConstants linearMotor() {
    sim::MotorParameters motor;
    motor.coulombNm = 0;
    return testing_support::physics(motor);
}

class LoopTests : public testing::Test {
protected:
    [[nodiscard]] bool hold() {
        bench.set(sim::Input::Friction, 0.0);
        return bench.connect() && bench.perform(intent::ApplyGains{kGains}) &&
               bench.perform(intent::Enable{}) && bench.perform(intent::StopHere{});
    }
    [[nodiscard]] std::optional<Refusal> refusal(const Intent& wanted) {
        const auto steps = plan(wanted, bench.module());
        return steps ? std::nullopt : std::optional(steps.error());
    }
    /// Records the range of the command position while the procedure runs.
    void watchCommands() {
        lowest = highest = bench.truth().commandPosition;
        bench.bus.onTime = [this] {
            lowest = std::min(lowest, bench.truth().commandPosition);
            highest = std::max(highest, bench.truth().commandPosition);
        };
    }
    /// Begins with the slowest sines, the first of which lasts ten seconds.
    void beginSines() {
        ASSERT_TRUE(hold());
        bench.begin(intent::FrequencyResponse{20, 0.5, 1.0});
        ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
        bench.bus.runFor(500ms);
    }
    static constexpr intent::SquareWave kWave{100, 0.4, 3, 200, ResponseMethod::StopHere};
    ServoBench bench;
    double lowest = 0, highest = 0;
};

class WavesOfEachWay : public LoopTests, public testing::WithParamInterface<ResponseMethod> {};

TEST_P(WavesOfEachWay, JumpToAndFroAndEndWhereTheyBegan) {
    ASSERT_TRUE(hold());
    const double from = bench.truth().commandPosition;
    watchCommands();
    std::vector<ResponseTaken> edges;
    bench.onTurn = [&](Procedure& procedure) {
        EXPECT_LE(procedure.report().round, procedure.report().rounds);
        const auto& edge = procedure.report().step;
        if (edge && (edges.empty() || edges.back() != *edge))
            edges.push_back(*edge);
    };
    intent::SquareWave wave = kWave;
    wave.method = GetParam();
    const ProcedureReport report = bench.run(wave);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(lowest, from - 50);
    EXPECT_EQ(highest, from + 50);
    EXPECT_EQ(bench.truth().commandPosition, from);
    ASSERT_EQ(edges.size(), 6U) << "three periods have six edges; half an edge leads there";
    for (std::size_t i = 0; i < edges.size(); ++i) {
        EXPECT_EQ(edges[i].goal - edges[i].from, i % 2 == 0 ? -100 : 100);
        if (i > 0) {
            EXPECT_GE(toSeconds(edges[i].at - edges[i - 1].at), 0.2);
            EXPECT_LE(toSeconds(edges[i].at - edges[i - 1].at), 0.26)
                << "half a period, a turn and two commands";
        }
    }
    EXPECT_TRUE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, WavesOfEachWay,
                         testing::Values(ResponseMethod::StopHere, ResponseMethod::Profile));

TEST_F(LoopTests, AWaveTakesGainsBeforeItsNextEdge) {
    ASSERT_TRUE(hold());
    bench.begin(kWave);
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    servo::SetGain other = kGains;
    other.kp = 300;
    EXPECT_TRUE(bench.procedure->take(other));
    EXPECT_EQ(bench.truth().gains.kp, 200);
    const TimePoint told = bench.bus.now;
    bool seen = false;
    bench.onTurn = [&](Procedure& procedure) {
        const auto& edge = procedure.report().step;
        if (edge && edge->at > told && edge->gains.kp == 300)
            seen = true;
    };
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Done);
    EXPECT_TRUE(seen);
    EXPECT_EQ(bench.truth().gains.kp, 300);
    other.el = 100;
    bench.begin(kWave);
    EXPECT_FALSE(bench.procedure->take(other)) << "its edges would trip the servo";
}

/// Gains that it took and never sent would be lost. Three rounds have seven edges, of which the first is only
/// half an edge and is not reported.
TEST_F(LoopTests, AWaveTakesNoGainsAfterItsLastEdge) {
    ASSERT_TRUE(hold());
    servo::SetGain other = kGains;
    other.kp = 300;
    std::optional<ResponseTaken> last;
    std::vector<bool> taken;
    bench.onTurn = [&](Procedure& procedure) {
        const auto& edge = procedure.report().step;
        if (edge && edge != last) {
            last = edge;
            taken.push_back(procedure.take(other));
        }
    };
    EXPECT_EQ(bench.run(kWave).stage, ProcedureStage::Done);
    EXPECT_EQ(taken, (std::vector<bool>{true, true, true, true, true, false}));
    EXPECT_FALSE(bench.procedure->take(other));
    bench.onTurn = {};
    bench.begin(kWave);
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.procedure->cancel();
    EXPECT_FALSE(bench.procedure->take(other));
}

TEST_F(LoopTests, AWaveThatIsLeftByMoreThanItsExcursionEndsInAHold) {
    ASSERT_TRUE(hold());
    intent::SquareWave wave = kWave;
    wave.excursion = 20;
    bench.begin(wave);
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.set(sim::Input::Load, 0.15);  // pulls it about 60 counts off
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
    const double command = bench.truth().commandPosition;
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.truth().commandPosition, command) << "nothing jumps any more";
}

TEST_F(LoopTests, AreRefusedBeforeAnythingIsSent) {
    const intent::FrequencyResponse sines{20, 1.0, 40.0};
    ASSERT_TRUE(bench.connect());
    EXPECT_TRUE(refusal(kWave));
    EXPECT_TRUE(refusal(sines));
    ASSERT_TRUE(hold());
    EXPECT_EQ(refusal(kWave), std::nullopt);
    EXPECT_EQ(refusal(sines), std::nullopt);
    EXPECT_EQ(refusal(intent::SquareWave{0, 0.4, 3, 200}), Refusal::StepTooShort);
    EXPECT_EQ(refusal(intent::SquareWave{4'000, 0.4, 3, 200}), Refusal::StepTooLong);
    EXPECT_EQ(refusal(intent::SquareWave{100, 0.01, 3, 200}), Refusal::TestOutOfRange);
    EXPECT_EQ(refusal(intent::SquareWave{100, 0.4, 0, 200}), Refusal::TestOutOfRange);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 10.0, 5.0}), Refusal::TestOutOfRange);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 400.0}), Refusal::TestOutOfRange);
    servo::SetGain narrow = kGains;
    narrow.el = 42;
    ASSERT_TRUE(bench.perform(intent::ApplyGains{narrow}));
    EXPECT_EQ(refusal(kWave), Refusal::StepWouldTrip);
    EXPECT_EQ(refusal(sines), Refusal::StepWouldTrip) << "half a period behind, it is 40 counts off";
}

TEST_F(LoopTests, LimitsOfTravelHoldOnBothSides) {
    ASSERT_TRUE(hold());
    ModuleState& module = bench.module();
    module.travel.lowest = -1'000;
    module.travel.highest = 30;
    module.home.declare(module.latestTime);
    EXPECT_EQ(refusal(kWave), Refusal::BeyondTravel);
    module.travel.lowest = -30;
    module.travel.highest = 1'000;
    EXPECT_EQ(refusal(kWave), Refusal::BeyondTravel);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 40.0}), std::nullopt);
}

/// N edges sampled every 1.5 ms give samples N times as close together, but no closer than a tick.
TEST_F(LoopTests, EdgesFoldIntoAFinerOne) {
    ASSERT_TRUE(hold());
    std::vector<ResponseRecord> edges;
    std::vector<ScopeSample> samples;
    ResponseTaken last;
    bench.onTurn = [&](Procedure& procedure) {
        const auto& edge = procedure.report().step;
        if (edge && edge->at != last.at) {
            if (last.at != TimePoint{})
                edges.push_back(takeRun(ModuleIndex(0), samples, last, kFirstBand));
            last = *edge;
        }
        samples.clear();
        for (const bus::Sample& sample : bench.bus.all<bus::Sample>())
            if (sample.report.position) {
                samples.emplace_back();
                samples.back().time = sample.time;
                samples.back().position = *sample.report.position;
            }
    };
    intent::SquareWave wave = kWave;
    wave.rounds = 12;
    ASSERT_EQ(bench.run(wave).stage, ProcedureStage::Done);
    ASSERT_GE(edges.size(), 20U);
    const auto one = std::count_if(edges.front().points.begin(), edges.front().points.end(),
                                   [](const ResponsePoint& p) { return p.seconds > 0 && p.seconds < 0.05; });
    const auto forward = foldEdges(edges, true);
    ASSERT_TRUE(forward);
    const std::vector<FoldedPoint>& folded = forward->points;
    const auto all = std::count_if(folded.begin(), folded.end(),
                                   [](const FoldedPoint& p) { return p.seconds > 0 && p.seconds < 0.05; });
    EXPECT_GT(all, 2 * one);
    EXPECT_LE(all, static_cast<long>(0.05 / 512e-6) + 1);
    // The step of this motor as its own model predicts it, at the same times.
    const ResponseRecord reckoned =
        reckonStep(linearMotor(), {{}, 0, 100, 0.2, ResponseMethod::Profile, kGains},
                   standing(linearMotor(), kGains, 0, 0), kFirstBand);
    for (const FoldedPoint& point : folded) {
        if (point.seconds < 0.002 || point.seconds > 0.15)
            continue;
        EXPECT_LE(point.low, point.position);
        EXPECT_GE(point.high, point.position);
        const auto i = static_cast<std::size_t>(point.seconds / 512e-6);
        const double early = reckoned.points[i - 1].position;
        const double late = reckoned.points[i + 1].position;
        // Within the tick by which a time is uncertain, and the counts of two encoders.
        EXPECT_GE(point.position, std::min(early, late) - 4) << point.seconds;
        EXPECT_LE(point.position, std::max(early, late) + 4) << point.seconds;
    }
}

TEST_F(LoopTests, SinesFindTheLoopWithinADecibelAndFiveDegrees) {
    ASSERT_TRUE(hold());
    const ProcedureReport report = bench.run(intent::FrequencyResponse{20, 1.0, 40.0}, 300.0);
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_GE(report.frequencies.size(), 15U);
    EXPECT_GT(report.frequencies.back().hertz, 30.0) << "at 115 200 Bd the line carries 40 Hz";
    for (const FrequencyPoint& point : report.frequencies) {
        const std::complex<double> open = openLoopAt(linearMotor(), kGains, point.hertz);
        const std::complex<double> closed = open / (1.0 + open);
        EXPECT_NEAR(decibels(point.closed), decibels(closed), 1.0) << point.hertz << " Hz";
        EXPECT_NEAR(std::arg(point.closed / closed) * 180 / std::numbers::pi, 0.0, 5.0)
            << point.hertz << " Hz";
    }
    EXPECT_TRUE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(LoopTests, ASineStaysWithinItsAmplitudeAndEndsAtItsCentre) {
    ASSERT_TRUE(hold());
    const double from = bench.truth().commandPosition;
    watchCommands();
    ASSERT_EQ(bench.run(intent::FrequencyResponse{20, 2.0, 4.0}).stage, ProcedureStage::Done);
    EXPECT_EQ(lowest, from - 20);
    EXPECT_EQ(highest, from + 20);
    EXPECT_EQ(bench.truth().commandPosition, from);
}

/// At 1 Hz a sine lasts five seconds: 2 counts per tick are 3906 counts/s, or 19 531 counts. Each sine after
/// it leads back or away again, and the last way leads to the start.
TEST_F(LoopTests, SinesOnARampKeepMovingAndEndWhereTheyBegan) {
    ASSERT_TRUE(hold());
    const double from = bench.truth().commandPosition;
    watchCommands();
    const ProcedureReport report = bench.run(intent::FrequencyResponse{20, 1.0, 4.0, 2.0});
    ASSERT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_NEAR(report.speed, 3'906.25, 0.01);
    EXPECT_NEAR(highest, from + 19'531, 21);
    EXPECT_GE(lowest, from - 21);
    EXPECT_EQ(bench.truth().commandPosition, from);
    EXPECT_TRUE(bench.truth().servoOn);
    bench.bus.expectNoViolations();
}

TEST_F(LoopTests, ARampThatDoesNotFitIsRefusedBeforeAnythingMoves) {
    ASSERT_TRUE(hold());
    const std::size_t sent = bench.bus.sends("AA 01 57");
    const intent::FrequencyResponse ramp{20, 1.0, 4.0, 2.0};
    ASSERT_EQ(refusal(ramp), std::nullopt);
    ModuleState& module = bench.module();
    module.home.declare(module.latestTime);
    module.travel.lowest = -30;
    module.travel.highest = 19'600;
    EXPECT_EQ(refusal(ramp), std::nullopt);
    module.travel.highest = 19'500;
    EXPECT_EQ(refusal(ramp), Refusal::BeyondTravel);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, -2.0}), Refusal::BeyondTravel);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.5, 4.0, 2.0}), std::nullopt)
        << "3.3 s are enough for it";
    module.travel.highest = 100'000;
    module.travel.fastest = 1.9;
    EXPECT_EQ(refusal(ramp), Refusal::TooFast);
    // 20 counts at 4 Hz move by up to 503 counts/s, which are 0.257 counts per tick.
    module.travel.fastest = 2.2;
    EXPECT_EQ(refusal(ramp), Refusal::TooFast);
    module.travel.fastest = 2.3;
    EXPECT_EQ(refusal(ramp), std::nullopt);
    module.travel = {};
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, 0.26}), std::nullopt);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, -0.25}), Refusal::TestTooSlow);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, 51.0}), Refusal::TestOutOfRange);
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, std::nan("")}), Refusal::TestOutOfRange);
    // A tenth of a second behind, 9766 counts/s are 977 counts.
    servo::SetGain narrow = kGains;
    narrow.el = 1'000;
    module.gains = narrow;
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, 5.0}), Refusal::StepWouldTrip);
    EXPECT_EQ(bench.bus.sends("AA 01 57"), sent);
}

TEST_F(LoopTests, ARampIsRefusedWhileTheAxisMoves) {
    ASSERT_TRUE(hold());
    ASSERT_TRUE(bench.perform(intent::Move{
        servomotion::Trapezoid{Counts(20'000), CountsPerTick(2 << 16), CountsPerTickSquared(1'311)}}));
    ASSERT_TRUE(bench.module().moving());
    EXPECT_EQ(refusal(intent::FrequencyResponse{20, 1.0, 4.0, 2.0}), Refusal::Moving);
}

TEST_F(LoopTests, ARampIsCancelledWhereItIs) {
    ASSERT_TRUE(hold());
    bench.begin(intent::FrequencyResponse{20, 1.0, 4.0, 2.0});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.bus.runFor(2s);
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    const double command = bench.truth().commandPosition;
    EXPECT_NEAR(command, 2 * 3'906, 500);
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.truth().commandPosition, command);
    EXPECT_TRUE(bench.truth().servoOn);
}

/// With half of its drive, the motor cannot keep up.
TEST_F(LoopTests, AMotorThatFallsBehindItsRampIsHeld) {
    servo::SetGain weak = kGains;
    weak.ol = 10;
    ASSERT_TRUE(hold() && bench.perform(intent::ApplyGains{weak}));
    const ProcedureReport report = bench.run(intent::FrequencyResponse{20, 1.0, 4.0, 10.0});
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
    EXPECT_TRUE(report.frequencies.empty());
}

/// Where its loop resonates, the motor swings farther than its command.
TEST_F(LoopTests, AMotorThatReversesOnItsRampIsHeld) {
    servo::SetGain springy = kGains;
    springy.kd = 500;
    ASSERT_TRUE(hold() && bench.perform(intent::ApplyGains{springy}));
    const double resonance = marginsOf(linearMotor(), springy).crossover;
    const double enough = 2 * std::numbers::pi * resonance * 10 / ticksPerSecond(1);
    const ProcedureReport report = bench.run(intent::FrequencyResponse{10, 5.0, resonance, 1.02 * enough});
    EXPECT_EQ(report.failure, ProcedureFailure::Reversed);
    EXPECT_TRUE(bench.truth().servoOn);
}

TEST_F(LoopTests, ASineIsCancelledAtOnce) {
    ASSERT_NO_FATAL_FAILURE(beginSines());
    bench.procedure->cancel();
    const TimePoint cancelled = bench.bus.now;
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    EXPECT_LT(bench.bus.now - cancelled, 1s) << "the first frequency alone would take ten seconds";
    const double command = bench.truth().commandPosition;
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.truth().commandPosition, command);
}

TEST_F(LoopTests, OneReplyThatSaysTheServoIsOffEndsNoSine) {
    ASSERT_NO_FATAL_FAILURE(beginSines());
    bench.sayOff();
    const Procedure::Next next = bench.procedure->next(bench.module(), bench.bus.now);
    EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(next));
    ASSERT_TRUE(bench.turn());
    bench.procedure->cancel();
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.stage, ProcedureStage::Cancelled);
    EXPECT_FALSE(report.failure);
}

TEST_F(LoopTests, AStopOfAllEndsASineForGood) {
    ASSERT_NO_FATAL_FAILURE(beginSines());
    bench.bus.engine.stopAll(bench.bus.now);
    bench.bus.runFor(500ms);
    const double command = bench.truth().commandPosition;
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.truth().commandPosition, command);
}

TEST_F(LoopTests, AMotorThatASineSwingsTooFarIsHeld) {
    ASSERT_TRUE(hold());
    bench.begin(intent::FrequencyResponse{5, 0.5, 1.0});
    ASSERT_TRUE(bench.runTo(ProcedureStage::Moving));
    bench.bus.runFor(200ms);
    bench.set(sim::Input::Load, 0.15);
    const ProcedureReport report = bench.goOn();
    EXPECT_EQ(report.failure, ProcedureFailure::TravelLimit);
}

TEST_F(LoopTests, WhateverElseIsAskedForEndsASine) {
    ASSERT_NO_FATAL_FAILURE(beginSines());
    const TimePoint asked = bench.bus.now;
    ASSERT_EQ(bench.bus.perform(*plan(intent::StopAbruptly{}, bench.module())), bus::Outcome::Done);
    EXPECT_LT(bench.bus.now - asked, 20ms) << "a stop waits for no more than the exchange on the wire";
    EXPECT_EQ(bench.goOn().stage, ProcedureStage::Cancelled);
}

/// What the engine guarantees for a sine, whatever requests it.
class Sines : public LoopTests {
protected:
    void swing(Duration lasts = 10s) {
        const servo::StopMotor centre{true, servo::StopManner::Here, Counts(0)};
        before = bench.bus.sent.size();
        id = bench.bus.submit({{ModuleIndex(0), ServoCommand(centre)}}, bus::Sine{50, 2.0, lasts});
    }
    [[nodiscard]] std::size_t commands() const { return bench.bus.sends("AA 01 57", before); }
    /// Expects that no more commands of a sine are sent.
    void expectCalm() {
        const std::size_t sent = commands();
        bench.bus.runFor(500ms);
        EXPECT_EQ(commands(), sent);
    }
    bus::OperationId id{0};
    std::size_t before = 0;
};

TEST_F(Sines, AreToldAtMostTwoHundredTimesASecondWithPollsBetween) {
    ASSERT_TRUE(hold());
    swing(2s);
    bench.bus.runFor(2s);
    EXPECT_LE(commands(), 400U);
    EXPECT_GE(commands(), 280U) << "a command takes 2.3 ms, a poll 2 ms";
    bench.bus.runFor(200ms);
    const auto ended = bench.bus.all<bus::OperationFinished>();
    ASSERT_EQ(ended.back().id, id);
    EXPECT_EQ(ended.back().outcome, bus::Outcome::Done);
    EXPECT_EQ(ended.back().sine.commands.size(), commands());
    EXPECT_GE(ended.back().sine.polls.size(), commands() * 9 / 10);
    bench.bus.expectNoViolations();
}

TEST_F(Sines, CountAsMotionForWhomeverWatchesOverThePanel) {
    ASSERT_TRUE(hold());
    EXPECT_FALSE(bench.bus.engine.anythingMoves());
    swing();
    bench.bus.runFor(100ms);
    EXPECT_TRUE(bench.bus.engine.anythingMoves());
    EXPECT_TRUE(bench.bus.engine.stopUnasked(bench.bus.now));
    bench.bus.runFor(500ms);
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Cancelled);
    EXPECT_FALSE(bench.bus.engine.anythingMoves());
    expectCalm();
}

/// Another Stop Here would switch the servo on again.
TEST_F(Sines, EndWhenTheChipLetsGo) {
    ASSERT_TRUE(hold());
    swing();
    bench.bus.runFor(200ms);
    ASSERT_FALSE(bench.bus.outcomeOf(id));
    bench.set(sim::Input::Power, 0.0);
    bench.bus.runFor(50ms);
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Forbidden);
    bench.set(sim::Input::Power, 1.0);
    bench.bus.runFor(1s);
    EXPECT_FALSE(bench.truth().servoOn);
}

/// With the encoder counting the wrong way, it runs away until the position error trips.
TEST_F(Sines, EndWithATrip) {
    ASSERT_TRUE(hold());
    swing();
    bench.bus.runFor(200ms);
    bench.fault(sim::FaultKind::Reverse);
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Forbidden);
    bench.bus.runFor(1s);
    EXPECT_FALSE(bench.truth().servoOn);
}

TEST_F(Sines, EndWhenTheMotorIsHeldToMove) {
    ASSERT_TRUE(hold());
    swing();
    bench.bus.runFor(100ms);
    bus::HoldToMove jog;
    jog.module = ModuleIndex(0);
    jog.velocity = CountsPerTick(65'536);
    jog.acceleration = CountsPerTickSquared(1'311);
    jog.press = 1;
    bench.bus.engine.hold(jog, bench.bus.now);
    bench.bus.runFor(200ms);
    EXPECT_EQ(bench.bus.outcomeOf(id), bus::Outcome::Cancelled);
    expectCalm();
}

TEST_F(Sines, EndWithTheirLine) {
    ASSERT_TRUE(hold());
    swing();
    bench.bus.runFor(100ms);
    bench.fault(sim::FaultKind::MuteRx);
    bench.bus.runFor(5s);
    EXPECT_TRUE(bench.bus.outcomeOf(id).has_value());
    expectCalm();
}

/// On a slow line the test ends early, and what was measured by then counts.
TEST(LoopTestsOnASlowLine, SinesEndWhereTheLineIsTooSlowForThem) {
    ProcedureBench bench(servos(1, 4), {}, 19'200);
    bench.set(sim::Input::Friction, 0.0);
    ASSERT_TRUE(bench.connect() && bench.perform(intent::ApplyGains{kGains}) &&
                bench.perform(intent::Enable{}) && bench.perform(intent::StopHere{}));
    const ProcedureReport report = bench.run(intent::FrequencyResponse{20, 1.0, 40.0}, 300.0);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    ASSERT_GE(report.frequencies.size(), 8U);
    EXPECT_LT(report.frequencies.back().hertz, 16.0) << "a command takes 13 ms, and so does a poll";
    EXPECT_GT(report.frequencies.back().hertz, 5.0);
    for (const FrequencyPoint& point : report.frequencies) {
        const std::complex<double> open = openLoopAt(linearMotor(), kGains, point.hertz);
        const std::complex<double> closed = open / (1.0 + open);
        EXPECT_NEAR(decibels(point.closed), decibels(closed), 1.0) << point.hertz << " Hz";
        EXPECT_NEAR(std::arg(point.closed / closed) * 180 / std::numbers::pi, 0.0, 5.0)
            << point.hertz << " Hz";
    }
}

}  // namespace
}  // namespace nmc::test
