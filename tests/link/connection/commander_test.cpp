// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to modules, carried out without a window.
#include "link/command/commander.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/link/connection/virtualconnection.h"
#include "tests/support/gains.h"

namespace nmc {
namespace {

using namespace testing_support;
using namespace Qt::StringLiterals;

constexpr ModuleIndex kModule{0};

class CommanderTest : public testing::Test {
protected:
    void SetUp() override {
        QObject::connect(&connection.store(), &BusStore::happened, &commander,
                         [this](const StoreEvent& event) {
                             if (commander.take(event))
                                 ++ofOthers;
                         });
        QObject::connect(&commander, &Commander::refused, &commander,
                         [this](ModuleIndex, Refusal refusal) { refusals.push_back(refusal); });
        QObject::connect(&commander, &Commander::aboutToMove, &commander,
                         [this](bus::OperationId, const std::vector<ModuleIndex>& modules) {
                             moved.insert(moved.end(), modules.begin(), modules.end());
                         });
        connection.open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        ASSERT_TRUE(connection.waitUntil([this] { return connection.module(0).latest.has_value(); }));
    }
    void TearDown() override { EXPECT_EQ(sim.violations(), ""); }

    void enable() {
        commander.carryOut(kModule, intent::ApplyGains{testing_support::kGains});
        ASSERT_TRUE(connection.waitUntil([this] { return connection.module(0).gains.has_value(); }));
        commander.carryOut(kModule, intent::Enable{});
        ASSERT_TRUE(connection.waitUntil([this] { return connection.module(0).servoOn(); }));
    }
    /// Begins a trial, and waits until other gains are in force.
    void tryOther(double seconds) {
        servo::SetGain other = kGains;
        other.kp = 250;
        commander.carryOut(kModule, intent::TryGains{other, seconds});
        ASSERT_TRUE(connection.waitUntil([this] { return connection.module(0).gains->kp == 250; }));
    }
    [[nodiscard]] int position() { return sim.state(1)[u"position"_s].toInt(); }
    [[nodiscard]] bool rests() { return !connection.module(0).moving(); }
    [[nodiscard]] static intent::MoveBy by(std::int32_t counts, unsigned rounds) {
        return {{counts, rounds, 0.0, false}, ServoPace{CountsPerTick(4 << 16), CountsPerTickSquared(1'311)}};
    }

    VirtualChain sim{u"servo"_s};
    VirtualConnection connection{sim};
    Commander commander{connection.store(), connection.worker()};
    std::vector<Refusal> refusals;
    std::vector<ModuleIndex> moved;
    int ofOthers = 0;  ///< operations whose outcome a procedure reports
};

TEST_F(CommanderTest, SendsNothingWhereAPreconditionIsNotMet) {
    commander.carryOut(kModule, intent::Enable{});
    EXPECT_EQ(refusals, std::vector{Refusal::GainsUnknown});
    commander.carryOut(kModule, by(1'000, 1));
    EXPECT_EQ(refusals.back(), Refusal::ServoOff);
    EXPECT_FALSE(commander.hold({kModule, CountsPerTick(1 << 16), CountsPerTickSquared(1'311)}));
    EXPECT_FALSE(sim.state(1)[u"servo_on"_s].toBool());
    EXPECT_TRUE(moved.empty());
}

TEST_F(CommanderTest, AnnouncesAMotionBeforeItBegins) {
    ASSERT_NO_FATAL_FAILURE(enable());
    EXPECT_TRUE(moved.empty());
    commander.carryOut(kModule, intent::Move{servomotion::Trapezoid{Counts(2'000), CountsPerTick(4 << 16),
                                                                    CountsPerTickSquared(1'311)}});
    EXPECT_EQ(moved, std::vector{kModule});
    EXPECT_EQ(position(), 0);
    EXPECT_TRUE(connection.waitUntil([this] { return std::abs(position() - 2'000) <= 4 && rests(); }));
    EXPECT_EQ(ofOthers, 0);
}

/// The bus forgets a load in both cases (faults.md M-26), so the window must not offer to start it.
TEST_F(CommanderTest, NothingIsLoadedAfterALoadOrItsStartWasRefused) {
    ASSERT_NO_FATAL_FAILURE(enable());
    const std::vector<bus::Order> loadAndStart = move(0, 2'000);
    const auto load = [&] { return connection.carryOut({loadAndStart.front()}); };
    ASSERT_EQ(load(), bus::Outcome::Done);
    EXPECT_TRUE(connection.module(0).loadWaiting);
    sim.tell("fault bus cksum on=load_trajectory n=3");
    ASSERT_EQ(load(), bus::Outcome::Refused);
    EXPECT_FALSE(connection.module(0).loadWaiting);
    EXPECT_EQ(connection.carryOut({loadAndStart.back()}), bus::Outcome::Forbidden);

    sim.tell("fault bus cksum on=start_motion n=3");
    ASSERT_EQ(connection.carryOut(loadAndStart), bus::Outcome::Refused);
    EXPECT_FALSE(connection.module(0).loadWaiting);
    EXPECT_EQ(connection.carryOut({loadAndStart.back()}), bus::Outcome::Forbidden);
    EXPECT_EQ(position(), 0);
}

TEST_F(CommanderTest, AStopWaitsForNoProcedureAndEndsIt) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, by(2'000, 50));
    EXPECT_TRUE(commander.anyRunning());
    ASSERT_TRUE(connection.waitUntil([this] { return position() > 500; }));
    commander.carryOut(kModule, intent::StopAbruptly{});
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning() && rests(); }));
    EXPECT_LT(position(), 2'000);
    EXPECT_GT(ofOthers, 0);
    const int there = position();
    ASSERT_TRUE(connection.waitUntil([this, until = connection.module(0).latestTime] {
        return connection.module(0).latestTime > until + std::chrono::seconds(1);
    }));
    EXPECT_NEAR(position(), there, 4) << "no other motion follows";
}

/// A smooth stop of the procedure that it ends would switch the servo on again.
TEST_F(CommanderTest, NothingFollowsASingleCommandThatSwitchesTheMotorOff) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, by(2'000, 50));
    commander.carryOut(
        kModule, intent::Direct{ServoCommand(servo::StopMotor{false, servo::StopManner::MotorOff, {}})});
    ASSERT_TRUE(
        connection.waitUntil([this] { return !commander.anyRunning() && !connection.module(0).servoOn(); }));
    ASSERT_TRUE(connection.waitUntil([this, until = connection.module(0).latestTime] {
        return connection.module(0).latestTime > until + std::chrono::seconds(1);
    }));
    EXPECT_FALSE(sim.state(1)[u"servo_on"_s].toBool());
    EXPECT_TRUE(refusals.empty());
}

TEST_F(CommanderTest, AnotherRequestTakesTheModuleFromItsProcedure) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, by(2'000, 50));
    ASSERT_TRUE(connection.waitUntil([this] { return position() > 500; }));
    commander.carryOut(kModule, by(-100, 1));
    EXPECT_EQ(refusals, std::vector{Refusal::Moving}) << "its motor is still being stopped";
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning() && rests(); }));
    EXPECT_LT(position(), 2'500);
}

TEST_F(CommanderTest, AMotionIsNotSentBeforeTheStopOfTheProcedureThatItTakesTheModuleFrom) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, by(2'000, 1));
    commander.carryOut(kModule, intent::Move{servomotion::Trapezoid{Counts(-500), CountsPerTick(4 << 16),
                                                                    CountsPerTickSquared(1'311)}});
    EXPECT_EQ(refusals, std::vector{Refusal::Moving}) << "its motor is about to be started, and then stopped";
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning() && rests(); }));
    EXPECT_GE(position(), 0);
    EXPECT_LT(position(), 2'000);
}

TEST_F(CommanderTest, AHoldDoesNotBeginBeforeTheStopOfTheProcedureThatItTakesTheModuleFrom) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, by(2'000, 1));
    const bus::HoldToMove hold{kModule, CountsPerTick(1 << 16), CountsPerTickSquared(1'311), true, {}, 1};
    EXPECT_FALSE(commander.hold(hold)) << "its motor is about to be started, and then stopped";
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning() && rests(); }));
    EXPECT_GE(position(), 0) << "the hold would have gone the other way";
    EXPECT_LT(position(), 2'000);
}

/// The mode begins within a trial.
TEST_F(CommanderTest, AnOperatorKeepsNoGainsOnTrial) {
    ASSERT_NO_FATAL_FAILURE(enable());
    ASSERT_NO_FATAL_FAILURE(tryOther(1.0));
    connection.store().setRights(OperatorRights{});
    commander.carryOut(kModule, intent::KeepGains{});
    EXPECT_EQ(refusals, std::vector{Refusal::OperatorMode});
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning(); }));
    EXPECT_EQ(connection.module(0).gains, kGains);
}

TEST_F(CommanderTest, AStepWithinATrialIsMadeWithTheGainsFromBefore) {
    ASSERT_NO_FATAL_FAILURE(enable());
    commander.carryOut(kModule, intent::StopHere{});  // so that the exact position that it holds is known
    ASSERT_TRUE(connection.waitUntil([this] { return connection.module(0).goal().has_value(); }));
    std::vector<ProcedureReport> reports;
    QObject::connect(&commander.procedures(), &ProcedureController::reported, &commander,
                     [&](const ProcedureReport& report) { reports.push_back(report); });
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    EXPECT_EQ(reports.back().gains, kGains);
    reports.clear();
    commander.carryOut(kModule, intent::StepResponse{100, ResponseMethod::Profile, 0.3});
    EXPECT_TRUE(refusals.empty());
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning(); }));
    const auto trial = std::ranges::find(reports, ProcedureStage::Cancelled, &ProcedureReport::stage);
    ASSERT_NE(trial, reports.end());
    EXPECT_EQ(trial->kind, ProcedureKind::TryGains);
    EXPECT_EQ(reports.back().kind, ProcedureKind::StepResponse);
    ASSERT_TRUE(reports.back().step);
    EXPECT_EQ(reports.back().step->gains, kGains) << "all of OL is back";
}

/// It would go back to the gains of the first one.
TEST_F(CommanderTest, ATrialWithinATrialIsRefused) {
    ASSERT_NO_FATAL_FAILURE(enable());
    ASSERT_NO_FATAL_FAILURE(tryOther(10.0));
    commander.carryOut(kModule, intent::TryGains{kGains, 10.0});
    EXPECT_EQ(refusals, std::vector{Refusal::Moving});
    ASSERT_TRUE(connection.waitUntil([this] { return !commander.anyRunning(); }));
    EXPECT_EQ(connection.module(0).gains, kGains);
}

TEST_F(CommanderTest, WhoeverHearsOfTheEndOfAProcedureMayBeginTheNext) {
    ASSERT_NO_FATAL_FAILURE(enable());
    std::vector<ProcedureStage> ends;
    QObject::connect(&commander.procedures(), &ProcedureController::reported, &commander,
                     [&](const ProcedureReport& report) {
                         if (!report.over())
                             return;
                         ends.push_back(report.stage);
                         if (ends.size() == 1)
                             commander.carryOut(kModule, by(300, 1));
                     });
    commander.carryOut(kModule, by(200, 1));
    ASSERT_TRUE(connection.waitUntil([&] { return ends.size() == 2; }));
    EXPECT_TRUE(refusals.empty());
    EXPECT_EQ(ends, (std::vector{ProcedureStage::Done, ProcedureStage::Done}));
    EXPECT_FALSE(commander.anyRunning());
    EXPECT_NEAR(position(), 500, 4);
}

class OutputsOfAPicIo : public testing::Test {
protected:
    void SetUp() override {
        connection.open();
        ASSERT_TRUE(connection.waitFor<bus::ChainFound>());
        ASSERT_EQ(connection.carryOut({told(io::SetDirection{0x0FF0}), told(io::SetOutput{0x0004}),
                                       told(io::SetPwm{0, 200}), told(io::SetSynchOutput{0, 0, 0})}),
                  bus::Outcome::Done);
    }
    [[nodiscard]] static bus::Order told(const IoCommand& command) { return {kModule, command}; }

    VirtualChain sim{u"io"_s};
    VirtualConnection connection{sim};
};

/// It was carried out although nobody heard the answer: what the pins read back counts from then on.
TEST_F(OutputsOfAPicIo, AreReadBackAfterACommandThatWasNotAnswered) {
    const auto isHigh = [&](unsigned pin) {
        const auto& latest = connection.module(0).latest;
        return latest && latest->pins && ((unsigned{*latest->pins} >> pin) & 1U) != 0;
    };
    ASSERT_TRUE(connection.waitUntil([&] { return isHigh(2); }));
    sim.tell("fault module 1 silent on=set_output n=3");
    ASSERT_EQ(connection.carryOut({told(io::SetOutput{0})}), bus::Outcome::NoAnswer);
    ASSERT_TRUE(connection.waitUntil([&] { return !isHigh(2); }));
    EXPECT_EQ(connection.module(0).pins.outputs, std::nullopt);
    const auto orders = plan(iointent::SetOutput{3, true}, connection.module(0));
    ASSERT_TRUE(orders.has_value());
    const auto& set = std::get<io::SetOutput>(std::get<IoCommand>(orders->front().command));
    EXPECT_EQ(set.outputs & 0x000FU, 0x0008U) << "IO3 stays off";
    EXPECT_TRUE(connection.module(0).pins.pwm) << "nothing was sent to the others";
    EXPECT_TRUE(connection.module(0).pins.stored);
}

/// The first command is repeated until it is answered, so the others are not sent before the stop.
TEST_F(OutputsOfAPicIo, AreAsBeforeWhereACommandOnlyWaitedForItsTurn) {
    sim.tell("fault module 1 silent on=set_output n=3");
    connection.forgetNews();
    connection.submit({told(io::SetOutput{0})});
    connection.submit({told(io::SetPwm{100, 0})});
    connection.submit({told(io::SetSynchOutput{0, 50, 50})});
    connection.freeze(std::chrono::milliseconds(20));
    connection.worker().stopAll();
    ASSERT_TRUE(connection.waitUntil([this] { return connection.count<bus::OperationFinished>() == 3; }));
    connection.forEach<bus::OperationFinished>(
        [](const bus::OperationFinished& finished) { EXPECT_EQ(finished.outcome, bus::Outcome::Cancelled); });
    EXPECT_EQ(connection.module(0).pins.outputs, std::nullopt) << "this one was sent";
    EXPECT_EQ(connection.module(0).pins.pwm, (std::array<std::uint8_t, 2>{0, 200}));
    EXPECT_EQ(connection.module(0).pins.stored, (io::SetSynchOutput{0, 0, 0}));
}

}  // namespace
}  // namespace nmc
