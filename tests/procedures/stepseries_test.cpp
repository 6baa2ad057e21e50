// SPDX-License-Identifier: GPL-3.0-or-later
// Series of steps: where they go, why they are refused before the first one, and what ends them at each.
#include "model/procedure/stepsrun.h"

#include <array>
#include <set>

#include "model/intent/homingplan.h"
#include "model/tuning/nextsteps.h"
#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

class StepSeries : public testing::Test {
protected:
    [[nodiscard]] static intent::StepSeries by(std::int32_t counts) {
        return {{counts, ResponseMethod::Profile, 0.2}, stepSeries(counts)};
    }
    [[nodiscard]] std::optional<Refusal> refusal(const intent::StepSeries& wanted) {
        const auto planned = plan(wanted, bench.module());
        EXPECT_EQ(procedureFor(wanted, bench.module()) == nullptr, !planned);
        return planned ? std::nullopt : std::optional(planned.error());
    }
    [[nodiscard]] bool hold(std::uint16_t positionErrorLimit = 4'000) {
        return bench.enable(positionErrorLimit) && bench.perform(intent::StopHere{});
    }
    /// Number of loads, starts and stops of any kind of servo 1, from this entry of `sent` on.
    [[nodiscard]] std::size_t motions(std::size_t from) const {
        return bench.bus.sends("AA 01 D4", from) + bench.bus.sends("AA 01 05", from) +
               bench.bus.sends("AA 01 17", from) + bench.bus.sends("AA 01 57", from);
    }
    /// Collects the steps, each of which is reported once it is recorded.
    void watchSteps() {
        bench.onTurn = [this](Procedure& procedure) {
            const auto& step = procedure.report().step;
            if (step && (steps.empty() || steps.back() != *step))
                steps.push_back(*step);
        };
    }
    /// Runs until this step is under way, or until the motor is coming to rest after it.
    [[nodiscard]] bool runTo(unsigned round, ProcedureStage stage) {
        return bench.runTo(stage, 5.0) && [&] {
            while (bench.procedure->report().round < round || bench.procedure->report().stage != stage)
                if (!bench.turn())
                    return false;
            return bench.turn() && bench.turn();  // what it has sent has arrived
        }();
    }
    ServoBench bench;
    std::vector<ResponseTaken> steps;
};

