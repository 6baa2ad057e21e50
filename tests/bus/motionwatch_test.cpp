// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/motionwatch.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/bus/replies.h"
#include "tests/bus/steps.h"

namespace nmc::test {

namespace {

using namespace bus;
using Suspect = std::optional<MotionSuspect::Reason>;

void send(MotionWatch& watch, ServoRegisters& sent, const Order& order) {
    sent.apply(std::get<ServoCommand>(order.command), kFirstServo);
    watch.onSent(order.command, sent);
}

/// A servo that is on, with commands sent to it and two layouts of replies in turn.
class Watched {
public:
    explicit Watched(std::int32_t position = 0) { EXPECT_EQ(is(position), Suspect{}); }

    Suspect is(std::int32_t position, std::int16_t velocity = 0, std::uint8_t aux = 0x04) {
        m_long = !m_long;
        const std::uint8_t items = m_long ? kLong : kShort;
        const int on = arrived ? 0x09 : 0x08;
        const ServoState state{.status = static_cast<std::uint8_t>((aux & 4) != 0 ? on : 0x19),
                               .position = position,
                               .velocity = velocity,
                               .aux = aux};
        return watch.onReport(accepted(ModuleType::Servo, items, bytesOf(state, items), {}).report,
                              time += std::chrono::milliseconds(2), sent.servoRate);
    }
    void told(const Order& order) { send(watch, sent, order); }

