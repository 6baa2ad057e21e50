// SPDX-License-Identifier: GPL-3.0-or-later
// What all procedures have in common, shown by one that does nothing else.
#include "model/procedure/procedure.h"

#include <gtest/gtest.h>

#include <tuple>

namespace nmc {
namespace {

constexpr TimePoint kNow{std::chrono::seconds(1)};

/// Sends a start, and is done when it has been answered.
class StartOnly : public Procedure {
public:
    StartOnly() : Procedure(ModuleIndex(3), ProcedureKind::MoveBy) {}
    using Procedure::fail;

    int asked = 0;
    int afterwards = 0;  ///< turns that it takes after lastWord()

private:
    Next proceed(const ModuleState&, TimePoint) override {
        if (++asked > 1)
            return finish();
        m_report.stage = ProcedureStage::Moving;
        m_mayRun = true;
        return send({{ModuleIndex(3), ServoCommand(StartMotion{})}});
    }
    std::vector<bus::Order> lastWord(const ModuleState&) const override {
        if (!m_mayRun)
            return {};
        return {{ModuleIndex(3), ServoCommand(servo::StopMotor{true, servo::StopManner::Smoothly, {}})}};
    }
    Next afterLastWord(const ModuleState&, TimePoint) override {
        return m_mayRun && afterwards-- > 0 ? Next(Wait{}) : End{};
    }
};

class AProcedure : public testing::Test {
protected:
    enum class Is { Wait, Start, Stop, End };
    Is next() {
        const Procedure::Next next = procedure.next(module, kNow);
        if (const auto* send = std::get_if<Procedure::Send>(&next)) {
            EXPECT_EQ(send->orders.size(), 1U);
            const auto& command = std::get<ServoCommand>(send->orders.at(0).command);
            return std::holds_alternative<StartMotion>(command) ? Is::Start : Is::Stop;
        }
        return std::holds_alternative<Procedure::Wait>(next) ? Is::Wait : Is::End;
    }
    ProcedureStage stage() { return procedure.report().stage; }

    StartOnly procedure;
    ModuleState module;
};

TEST_F(AProcedure, HasOneOperationInFlightAtATime) {
    EXPECT_EQ(procedure.report().module, ModuleIndex(3));
    EXPECT_EQ(procedure.report().kind, ProcedureKind::MoveBy);
    EXPECT_EQ(next(), Is::Start);
    EXPECT_EQ(next(), Is::Wait);
    EXPECT_EQ(procedure.asked, 1);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Done);
    EXPECT_EQ(next(), Is::End);
}

TEST_F(AProcedure, StopsWhatItHasStartedBeforeItHasFailed) {
    for (const auto outcome : {bus::Outcome::Refused, bus::Outcome::NoAnswer, bus::Outcome::Forbidden}) {
        StartOnly one;
        ASSERT_TRUE(std::holds_alternative<Procedure::Send>(one.next(module, kNow)));
        one.onFinished(outcome);
        ASSERT_TRUE(std::holds_alternative<Procedure::Send>(one.next(module, kNow))) << "it may have started";
        EXPECT_EQ(one.report().stage, ProcedureStage::Stopping);
        EXPECT_TRUE(std::holds_alternative<Procedure::Wait>(one.next(module, kNow)));
        one.onFinished(outcome);
        EXPECT_TRUE(std::holds_alternative<Procedure::End>(one.next(module, kNow)))
            << "the stop is sent only once";
        EXPECT_EQ(one.report().stage, ProcedureStage::Failed);
        EXPECT_EQ(one.report().failure, ProcedureFailure::Refused);
    }
}

TEST_F(AProcedure, ThatIsCancelledStopsWhatItHasStarted) {
    EXPECT_EQ(next(), Is::Start);
    procedure.cancel();
    EXPECT_EQ(next(), Is::Wait) << "it waits for its operation";
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::Stop);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Cancelled);
    EXPECT_EQ(procedure.asked, 1) << "nothing new was begun";
}

TEST_F(AProcedure, ThatHasStartedNothingHasNothingToStop) {
    procedure.cancel();
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Cancelled);
}

TEST_F(AProcedure, SendsNothingBehindSomebodyElsesStop) {
    EXPECT_EQ(next(), Is::Start);
    procedure.onFinished(bus::Outcome::Cancelled);
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Cancelled);
}

/// Nothing has stopped the motor, and a stop that found the queue full was not sent.
TEST_F(AProcedure, StopsWhatItHasStartedOnceTheQueueTakesIt) {
    EXPECT_EQ(next(), Is::Start);
    procedure.onFinished(bus::Outcome::QueueFull);
    EXPECT_EQ(next(), Is::Stop);
    procedure.onFinished(bus::Outcome::QueueFull);
    EXPECT_EQ(next(), Is::Stop);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Failed);
    EXPECT_EQ(procedure.report().failure, ProcedureFailure::Refused);
}

TEST_F(AProcedure, EndsForTheFirstReason) {
    EXPECT_EQ(next(), Is::Start);
    procedure.onLinkSuspect();
    std::ignore = procedure.fail(ProcedureFailure::TimeLimit);
    procedure.cancel();
    procedure.onFinished(bus::Outcome::NoAnswer);
    EXPECT_EQ(next(), Is::Stop);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Failed);
    EXPECT_EQ(procedure.report().failure, ProcedureFailure::LinkSuspect);
}

TEST_F(AProcedure, IsNotUndoneByWhatComesBehindItsEnd) {
    EXPECT_EQ(next(), Is::Start);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::End);
    procedure.onLinkSuspect();
    procedure.cancel();
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Done);
    EXPECT_FALSE(procedure.report().failure.has_value());
}

TEST_F(AProcedure, TakesItsTimeBehindTheLastWordUntilSomethingElseIsWanted) {
    procedure.afterwards = 5;
    EXPECT_EQ(next(), Is::Start);
    procedure.onLinkSuspect();
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::Stop);
    procedure.onFinished(bus::Outcome::Done);
    EXPECT_EQ(next(), Is::Wait);
    EXPECT_EQ(stage(), ProcedureStage::Stopping) << "it has not ended yet";
    procedure.cancel();
    EXPECT_EQ(next(), Is::End);
    EXPECT_EQ(stage(), ProcedureStage::Failed);
}

}  // namespace
}  // namespace nmc