TEST_F(StepSeries, GoesThereAndBackInTwoSizesAndEndsWhereItBegan) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(1'000));
    bench.settle();
    watchSteps();
    std::set<double> commands;
    bench.bus.onTime = [&] { commands.insert(bench.truth().commandPosition); };
    const ProcedureReport report = bench.run(by(100));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.rounds, 4U);
    EXPECT_EQ(report.round, 4U);
    if (report.step && (steps.empty() || steps.back() != *report.step))
        steps.push_back(*report.step);
    ASSERT_EQ(steps.size(), 4U);
    const std::array goals{1'100, 1'000, 1'200, 1'000};
    for (std::size_t i = 0; i < goals.size(); ++i) {
        EXPECT_EQ(steps[i].goal, goals[i]);
        EXPECT_EQ(steps[i].from, i == 0 ? 1'000 : goals[i - 1]);
        EXPECT_EQ(steps[i].gains.kp, 200);
        if (i > 0) {
            EXPECT_GE(steps[i].at - steps[i - 1].at, 200ms + Standstill::kFor)
                << "a step takes a record and standstill";
        }
    }
    EXPECT_EQ(commands, (std::set<double>{1'000, 1'100, 1'200}));
    EXPECT_TRUE(bench.truth().servoOn);
    EXPECT_EQ(bench.truth().commandPosition, 1'000);
    EXPECT_NEAR(bench.truth().position, 1'000, 3);
    bench.bus.expectNoViolations();
}

TEST_F(StepSeries, SendsOtherGainsOnce) {
    ASSERT_TRUE(hold());
    intent::StepSeries wanted = by(50);
    wanted.each.gains = servo::SetGain{250, 2'500, 20, 200, 255, 0, 4'000, 1, std::uint8_t{0}};
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(bench.run(wanted).stage, ProcedureStage::Done);
    EXPECT_EQ(bench.truth().gains.kp, 250);
    EXPECT_EQ(bench.bus.sends("AA 01 E6", before) + bench.bus.sends("AA 01 F6", before), 1U)
        << "there is one Set Gain, of 14 or 15 bytes";
}

TEST_F(StepSeries, IsRefusedBeforeAnythingMoves) {
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(refusal(by(100)), Refusal::ServoOff);
    ASSERT_TRUE(hold(500));
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(refusal(by(100)), std::nullopt);
    EXPECT_EQ(refusal(by(0)), Refusal::StepTooShort);
    EXPECT_EQ(refusal({by(100).each, {}}), Refusal::StepTooShort);
    EXPECT_EQ(refusal({by(100).each, {100, 2'001}}), Refusal::StepTooLong);
    // 2 x 225 + 45 + 4 = 499; 2 x 226 + 45 + 4 = 501.
    EXPECT_EQ(refusal(by(225)), std::nullopt);
    EXPECT_EQ(refusal(by(226)), Refusal::StepWouldTrip);
    intent::StepSeries wrong = by(100);
    wrong.each.record = 3.1;
    EXPECT_EQ(refusal(wrong), Refusal::RecordTime);
    // Only the third step, twice as far, would leave the travel limits; in the other direction, none would.
    bench.module().travel.highest = 150;
    bench.module().home.found(0, bench.bus.now);
    EXPECT_EQ(refusal(by(100)), Refusal::BeyondTravel);
    EXPECT_EQ(refusal(by(75)), std::nullopt);
    EXPECT_EQ(refusal(by(-100)), std::nullopt);
    // The motor is held 10 counts outside: some steps lead inside, but others back outside.
    bench.module().travel.highest = -10;
    EXPECT_EQ(refusal(by(-100)), Refusal::BeyondTravel);
    EXPECT_EQ(motions(before), 0U);
}

/// Moves of 4 counts per tick at 0.02 counts per tick squared: 400 counts and 0.1024 s for each ramp.
class Moves : public StepSeries {
protected:
    [[nodiscard]] static intent::StepSeries thereAndBack(std::int32_t counts) {
        intent::StepSeries wanted{{counts, ResponseMethod::Move, 0.2}, {counts, -counts, counts, -counts}};
        wanted.each.pace = {CountsPerTick(4U << 16U), CountsPerTickSquared(1'311)};
        return wanted;
    }
};

TEST_F(Moves, GoThereAndBackAtTheirPaceAndEndWhereTheyBegan) {
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(500));
    bench.settle();
    watchSteps();
    bench.fastest = 0;
    double lowest = 500, highest = 500;
    bench.bus.onTime = [&] {
        lowest = std::min(lowest, bench.truth().commandPosition);
        highest = std::max(highest, bench.truth().commandPosition);
        bench.fastest = std::max(bench.fastest, std::abs(bench.truth().commandVelocity));
    };
    const ProcedureReport report = bench.run(thereAndBack(3'000));
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    if (report.step && (steps.empty() || steps.back() != *report.step))
        steps.push_back(*report.step);
    ASSERT_EQ(steps.size(), 4U);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].from, i % 2 == 0 ? 500 : 3'500);
        EXPECT_EQ(steps[i].goal, i % 2 == 0 ? 3'500 : 500);
        EXPECT_EQ(steps[i].round, i + 1);
        // 200 ticks to its velocity, 550 at it, 200 to rest.
        EXPECT_NEAR(steps[i].record, 950 * 512e-6 + 0.2, 1e-3);
    }
    EXPECT_EQ(lowest, 500);
    EXPECT_EQ(highest, 3'500);
    EXPECT_NEAR(bench.fastest, 4, 1e-3);
    EXPECT_TRUE(bench.truth().servoOn);
    EXPECT_EQ(bench.truth().commandPosition, 500);
    bench.bus.expectNoViolations();
}

TEST_F(Moves, AreRefusedBeforeAnythingMoves) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    EXPECT_EQ(refusal(thereAndBack(10'000)), std::nullopt) << "no step of that length is possible";
    EXPECT_EQ(refusal(thereAndBack(0)), Refusal::StepTooShort);
    // 0.2 s to its velocity and to rest, at 7812.5 counts/s; 0.2 s are recorded after it.
    EXPECT_EQ(refusal(thereAndBack(44'000)), std::nullopt);
    EXPECT_EQ(refusal(thereAndBack(45'000)), Refusal::MoveTooLong);
    intent::StepSeries wrong = thereAndBack(1'000);
    wrong.each.pace.acceleration = {};
    EXPECT_EQ(refusal(wrong), Refusal::TestOutOfRange);
    bench.module().travel.fastest = 3.9;
    EXPECT_EQ(refusal(thereAndBack(1'000)), Refusal::TooFast);
    bench.module().travel.fastest = 4.0;
    bench.module().travel.highest = 5'000;
    bench.module().home.found(0, bench.bus.now);
    EXPECT_EQ(refusal(thereAndBack(5'001)), Refusal::BeyondTravel);
    EXPECT_EQ(refusal(thereAndBack(5'000)), std::nullopt);
    EXPECT_EQ(motions(before), 0U);
}

/// The motor stands on limit switch 1 at first, which it must be able to leave.
class MovesOffASwitch : public Moves {
protected:
    void SetUp() override {
        bench.putSwitch(sim::Input::Limit1, 100, true);
        ASSERT_TRUE(hold());
        bench.module().limitStop.eachMotion = true;
        ASSERT_TRUE(bench.perform(*limitStopDue(bench.module())));
        ASSERT_FALSE(bench.module().homing.onLimit1());
    }
};

TEST_F(MovesOffASwitch, AreWatchedOnceTheyHaveLeftIt) {
    intent::StepSeries wanted = thereAndBack(600);
    wanted.counts = {600, 300, -300};
    const ProcedureReport report = bench.run(wanted);
    EXPECT_EQ(report.stage, ProcedureStage::Done);
    EXPECT_EQ(report.round, 3U);
    EXPECT_EQ(bench.truth().commandPosition, 600);
    EXPECT_TRUE(bench.module().homing.onLimit1());
    EXPECT_EQ(bench.bus.sends("AA 01 19"), 2U) << "it is armed once more, and not before each move";
    bench.bus.expectNoViolations();
}

TEST_F(MovesOffASwitch, EndWhereTheyComeBackToIt) {
    const ProcedureReport report = bench.run(thereAndBack(600));
    EXPECT_EQ(report.failure, ProcedureFailure::StoppedShort);
    EXPECT_EQ(report.round, 2U);
    EXPECT_TRUE(bench.truth().servoOn) << "it holds at the switch";
}

TEST_F(Moves, AStopEndsThemForGood) {
    for (const bool all : {true, false}) {
        ASSERT_TRUE(hold());
        bench.begin(thereAndBack(3'000));
        ASSERT_TRUE(runTo(2, ProcedureStage::Moving));
        const std::size_t before = bench.bus.sent.size();
        all ? bench.stopAll() : bench.procedure->cancel();
        EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
        bench.bus.runFor(2s);
        EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 0U) << "no move is loaded";
        EXPECT_EQ(bench.truth().commandVelocity, 0);
    }
}

TEST(StepSeriesOfAStepper, IsRefused) {
    ProcedureBench bench({{ModuleType::Stepper, 1}});
    ASSERT_TRUE(bench.connect());
    bench.settle();
    EXPECT_EQ(plan(intent::StepSeries{{50, ResponseMethod::Profile, 0.2}, {50, -50}}, bench.module()).error(),
              Refusal::NotAServo);
}

TEST(StepSeriesOfVersion1, IsRefusedWithoutStopHere) {
    ServoBench bench(1);
    ASSERT_TRUE(bench.enable());
    ASSERT_TRUE(bench.moveTo(100));
    bench.settle();
    EXPECT_EQ(
        plan(intent::StepSeries{{50, ResponseMethod::Profile, 0.2}, stepSeries(50)}, bench.module()).error(),
        Refusal::VersionLacksIt);
}

enum class Ending : std::uint8_t { Cancel, StopAll, MotorOff, AStop, AMove, PowerLost, Doubt };

class StepSeriesEnds : public StepSeries,
                       public testing::WithParamInterface<std::tuple<Ending, unsigned, ProcedureStage>> {
protected:
    [[nodiscard]] static Ending ending() { return std::get<0>(GetParam()); }
    void end() {
        const auto send = [this](ServoCommand command) {
            EXPECT_EQ(bench.bus.perform({{ModuleIndex(0), std::move(command)}}), bus::Outcome::Done);
        };
        switch (ending()) {
            case Ending::Cancel:  // Esc, or any other command from the window (Composition::carryOut)
                return bench.procedure->cancel();
            case Ending::StopAll:
                return bench.stopAll();
            case Ending::MotorOff:
                return bench.switchOff();
            case Ending::AStop:
                return send(servo::StopMotor{true, servo::StopManner::Smoothly, {}});
            case Ending::AMove:
                return send(servo::StopMotor{true, servo::StopManner::Here, Counts(30)});
            case Ending::PowerLost:
                return bench.set(sim::Input::Power, 0.0);
            case Ending::Doubt:
                return bench.procedure->onLinkSuspect();
        }
    }
};

/// Ends the series at each of its steps, under way or while the motor comes to rest: no step follows.
TEST_P(StepSeriesEnds, AndNoStepFollows) {
    const unsigned round = std::get<1>(GetParam());
    ASSERT_TRUE(hold());
    watchSteps();
    bench.begin(by(100));
    ASSERT_TRUE(runTo(round, std::get<2>(GetParam())));
    EXPECT_EQ(bench.procedure->report().rounds, 4U);
    const std::size_t before = bench.bus.sent.size();
    end();
    const ProcedureReport report = bench.goOn(5);
    const bool fails = ending() == Ending::PowerLost || ending() == Ending::Doubt;
    EXPECT_EQ(report.stage, fails ? ProcedureStage::Failed : ProcedureStage::Cancelled);
    EXPECT_EQ(report.round, round);
    EXPECT_EQ(steps.size(), round - 1) << "what was recorded before remains";
    bench.bus.runFor(1s);
    EXPECT_EQ(bench.bus.sends("AA 01 D4", before), 0U) << "no step is loaded";
    EXPECT_EQ(bench.bus.sends("AA 01 05", before), 0U) << "no step is started";
    if (ending() == Ending::AMove) {
        EXPECT_EQ(bench.truth().commandPosition, 30)
            << "the position that was requested instead is left alone";
    }
    const double command = bench.truth().commandPosition;
    bench.bus.runFor(2s);
    EXPECT_EQ(bench.truth().commandPosition, command);
    bench.bus.expectNoViolations();
}
INSTANTIATE_TEST_SUITE_P(All, StepSeriesEnds,
                         testing::Combine(testing::Values(Ending::Cancel, Ending::StopAll, Ending::MotorOff,
                                                          Ending::AStop, Ending::AMove, Ending::PowerLost,
                                                          Ending::Doubt),
                                          testing::Values(1U, 2U, 3U, 4U),
                                          testing::Values(ProcedureStage::Moving, ProcedureStage::Stopping)));

TEST_F(StepSeries, CancelledBeforeItsFirstStepSendsNothing) {
    ASSERT_TRUE(hold());
    const std::size_t before = bench.bus.sent.size();
    bench.begin(by(100));
    bench.turn();
    bench.procedure->cancel();
    EXPECT_EQ(bench.goOn(5).stage, ProcedureStage::Cancelled);
    EXPECT_EQ(motions(before), 0U);
}

/// The first two steps end before the switch, the third does not.
TEST_F(StepSeries, ALimitStopEndsItAtTheStepThatTripsIt) {
    ASSERT_TRUE(hold());
    watchSteps();
    bench.putSwitch(sim::Input::Limit2, 150.0, false);
    ASSERT_TRUE(bench.perform(intent::ArmLimitStop{false, true, HomingRecipe::Stop::Abruptly}));
    const ProcedureReport report = bench.run(by(100));
    EXPECT_EQ(report.stage, ProcedureStage::Failed);
    EXPECT_EQ(report.failure, ProcedureFailure::StoppedShort);
    EXPECT_EQ(report.round, 3U);
    EXPECT_EQ(steps.size(), 2U);
    EXPECT_TRUE(bench.truth().servoOn) << "it holds at the switch";
}

/// The gains may have changed in the meantime.
TEST_F(StepSeries, LooksAgainBeforeEachStep) {
    ASSERT_TRUE(hold());
    watchSteps();
    bench.begin(by(100));
    ASSERT_TRUE(runTo(2, ProcedureStage::Moving));
    bench.module().gains->el = 200;  // below 2 x 100 + 20 + 4
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.failure, ProcedureFailure::Refused);
    EXPECT_EQ(steps.size(), 2U);
    EXPECT_EQ(bench.truth().commandPosition, 0);
    EXPECT_TRUE(bench.truth().servoOn);
}

TEST_F(StepSeries, EndsAtAMotorThatDoesNotComeToRest) {
    ASSERT_TRUE(hold());
    bench.begin(by(100));
    ASSERT_TRUE(runTo(1, ProcedureStage::Stopping));
    std::int32_t swing = 100;
    bench.onTurn = [&](Procedure&) { bench.module().latest->position = (swing ^= 20); };
    const ProcedureReport report = bench.goOn(5);
    EXPECT_EQ(report.failure, ProcedureFailure::NotStill);
    EXPECT_EQ(report.round, 1U);
    EXPECT_TRUE(report.step) << "its record is complete";
}

}  // namespace
}  // namespace nmc::test