    MotionWatch watch;
    ServoRegisters sent;
    TimePoint time{};
    bool arrived = false;  ///< by its own account

private:
    bool m_long = false;
};

[[nodiscard]] Order turn(bool reverse) {
    servo::LoadTrajectory load;
    load.velocity = CountsPerTick(65'536);
    load.acceleration = CountsPerTickSquared(655);
    load.profile = servo::ProfileMode::Velocity;
    load.reverse = reverse;
    load.startNow = true;
    return toServo(0, load);
}

TEST(MotionWatch, SaysNothingOfAMoveThatEndsAtItsGoal) {
    Watched servo;
    servo.told(loadMove(0, 5'000));
    servo.told(start(0));
    for (std::int32_t position = 0; position <= 5'000; position += 50)
        ASSERT_EQ(servo.is(position, 5), Suspect{});
    for (const std::int32_t position : {5'080, 5'020, 4'990, 5'000, 5'000})
        EXPECT_EQ(servo.is(position), Suspect{}) << "it swings a little";
}

TEST(MotionWatch, TellsOnceOfAMoveAwayFromItsGoal) {
    for (const std::int32_t sign : {1, -1}) {
        Watched servo(10'000);
        servo.told(loadMove(0, 10'000 + sign * 5'000));
        servo.told(start(0));
        EXPECT_EQ(servo.is(10'000 - sign * 400, 4), Suspect{}) << "this much is allowed";
        EXPECT_EQ(servo.is(10'000 - sign * 401, 4), MotionSuspect::Reason::WrongWay);
        EXPECT_EQ(servo.is(10'000 - sign * 900, 4), Suspect{});
    }
}

TEST(MotionWatch, TellsOfAMoveThatGoesPastItsGoal) {
    // An overshoot of a tenth of the way plus 400 counts is allowed.
    Watched servo;
    servo.told(loadMove(0, -5'000));
    servo.told(start(0));
    EXPECT_EQ(servo.is(-5'900, -5), Suspect{});
    EXPECT_EQ(servo.is(-5'901, -5), MotionSuspect::Reason::Overshot);
}

TEST(MotionWatch, WatchesALoadAsIfItHadStarted) {
    Watched servo;
    servo.told(loadMove(0, 5'000));
    EXPECT_EQ(servo.is(-401, -4), MotionSuspect::Reason::WrongWay)
        << "corrupted on its way, it may have started";
}

/// It moves half a count per tick, so that the velocity item, which has no fraction, is 0 as often as 1.
TEST(MotionWatch, StillWatchesASlowMotionWhenALoadIsToWait) {
    Watched run;
    run.told(turn(true));
    Watched move;
    move.told(loadMove(0, 5'000));
    move.told(start(0));
    for (std::int32_t gone = 0; gone <= 2'000; gone += 50) {
        ASSERT_EQ(run.is(-gone), Suspect{}) << gone;
        ASSERT_EQ(move.is(gone), Suspect{}) << gone;
        if (gone == 500) {
            run.told(loadMove(0, 5'000));
            move.told(loadMove(0, -5'000));
        }
    }
    EXPECT_EQ(run.is(-1'000, 1), MotionSuspect::Reason::WrongWay);
    EXPECT_EQ(move.is(-401, -1), MotionSuspect::Reason::WrongWay);
}

TEST(MotionWatch, GoesByTheGoalThatStaysLoaded) {
    Watched servo;
    servo.told(loadMove(0, 5'000));
    servo.told(start(0));
    for (std::int32_t position = 0; position <= 5'000; position += 100)
        ASSERT_EQ(servo.is(position, 5), Suspect{});
    servo.told(start(0));
    EXPECT_EQ(servo.is(5'000), Suspect{}) << "a move of length 0";
    EXPECT_EQ(servo.is(5'401, 4), MotionSuspect::Reason::Overshot);
}

TEST(MotionWatch, TellsOfAMotorThatTurnsAgainstItsDirection) {
    for (const bool reverse : {false, true}) {
        const int sign = reverse ? -1 : 1;
        Watched servo;
        servo.told(turn(reverse));
        for (int i = 0; i < 20; ++i)
            ASSERT_EQ(servo.is(sign * i * 100, static_cast<std::int16_t>(sign * 5)), Suspect{});
        EXPECT_EQ(servo.is(sign * 1'500, static_cast<std::int16_t>(-sign * 5)), Suspect{});
        EXPECT_EQ(servo.is(sign * 1'499, static_cast<std::int16_t>(-sign * 5)),
                  MotionSuspect::Reason::WrongWay)
            << "401 back from the farthest position it has reached";
    }
}

TEST(MotionWatch, LetsAMotorSlowDownBeforeItTurnsRound) {
    Watched servo;
    servo.told(turn(false));
    for (int i = 1; i <= 10; ++i)
        ASSERT_EQ(servo.is(i * 200, 10), Suspect{});
    servo.told(turn(true));
    for (int i = 10; i > 0; --i)
        ASSERT_EQ(servo.is(4'000 - i * 100, static_cast<std::int16_t>(i)), Suspect{}) << "still forward";
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(servo.is(4'000 - i * 100, -5), Suspect{});
    EXPECT_EQ(servo.is(4'000, 5), MotionSuspect::Reason::WrongWay) << "forward again";
}

/// It is sent back before it has come to rest.
TEST(MotionWatch, LetsAMotorThatIsBeingStoppedSlowDownToo) {
    Watched servo;
    servo.told(turn(false));
    for (int i = 1; i <= 10; ++i)
        ASSERT_EQ(servo.is(i * 200, 10), Suspect{});
    servo.told(toServo(0, servo::StopMotor{true, servo::StopManner::Smoothly, {}}));
    ASSERT_EQ(servo.is(2'200, 9), Suspect{});
    servo.told(turn(true));
    for (int i = 8; i > 0; --i)
        ASSERT_EQ(servo.is(3'800 - i * 200, static_cast<std::int16_t>(i)), Suspect{}) << "still forward";
    for (int i = 0; i < 20; ++i)
        ASSERT_EQ(servo.is(3'600 - i * 100, -5), Suspect{});
    EXPECT_EQ(servo.is(3'600, 5), MotionSuspect::Reason::WrongWay) << "forward again";
}

TEST(MotionWatch, ForgetsAMotionThatWasStopped) {
    for (const auto manner : {servo::StopManner::Abruptly, servo::StopManner::Smoothly,
                              servo::StopManner::Here, servo::StopManner::MotorOff}) {
        Watched servo;
        servo.told(loadMove(0, 5'000));
        servo.told(start(0));
        servo.told(toServo(0, servo::StopMotor{true, manner, {}}));
        EXPECT_EQ(servo.is(-3'000, -4), Suspect{});
    }
    Watched servo;
    servo.told(loadMove(0, 5'000));
    servo.told(start(0));
    servo.told(toServo(0, servo::StopMotor{true, servo::StopManner::AmplifierOnly, {}}));
    EXPECT_EQ(servo.is(-3'000, -4), MotionSuspect::Reason::WrongWay) << "this does not stop the motion";
}

TEST(MotionWatch, ForgetsAMotionWhoseServoIsOffAndStands) {
    Watched servo;
    servo.told(loadMove(0, 5'000));
    servo.told(start(0));
    EXPECT_EQ(servo.is(0, 0, 0x00), Suspect{});
    EXPECT_EQ(servo.is(-3'000, -4), Suspect{}) << "turned by hand";
}

TEST(MotionWatch, WatchesAServoThatIsOffAndTurns) {
    Watched servo;
    servo.told(loadMove(0, 5'000));
    EXPECT_EQ(servo.is(-200, -10, 0x00), Suspect{});
    EXPECT_EQ(servo.is(-600, -10, 0x00), MotionSuspect::Reason::WrongWay)
        << "a load that became a PWM output";
}

TEST(MotionWatch, TellsOfThePositionThatIsRepeatedWhileItMoves) {
    Watched servo;
    servo.told(turn(false));
    unsigned repeats = 0;
    while (repeats < 20 && servo.is(300, 5) != MotionSuspect::Reason::Frozen)
        ++repeats;
    EXPECT_GT(repeats, 5U) << "more than five";
    EXPECT_LE(repeats, 5U + 3U) << "each layout repeats its own";
}

/// A noise of half a count at an encoder, as the position and the velocity of one tick show it: six equal
/// positions in a row, and each time a velocity, are nothing rare.
TEST(MotionWatch, IsNotConcernedByTheNoiseOfAnEncoderAtStandstill) {
    Watched servo;
    servo.arrived = true;
    std::mt19937 random(1);
    const auto position = [&random] { return 300 + static_cast<std::int32_t>(random() % 2); };
    std::int32_t before = position();
    for (int i = 0; i < 1'000'000; ++i) {
        const std::int32_t now = position();
        ASSERT_EQ(servo.is(now, static_cast<std::int16_t>(now - before)), Suspect{}) << i;
        before = position();
    }
}

/// Such as that of another host's run at a constant velocity.
TEST(MotionWatch, TellsOfAFastMotorThatRepeatsItsPositionAndSaysThatItHasArrived) {
    Watched servo;
    servo.arrived = true;
    unsigned repeats = 0;
    while (repeats < 20 && servo.is(300, -20) != MotionSuspect::Reason::Frozen)
        ++repeats;
    EXPECT_LE(repeats, 5U + 3U);
}

/// At the longest tick, of 131 ms, there are 65 replies for each new position.
TEST(MotionWatch, KnowsThatAPositionIsNewOnlyOncePerTick) {
    for (const std::optional<int> rate : {std::optional(255), std::optional<int>()}) {
        Watched servo;
        servo.told(turn(false));
        servo.sent.servoRate = rate;
        for (std::int32_t tick = 0; tick < 10; ++tick)
            for (int i = 0; i < 65; ++i)
                ASSERT_EQ(servo.is(1'000 * tick, 1'000), Suspect{});
    }
}

TEST(MotionWatch, IsNotConcernedByARepeatedPositionAtStandstill) {
    Watched servo;
    servo.told(turn(false));
    for (int i = 0; i < 100; ++i)
        ASSERT_EQ(servo.is(300, 0), Suspect{});
}

TEST(MotionWatch, HasNoOpinionOnPwmOutput) {
    Watched servo;
    servo.told(loadPwm(0, 100));
    EXPECT_EQ(servo.is(-5'000, -100), Suspect{});
    EXPECT_EQ(servo.is(5'000, 100), Suspect{});
}

TEST(MotionWatch, HasNoOpinionBeforeItKnowsWhereTheMotorIs) {
    MotionWatch watch;
    ServoRegisters sent;
    send(watch, sent, loadMove(0, 5'000));
    send(watch, sent, start(0));
    const ServoState state{.position = -9'000};
    const StatusReport report = accepted(ModuleType::Servo, kLong, bytesOf(state, kLong), {}).report;
    EXPECT_EQ(watch.onReport(report, {}, 1), Suspect{});
}

TEST(MotionWatch, ForgetsItsCorridorWhenThePositionIsReset) {
    Watched servo(20'000);
    servo.told(loadMove(0, 20'100));
    servo.told(toServo(0, ResetPosition{}));
    EXPECT_EQ(servo.is(0), Suspect{});
}

TEST(MotionWatch, FollowsAPositionThatWraps) {
    Watched servo(INT32_MAX - 100);
    servo.told(turn(false));
    EXPECT_EQ(servo.is(INT32_MAX - 10, 5), Suspect{});
    EXPECT_EQ(servo.is(INT32_MIN + 90, 5), Suspect{});
    EXPECT_EQ(servo.is(INT32_MIN + 190, 5), Suspect{});
}

}  // namespace

}  // namespace nmc::test
