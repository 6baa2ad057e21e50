// SPDX-License-Identifier: GPL-3.0-or-later
// Every rule of link.md 2.4, with a reply that breaks it and a similar one that must be believed.
#include "bus/plausibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/bus/replies.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using namespace std::chrono_literals;

/// One module that is queried every ten milliseconds.
template <typename State, ModuleType kType>
class Asked {
public:
    explicit Asked(std::uint8_t version) : plausibility({kType, version}) {}

    [[nodiscard]] std::optional<Rejection> says(const State& said, std::uint8_t items = kLong,
                                                Duration after = 10ms) {
        now += after;
        return plausibility.check(accepted(kType, items, bytesOf(said, items), now));
    }
    /// Passes a few plausible replies.
    void settle(const State& said) {
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(says(said, i == 0 || i % 2 != 0 ? kLong : kShort), std::nullopt);
    }
    void sends(const ModuleCommand& command) {
        if (const auto* own = std::get_if<ServoCommand>(&command))
            sent.apply(*own, kFirstServo);
        plausibility.onSent(command, sent, now + 5ms);
    }

    Plausibility plausibility;
    ServoRegisters sent;
    TimePoint now{};
};

class Servo : public Asked<ServoState, ModuleType::Servo> {
public:
    explicit Servo(const ServoState& first = {}) : Asked(4) { settle(first); }
};

class Stepper : public Asked<StepperState, ModuleType::Stepper> {
public:
    explicit Stepper(const StepperState& first = {}) : Asked(1) { settle(first); }
};

