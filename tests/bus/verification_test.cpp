// SPDX-License-Identifier: GPL-3.0-or-later
// link.md 2.3: what a query of the module shows about a command that was not answered.
#include "bus/verification.h"

#include <gtest/gtest.h>

#include "module/commandfacts.h"
#include "tests/bus/replies.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// A command that was not answered, and the query after it.
class Lost {
public:
    explicit Lost(ServoCommand command, std::int32_t position = 1'000, std::int32_t home = 50)
        : m_order(toServo(0, std::move(command))) {
        m_before.position = position;
        m_before.home = home;
        status(m_before);
        m_verification.position = m_belief.position();
        m_belief.onSent(m_order.command, m_now += 10ms);
    }
    /// The module has refused the command with the communication-error bit.
    Lost& refused() {
        m_verification.end.result = ReplyResult::Refused;
        return *this;
    }
    /// The motor moved before the command.
    Lost& inMotion() {
        m_verification.stood = false;
        return *this;
    }
    Lost& noPositionBefore() {
        m_verification.position.reset();
        return *this;
    }
    [[nodiscard]] Carried looksLike(const ServoState& state) {
        status(state);
        return verify(m_order, m_belief, m_verification);
    }
    /// The verdict for a status that differs from the one before by `change`.
    [[nodiscard]] Carried looksLike(auto change) {
        ServoState state = m_before;
        change(state);
        return looksLike(state);
    }

private:
    void status(const ServoState& state) {
        const auto bytes = bytesOf(state, kLong);
        m_now += 10ms;
        m_belief.onStatus(accepted(ModuleType::Servo, kLong, bytes, m_now).report, m_now);
    }

    Belief m_belief{{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}};
    TimePoint m_now{};
    Order m_order;
    ServoState m_before;
    Verification m_verification;
};

constexpr auto asItWas = [](ServoState&) {};
constexpr auto moves = [](ServoState& s) { s.status = 0x08; };
[[nodiscard]] auto at(std::int32_t position) {
    return [position](ServoState& s) { s.position = position; };
}
[[nodiscard]] auto homeAt(std::int32_t home) {
    return [home](ServoState& s) { s.home = home; };
}

[[nodiscard]] bool leavesEvidence(const ModuleCommand& command) {
    return factsOf(command).evidence != Evidence::None;
}

TEST(Verification, CanTellForFourCommandsOnly) {
    EXPECT_TRUE(leavesEvidence(ServoCommand(StartMotion{})));
    EXPECT_TRUE(leavesEvidence(ServoCommand(ResetPosition{})));
    EXPECT_TRUE(leavesEvidence(ServoCommand(SaveAsHome{})));
    EXPECT_TRUE(leavesEvidence(ServoCommand(servo::ClearStickyBits{})));
    EXPECT_TRUE(leavesEvidence(StepperCommand(StartMotion{})));
    EXPECT_FALSE(leavesEvidence(loadMove(0, 5).command));
    EXPECT_FALSE(leavesEvidence(loadVelocity(0, 65'536, true).command))
        << "the velocity cannot be distinguished from the one before";
    EXPECT_FALSE(leavesEvidence(gains(0).command));
    EXPECT_FALSE(leavesEvidence(enable(0).command));
    EXPECT_FALSE(leavesEvidence(ServoCommand(servo::SetHoming{})));
    EXPECT_FALSE(leavesEvidence(ServoCommand(servo::IoControl{})));
    EXPECT_FALSE(leavesEvidence(ServoCommand(Nop{})));
    EXPECT_FALSE(leavesEvidence(StepperCommand(stepper::SetParameters{})));
}

TEST(Verification, TakesAMotorThatMovesForStarted) {
    EXPECT_EQ(Lost(StartMotion{}).looksLike(moves), Carried::Out);
    EXPECT_EQ(Lost(StartMotion{}).looksLike(at(1'500)), Carried::Out) << "it has already reached its goal";
    EXPECT_EQ(Lost(StartMotion{}).refused().looksLike(moves), Carried::Out) << "whatever the module answered";
}

TEST(Verification, TakesAMotionFromBeforeForNoSignOfAStart) {
    EXPECT_EQ(Lost(StartMotion{}).inMotion().looksLike(moves), Carried::Unknown);
    EXPECT_EQ(Lost(StartMotion{}).inMotion().looksLike(at(1'500)), Carried::Unknown);
    EXPECT_EQ(Lost(StartMotion{}).inMotion().refused().looksLike(moves), Carried::NotOut);
}

TEST(Verification, NeverCallsAStartNotDoneBySilenceAlone) {
    EXPECT_EQ(Lost(StartMotion{}).looksLike(asItWas), Carried::Unknown) << "it may be a move of length 0";
    EXPECT_EQ(Lost(StartMotion{}).looksLike(at(1'003)), Carried::Unknown)
        << "a servo moves within its friction";
    EXPECT_EQ(Lost(StartMotion{}).refused().looksLike(asItWas), Carried::NotOut);
}

TEST(Verification, TakesAMotorThatStandsForNoRunThatWasStarted) {
    servo::LoadTrajectory pwm;
    pwm.servo = false;
    pwm.pwm = std::uint8_t{60};
    for (const Order& load : {loadVelocity(0, 65'536), toServo(0, pwm)}) {
        Belief belief{{ModuleIndex(0), BusAddress(1), {ModuleType::Servo, 4}}};
        TimePoint now{};
        const auto look = [&](const ServoState& state) {
            now += 10ms;
            belief.onStatus(accepted(ModuleType::Servo, kLong, bytesOf(state, kLong), now).report, now);
        };
        const ServoState rests{};
        look(rests);
        belief.onSent(load.command, now += 10ms);
        belief.onExecuted(load.command);
        Verification verification;
        verification.position = belief.position();
        belief.onSent(start(0).command, now += 10ms);
        look(rests);
        EXPECT_EQ(verify(start(0), belief, verification), Carried::Unknown);
        ServoState runs;
        runs.velocity = 1;
        look(runs);
        EXPECT_EQ(verify(start(0), belief, verification), Carried::Out);
    }
}

TEST(Verification, TellsAResetPositionByThePosition) {
    EXPECT_EQ(Lost(ResetPosition{}).looksLike(at(0)), Carried::Out);
    EXPECT_EQ(Lost(ResetPosition{}).looksLike(at(-3)), Carried::Out);
    EXPECT_EQ(Lost(ResetPosition{}).looksLike(asItWas), Carried::NotOut);
    EXPECT_EQ(Lost(ResetPosition{}).looksLike(at(500)), Carried::Unknown) << "it matches neither case";
    EXPECT_EQ(Lost(ResetPosition{}).looksLike(moves), Carried::Unknown);
    EXPECT_EQ(Lost(ResetPosition{}).noPositionBefore().looksLike(at(0)), Carried::Unknown);
}

TEST(Verification, RepeatsAResetPositionNearZeroSinceThatDoesNoHarm) {
    EXPECT_EQ(Lost(ResetPosition{}, 3).looksLike(at(3)), Carried::NotOut);
    EXPECT_EQ(Lost(ResetPosition{}, 3).looksLike(at(0)), Carried::NotOut);
}

TEST(Verification, TellsASavedHomeByTheHomeRegister) {
    EXPECT_EQ(Lost(SaveAsHome{}).looksLike(homeAt(1'000)), Carried::Out);
    EXPECT_EQ(Lost(SaveAsHome{}).looksLike(homeAt(998)), Carried::Out);
    EXPECT_EQ(Lost(SaveAsHome{}).looksLike(asItWas), Carried::NotOut);
    EXPECT_EQ(Lost(SaveAsHome{}).looksLike(moves), Carried::Unknown) << "home is somewhere on its way";
}

TEST(Verification, TellsClearedBitsByTheBits) {
    EXPECT_EQ(Lost(servo::ClearStickyBits{}).looksLike(asItWas), Carried::Out);
    for (const std::uint8_t status : std::initializer_list<std::uint8_t>{0x0D, 0x19}) {
        const auto sticky = [&](ServoState& s) { s.status = status; };
        EXPECT_EQ(Lost(servo::ClearStickyBits{}).looksLike(sticky), Carried::NotOut);
    }
    for (const std::uint8_t aux : std::initializer_list<std::uint8_t>{0x06, 0x24}) {
        const auto sticky = [&](ServoState& s) { s.aux = aux; };
        EXPECT_EQ(Lost(servo::ClearStickyBits{}).looksLike(sticky), Carried::NotOut);
    }
    const auto off = [](ServoState& s) {
        s.status = 0x19;
        s.aux = 0x00;
    };
    EXPECT_EQ(Lost(servo::ClearStickyBits{}).looksLike(off), Carried::Out)
        << "pos_error of a servo that is off comes back at once";
}

}  // namespace

}  // namespace nmc::test