TEST(Plausibility, TellsOnceOfACounterThatSomebodyElseHasSet) {
    Servo servo({.position = 50'000});
    EXPECT_EQ(servo.says({.position = 0}), Rejection::PositionJump);
    EXPECT_FALSE(servo.plausibility.takeJump()) << "it may be a garbled reply";
    EXPECT_EQ(servo.says({.position = 0}, kShort), std::nullopt);
    EXPECT_TRUE(servo.plausibility.takeJump());
    EXPECT_FALSE(servo.plausibility.takeJump());
    // A change by this host is not reported.
    Servo ours({.position = 50'000});
    ours.sends(ServoCommand(ResetPosition{}));
    EXPECT_EQ(ours.says({.position = 0}), std::nullopt);
    EXPECT_FALSE(ours.plausibility.takeJump());
}

TEST(Plausibility, RejectsALineThatIsHeldLowOrHigh) {
    Servo servo;
    const std::vector<std::uint8_t> low(10, 0x00);
    EXPECT_EQ(servo.plausibility.check(accepted(ModuleType::Servo, kShort, low, servo.now + 10ms)),
              Rejection::Uniform);
    // The sum of FF FF is FE: only a reply of status byte and sum can be all FF with a correct sum.
    const std::vector<std::uint8_t> high(2, 0xFF);
    EXPECT_EQ(servo.plausibility.check(accepted(ModuleType::Servo, 0, high, servo.now + 20ms)),
              Rejection::Uniform);
    // A servo that runs without an active limit, with all position bits 0, is not such a line.
    Plausibility fresh({ModuleType::Servo, 4});
    const auto bytes = bytesOf(ServoState{.status = 0x08}, kShort);
    EXPECT_FALSE(fresh.check(accepted(ModuleType::Servo, kShort, bytes, {})));
}

TEST(Plausibility, BelievesTheZerosOfAStepperThatHasNothingElseToTell) {
    const std::vector<std::uint8_t> zeros(10, 0x00);
    const auto says = [&](Stepper& stepper) {
        return stepper.plausibility.check(accepted(ModuleType::Stepper, kShort, zeros, stepper.now + 10ms));
    };
    Stepper resting({.status = 0x00, .analog = 0});
    EXPECT_EQ(says(resting), std::nullopt) << "it reported the same before, with its type";
    Stepper powered({.status = 0x08, .analog = 0});
    EXPECT_EQ(says(powered), Rejection::Uniform);
    Stepper elsewhere({.status = 0x00, .position = 5, .analog = 0});
    EXPECT_EQ(says(elsewhere), Rejection::Uniform);
    Plausibility fresh({ModuleType::Stepper, 1});
    EXPECT_EQ(fresh.check(accepted(ModuleType::Stepper, kShort, zeros, {})), Rejection::Uniform);
}

TEST(Plausibility, RejectsAnotherTypeOrVersion) {
    Servo servo;
    EXPECT_EQ(servo.says({.version = 5}), Rejection::Identity);
    EXPECT_EQ(servo.says({.type = 2}), Rejection::Identity);
    EXPECT_EQ(servo.says({.version = 5}, kShort), std::nullopt) << "the reply does not contain the version";
}

TEST(Plausibility, RejectsUndefinedBitsOtherThanAtFirst) {
    Servo servo;
    EXPECT_EQ(servo.says({.aux = 0x44}), Rejection::UndefinedBits);
    EXPECT_EQ(servo.says({.aux = 0x05}), std::nullopt) << "the index is defined";
    Servo odd({.aux = 0xC4});
    EXPECT_EQ(odd.says({.aux = 0xC5}), std::nullopt) << "this chip has always set these bits";
    EXPECT_EQ(odd.says({.aux = 0x84}), Rejection::UndefinedBits);
    Stepper stepper;
    EXPECT_EQ(stepper.says({.inputs = 0x80}), Rejection::UndefinedBits);
    EXPECT_EQ(stepper.says({.inputs = 0x3F}), std::nullopt);
}

TEST(Plausibility, RejectsAServoThatIsOffWithoutTheBitsThatGoWithIt) {
    for (const std::uint8_t status : std::initializer_list<std::uint8_t>{0x08, 0x09, 0x18}) {
        Servo servo;
        EXPECT_EQ(servo.says({.status = status, .aux = 0x00}), Rejection::OffWithoutBits);
    }
    Servo servo;
    EXPECT_EQ(servo.says({.status = 0x19, .aux = 0x00}), std::nullopt);
}

TEST(Plausibility, RejectsAServoThatIsOnWithoutPower) {
    Servo servo;
    EXPECT_EQ(servo.says({.status = 0x01, .aux = 0x04}), Rejection::OnWithoutPower);
    EXPECT_EQ(servo.says({.status = 0x11, .aux = 0x00}), std::nullopt) << "power lost: the servo is off";
}

TEST(Plausibility, BelievesTheAnswerOfAServoThatIsSwitchedOnWithoutPower) {
    Servo servo({.status = 0x11, .aux = 0x00});
    servo.sends(enable(0).command);
    EXPECT_EQ(servo.says({.status = 0x11, .aux = 0x04}, kShort, 5ms), std::nullopt);
    EXPECT_EQ(servo.says({.status = 0x11, .aux = 0x04}), Rejection::OnWithoutPower)
        << "too long after the command";
}

TEST(Plausibility, RejectsSlewDoneWithoutAccelDone) {
    Servo servo;
    EXPECT_EQ(servo.says({.aux = 0x14}), Rejection::SlewWithoutAccel);
    EXPECT_EQ(servo.says({.aux = 0x1C}), std::nullopt);
    EXPECT_EQ(servo.says({.aux = 0x0C}), std::nullopt);
}

TEST(Plausibility, RejectsAStickyBitThatWentAwayByItself) {
    const ServoState stuck{.status = 0x1D, .aux = 0x26};  // overcurrent, pos_error; overrun, wrap
    for (const auto& [status, aux] : {std::pair{0x19, 0x26}, {0x0D, 0x26}, {0x1D, 0x06}, {0x1D, 0x24}}) {
        const ServoState cleared{.status = static_cast<std::uint8_t>(status),
                                 .aux = static_cast<std::uint8_t>(aux)};
        Servo servo(stuck);
        EXPECT_EQ(servo.says(cleared), Rejection::StickyCleared);
        Servo told(stuck);
        told.sends(ServoCommand(servo::ClearStickyBits{}));
        EXPECT_EQ(told.says(cleared), std::nullopt);
    }
    Servo limit({.status = 0x69});
    EXPECT_EQ(limit.says({.status = 0x09}), std::nullopt) << "limits come and go";
}

TEST(Plausibility, RejectsHomingThatNobodyAskedFor) {
    Servo servo;
    EXPECT_EQ(servo.says({.status = 0x89}), Rejection::HomingRose);
    Servo told;
    told.sends(ServoCommand(servo::SetHoming{.onIndexChange = true}));
    EXPECT_EQ(told.says({.status = 0x89}), std::nullopt);
    EXPECT_EQ(told.says({.status = 0x09}), std::nullopt) << "homing may end at any time";
    Stepper stepper;
    EXPECT_EQ(stepper.says({.status = 0x8C}), Rejection::HomingRose);
    Stepper home;
    home.sends(StepperCommand(stepper::SetHoming{.onHomeSwitchChange = true}));
    EXPECT_EQ(home.says({.status = 0x8C}), std::nullopt);
}

TEST(Plausibility, RejectsAnotherHomeWithoutACause) {
    Servo servo;
    EXPECT_EQ(servo.says({.home = 64}), Rejection::HomeChanged);
    Servo saved;
    saved.sends(ServoCommand(SaveAsHome{}));
    EXPECT_EQ(saved.says({.home = 64}), std::nullopt);
    // Home is captured long after it was requested.
    Servo homing;
    homing.sends(ServoCommand(servo::SetHoming{.onLimit1Change = true}));
    for (int i = 0; i < 50; ++i)
        ASSERT_EQ(homing.says({.status = 0x89}), std::nullopt);
    EXPECT_EQ(homing.says({.status = 0x29, .home = 1'234}), std::nullopt);
    EXPECT_EQ(homing.says({.status = 0x29, .home = 1'234}), std::nullopt);
    EXPECT_EQ(homing.says({.status = 0x29, .home = 1'234}, kShort), std::nullopt);
    for (int i = 0; i < 4; ++i)
        ASSERT_EQ(homing.says({.status = 0x29, .home = 1'234}), std::nullopt);
    EXPECT_EQ(homing.says({.status = 0x29, .home = 1'235}), Rejection::HomeChanged);
}

/// 10 ms are 19.5 ticks.
TEST(Plausibility, RejectsAPositionThatTheVelocityDoesNotReach) {
    Servo standing({.position = 1'000});
    EXPECT_EQ(standing.says({.position = 1'000 + 1'024}), Rejection::PositionJump);
    EXPECT_EQ(standing.says({.position = 1'008}), std::nullopt) << "it may yield a little";
    Servo moving;
    moving.sends(loadVelocity(0, 20 * 65'536, true).command);
    for (int i = 1; i <= 100; ++i)
        ASSERT_EQ(moving.says({.status = 0x08, .position = i * 195, .velocity = 10}), std::nullopt);
    EXPECT_EQ(moving.says({.position = 101 * 195 + 1'024, .velocity = 10}), Rejection::PositionJump);
    EXPECT_EQ(moving.says({.position = 99 * 195, .velocity = 10}, kShort), Rejection::PositionJump)
        << "it does not go back either";
}

/// A chain of modules of one type, which only their positions distinguish: a reply of the neighbour, which is
/// elsewhere or runs, is not believed at once for a motor that is at rest.
TEST(Plausibility, RejectsAnotherModulesPositionForAMotorThatStands) {
    constexpr std::uint8_t kOff = 0x19;  // move_done, power, pos_error
    for (const bool on : {true, false}) {
        SCOPED_TRACE(on);
        const auto says = [on](std::int32_t position, std::int16_t velocity = 0) {
            return ServoState{.status = on ? std::uint8_t{0x09} : kOff,
                              .position = position,
                              .velocity = velocity,
                              .aux = on ? std::uint8_t{0x04} : std::uint8_t{0x00}};
        };
        for (const std::int16_t velocity : {std::int16_t{0}, std::int16_t{50}})
            for (const std::int32_t other : {2'000, 3'386, 8'951, -8'951}) {
                Servo servo(says(0));
                EXPECT_EQ(servo.says(says(other, velocity), kLong, 250ms).has_value(), true) << other;
                EXPECT_EQ(servo.says(says(0), kShort, 250ms), std::nullopt) << "its own reply";
            }
        // A shaft that is turned a little by hand, or slowly: 0.9 counts a tick are reported as 0.
        Servo turned(says(0));
        EXPECT_EQ(turned.says(says(400), kLong, 250ms), std::nullopt);
        Servo slow(says(0));
        EXPECT_EQ(slow.says(says(440), kLong, 250ms), std::nullopt) << "0.9 x 488 ticks";
    }
}

/// Another program starts it: the next reply confirms this, and the counter has not been set.
TEST(Plausibility, TakesAMotionThatSomebodyElseBeganForNoJump) {
    Servo servo;
    EXPECT_EQ(servo.says({.status = 0x08, .position = 2'000, .velocity = 8, .aux = 0x0C}, kLong, 250ms),
              Rejection::PositionJump);
    EXPECT_EQ(servo.says({.status = 0x08, .position = 2'150, .velocity = 8, .aux = 0x0C}, kShort),
              std::nullopt);
    EXPECT_FALSE(servo.plausibility.takeJump());
}

/// The servo would have switched off before it reached this position.
TEST(Plausibility, RejectsAHoldingServoBeyondItsErrorLimit) {
    const ModuleCommand limit =
        ServoCommand(servo::SetGain{200, 2000, 20, 200, 255, 0, 100, 1, std::uint8_t{0}});
    Servo servo;
    servo.sends(limit);
    servo.plausibility.onAnswered(limit);
    servo.sends(enable(0).command);
    for (int i = 0; i < 60; ++i)
        EXPECT_EQ(servo.says({}, i % 2 == 0 ? kLong : kShort), std::nullopt);
    EXPECT_EQ(servo.says({.position = 190}, kLong, 250ms), std::nullopt)
        << "from one end of its error to the other";
    Servo other;
    other.sends(limit);
    other.plausibility.onAnswered(limit);
    other.sends(enable(0).command);
    for (int i = 0; i < 60; ++i)
        EXPECT_EQ(other.says({}, i % 2 == 0 ? kLong : kShort), std::nullopt);
    EXPECT_EQ(other.says({.position = 300}, kLong, 250ms), Rejection::PositionJump);
    Servo unknown;
    unknown.sends(limit);  // not answered: the one from before may still apply
    unknown.sends(enable(0).command);
    for (int i = 0; i < 60; ++i)
        EXPECT_EQ(unknown.says({}, i % 2 == 0 ? kLong : kShort), std::nullopt);
    EXPECT_EQ(unknown.says({.position = 300}, kLong, 250ms), std::nullopt);
}

/// After a command, it may go as far as the command allows, however long it was not queried.
TEST(Plausibility, BelievesAMotorThatWasStartedAndNotAskedForLong) {
    Servo servo;
    servo.sends(loadMove(0, 200'000).command);
    servo.sends(start(0).command);
    EXPECT_EQ(servo.says({.status = 0x08, .position = 0}), std::nullopt) << "it has hardly begun";
    // 0.01 counts per tick squared for 1 s, up to 2 counts per tick: 200 ticks of ramp and 1753 at speed.
    EXPECT_EQ(servo.says({.status = 0x08, .position = 3'700, .velocity = 2, .aux = 0x0C}, kLong, 1s),
              std::nullopt);
}

TEST(Plausibility, BelievesAServoThatSwingsAsFastAsItIsAsked) {
    Servo servo;
    servo.sends(gains(0).command);
    const double amplitude = 300;
    for (int i = 0; i < 300; ++i) {
        // 35 ticks between queries and 37 in a period, 17.9 ms and 18.9 ms: nearly the same velocity each
        // time, wherever it is by then.
        const double angle = 2 * 3.14159265 * 35 / 37 * i;
        const double speed = amplitude * 2 * 3.14159265 / 37;
        const ServoState state{.status = 0x08,
                               .position = static_cast<std::int32_t>(amplitude * std::sin(angle)),
                               .velocity = static_cast<std::int16_t>(speed * std::cos(angle))};
        ASSERT_EQ(servo.says(state, i % 2 == 0 ? kLong : kShort, 35 * kServoTick), std::nullopt) << i;
    }
}

/// In focus, every second reply contains only the position: the known velocity is that of the reply before.
TEST(Plausibility, BelievesAMotorThatComesToRestBehindABriefReply) {
    Servo servo;
    servo.sends(loadVelocity(0, 40 * 65'536, true).command);
    const auto says = [&](std::int32_t position, std::int16_t velocity, std::uint8_t items) {
        return servo.says({.status = 0x08, .position = position, .velocity = velocity}, items,
                          5 * kServoTick / 2);
    };
    std::int32_t position = 0;
    for (int i = 0; i < 1'000; ++i)
        ASSERT_EQ(says(position += 100, 40, i % 2 == 0 ? kShort : kBrief), std::nullopt) << i;
    EXPECT_EQ(says(position + 60, 0, kShort), std::nullopt);
    EXPECT_EQ(says(position + 60 + 400, 0, kBrief), Rejection::PositionJump);
}

TEST(Plausibility, BelievesAPositionThatWrapsAtThirtyTwoBits) {
    Servo servo({.position = INT32_MAX - 2});
    EXPECT_EQ(servo.says({.position = INT32_MIN + 2, .aux = 0x06}), std::nullopt);
}

TEST(Plausibility, BelievesAPositionThatWasReset) {
    Servo servo({.position = 100'000});
    EXPECT_EQ(servo.says({.position = 0}), Rejection::PositionJump);
    Servo told({.position = 100'000});
    told.sends(ServoCommand(ResetPosition{}));
    EXPECT_EQ(told.says({.position = 0}), std::nullopt);
    Servo other({.position = 100'000});
    other.sends(ServoCommand(ResetPosition{}));
    EXPECT_EQ(other.says({.position = 50'000}), Rejection::PositionJump) << "it is not anywhere else either";
}

TEST(Plausibility, BelievesACounterThatWasSetToAValue) {
    Servo servo({.position = 500, .home = 200});
    servo.sends(ServoCommand(servo::SetPosition{Counts(100'000)}));
    EXPECT_EQ(servo.says({.position = 0, .home = 200}), Rejection::PositionJump)
        << "this one sets it elsewhere";
    EXPECT_EQ(servo.says({.position = 100'000, .home = 200}), std::nullopt);
    // 100 000 minus home; what the other resets would give is as implausible as before.
    servo.sends(ServoCommand(servo::ResetRelativeToHome{}));
    EXPECT_EQ(servo.says({.position = 0, .home = 200}), Rejection::PositionJump);
    EXPECT_EQ(servo.says({.position = 99'800, .home = 200}), std::nullopt);
    EXPECT_FALSE(servo.plausibility.takeJump());
    // Home has just been saved, and no reply has shown where.
    Servo unread({.position = 50'000});
    unread.sends(ServoCommand(SaveAsHome{}));
    unread.sends(ServoCommand(servo::ResetRelativeToHome{}));
    EXPECT_EQ(unread.says({.position = 0, .home = 50'000}), std::nullopt);
}

TEST(Plausibility, RejectsAVelocityThatNoMotorReaches) {
    Servo servo;
    EXPECT_EQ(servo.says({.velocity = 257}), Rejection::VelocityJump) << "500 000 edges a second";
    EXPECT_EQ(servo.says({.velocity = 128}), Rejection::VelocityJump);
    EXPECT_EQ(servo.says({.position = 20, .velocity = 2}), std::nullopt);
    // A start without acceleration limit brings a small motor to its speed at once.
    Servo thrown;
    thrown.sends(loadVelocity(0, 20 * 65'536, true).command);
    EXPECT_EQ(thrown.says({.status = 0x08, .position = 195, .velocity = 20}), std::nullopt);
}

/// 100 counts a tick are 1 000 in ten ticks (DS-V 5.2, Set Gain); 10 ms are 19.5 ticks.
TEST(Plausibility, BelievesVelocitiesOfTheOldServoRateUntilTheNewOneIsAnswered) {
    const auto gainsAt = [](std::uint8_t sr) {
        return ModuleCommand(
            ServoCommand(servo::SetGain{200, 2000, 20, 200, 255, 0, 100, sr, std::uint8_t{0}}));
    };
    Servo servo;
    servo.sends(gainsAt(10));
    servo.plausibility.onAnswered(gainsAt(10));
    servo.sends(loadVelocity(0, 100 * 65'536, true).command);
    EXPECT_EQ(servo.says({.status = 0x08, .position = 1'953, .velocity = 1'000}), std::nullopt);
    servo.sends(gainsAt(1));
    EXPECT_EQ(servo.says({.status = 0x08, .position = 3'906, .velocity = 1'000}), std::nullopt);
    servo.plausibility.onAnswered(gainsAt(1));
    EXPECT_EQ(servo.says({.status = 0x08, .position = 5'859, .velocity = 1'000}), Rejection::VelocityJump)
        << "no motor reaches 1 000 counts a tick";
}

/// The error limit is lowered from 1 000 to 100, and the answer is lost.
TEST(Plausibility, BelievesAHoldingServoWithinItsOldErrorLimitUntilTheNewOneIsAnswered) {
    const auto gainsOf = [](std::uint16_t el) {
        return ModuleCommand(
            ServoCommand(servo::SetGain{200, 2000, 20, 200, 255, 0, el, 1, std::uint8_t{0}}));
    };
    Servo servo;
    servo.sends(gainsOf(1'000));
    servo.plausibility.onAnswered(gainsOf(1'000));
    servo.sends(enable(0).command);
    servo.sends(gainsOf(100));
    for (int i = 0; i < 60; ++i)
        EXPECT_EQ(servo.says({}, i % 2 == 0 ? kLong : kShort), std::nullopt);
    EXPECT_EQ(servo.says({.position = 300}, kLong, 250ms), std::nullopt);
}

TEST(Plausibility, RejectsAStepperInTwoModes) {
    Stepper stepper;
    EXPECT_EQ(stepper.says({.status = 0x6D, .timer = 60'000}), Rejection::BothModes);
    EXPECT_EQ(stepper.says({.status = 0x4D, .timer = 60'000}), std::nullopt);
}

TEST(Plausibility, RejectsAStepperThatMovesWithoutPower) {
    Stepper stepper;
    EXPECT_EQ(stepper.says({.status = 0x25, .timer = 60'000}), Rejection::MovingWithoutPower);
    EXPECT_EQ(stepper.says({.status = 0x00}), std::nullopt) << "it is at rest";
}

TEST(Plausibility, RejectsAStepperThatMovedWhileItStood) {
    Stepper stepper;
    EXPECT_EQ(stepper.says({.position = 1}), Rejection::MovedWhileStopped);
    stepper::LoadTrajectory oneStep;
    oneStep.position = Counts(1);
    oneStep.startNow = true;
    Stepper told;
    told.sends(StepperCommand(oneStep));
    EXPECT_EQ(told.says({.position = 1}), std::nullopt) << "one step between two queries";
    Stepper ended({.status = 0x4D, .timer = 60'000});
    EXPECT_EQ(ended.says({.position = 12}), std::nullopt) << "it was moving when it was last queried";
    // The motion ends in a doubt, whose first query asks for the type and version alone.
    Stepper doubted({.status = 0x4D, .timer = 60'000});
    EXPECT_EQ(doubted.says({}, 0x20), std::nullopt);
    EXPECT_EQ(doubted.says({.position = 12}), std::nullopt) << "it moved since the last position";
    EXPECT_EQ(doubted.says({.position = 13}), Rejection::MovedWhileStopped) << "it stands there";
}

TEST(Plausibility, RejectsMoreThanFiftyThousandStepsASecond) {
    // 10 ms at 50 000 steps a second are 500 steps.
    Stepper stepper({.status = 0x2D, .timer = 65'000});
    EXPECT_EQ(stepper.says({.status = 0x2D, .position = 480, .timer = 65'000}), std::nullopt);
    EXPECT_EQ(stepper.says({.status = 0x2D, .position = 480 + 700, .timer = 65'000}),
              Rejection::PositionJump);
}

TEST(Plausibility, RejectsATimerCountOutsideTheSheet) {
    for (const std::uint16_t count : std::initializer_list<std::uint16_t>{0, 65'453, 65'535}) {
        Stepper stepper({.status = 0x2D, .timer = 60'000});
        EXPECT_EQ(stepper.says({.status = 0x2D, .timer = count}), Rejection::TimerCount) << count;
    }
    for (const std::uint16_t count : std::initializer_list<std::uint16_t>{1, 65'452}) {
        Stepper stepper({.status = 0x2D, .timer = 60'000});
        EXPECT_EQ(stepper.says({.status = 0x2D, .timer = count}), std::nullopt) << count;
    }
    Stepper standing;
    EXPECT_EQ(standing.says({.timer = 0}), std::nullopt) << "at rest it means nothing";
}

TEST(Plausibility, BelievesAContradictionThatTheNextReplyConfirms) {
    Servo servo({.status = 0x1D, .position = 100, .aux = 0x04, .home = 7});
    const ServoState after{.status = 0x09, .position = 90'000, .home = -3};
    ASSERT_NE(servo.says(after), std::nullopt);
    EXPECT_EQ(servo.says(after, kShort, 300ms), std::nullopt) << "another host moved it";
    EXPECT_EQ(servo.says(after), std::nullopt);
    EXPECT_EQ(servo.says({.position = 100, .home = -3}), Rejection::PositionJump)
        << "the new position is now the known one";
}

/// The queries of a challenge: its identity, and then everything.
TEST(Plausibility, LetsAReplyThatDoesNotTellConfirmNothingAndRefuteNothing) {
    const ServoState moved{.position = 90'000};
    Servo servo;
    EXPECT_EQ(servo.says(moved), Rejection::PositionJump);
    EXPECT_EQ(servo.says(moved, 0x20), std::nullopt) << "type and version";
    EXPECT_EQ(servo.says(moved), std::nullopt);
    const ServoState home{.home = 90'000};
    Servo homed;
    EXPECT_EQ(homed.says(home), Rejection::HomeChanged);
    EXPECT_EQ(homed.says(home, kShort), std::nullopt);
    EXPECT_EQ(homed.says(home), std::nullopt);
}

TEST(Plausibility, DoesNotTakeTwoDifferentContradictionsForAConfirmation) {
    Servo servo({.position = 100});
    EXPECT_EQ(servo.says({.position = 90'000}), Rejection::PositionJump);
    EXPECT_EQ(servo.says({.position = -70'000}), Rejection::PositionJump);
    EXPECT_EQ(servo.says({.position = 100}), std::nullopt) << "it is where it was";
    EXPECT_EQ(servo.says({.position = 90'000}), Rejection::PositionJump)
        << "an old contradiction does not confirm it";
}

TEST(Plausibility, NeverBelievesWhatCannotBeHoweverOften) {
    Servo servo;
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(servo.says({.aux = 0x14}), Rejection::SlewWithoutAccel);
}

TEST(Plausibility, HasNoOpinionOnModulesWithoutADataSheet) {
    Plausibility io({ModuleType::Io, 1});
    for (const std::uint8_t status : std::initializer_list<std::uint8_t>{0x08, 0xFB, 0x01}) {
        const auto bytes = withSum({status, 2, 1});
        EXPECT_FALSE(io.check(accepted(ModuleType::Io, 0x20, bytes, {})));
    }
    EXPECT_EQ(io.check(accepted(ModuleType::Io, 0x20, withSum({0x08, 2, 9}), {})), Rejection::Identity);
}

}  // namespace

}  // namespace nmc::test
