// SPDX-License-Identifier: GPL-3.0-or-later
// The position of home, calculated by hand: the home register is used only for a home that was saved.
#include "model/module/homefact.h"

#include <gtest/gtest.h>

#include "model/intent/intent.h"
#include "servofixture.h"

namespace nmc {
namespace {

using namespace testing_support;

/// A servo that holds and reports its status every 20 ms.
struct Holding {
    ModuleState module = holdingServo();
    double time = 1.0;
    std::int32_t inRegister = 0;

    void says(std::int32_t position) {
        bus::Sample sample = sampleOf(time += 0.02, kMoveDone | kPower, kServoOn, position);
        sample.report.home = inRegister;
        module.apply(sample);
    }
    void stands(std::int32_t position) {
        says(position);
        says(position);
    }
    /// The command is answered at once.
    void does(ServoCommand command, std::int32_t position) {
        module.apply(executedAt(time += 0.005, std::move(command)));
        bus::Sample answer = sampleOf(time, kMoveDone | kPower, kServoOn, position);
        answer.report.home = inRegister;
        module.apply(answer);
    }
    void foundAt(std::int32_t home) { module.home.found(home, atSeconds(time)); }
    std::optional<std::int32_t> home() const {
        return module.home.place() ? std::optional(module.home.place()->counts) : std::nullopt;
    }
};

TEST(HomeFact, IsNotKnownWhateverTheRegisterSays) {
    Holding servo;
    servo.inRegister = -304;
    servo.stands(0);
    EXPECT_EQ(servo.home(), std::nullopt);
    const auto planned =
        plan(intent::GoHome{ServoPace{CountsPerTick(65'536), CountsPerTickSquared(100)}}, servo.module);
    ASSERT_FALSE(planned);
    EXPECT_EQ(planned.error(), Refusal::HomeUnknown);
}

TEST(HomeFact, GoesAlongWhereAnScSetsItsCounter) {
    Holding servo;
    servo.inRegister = -304;
    servo.stands(1'000);
    servo.foundAt(-200);  // 1200 counts below its position
    servo.does(servo::SetPosition{Counts(5'000)}, 5'000);
    servo.stands(5'000);
    EXPECT_EQ(servo.home(), 3'800);
    servo.does(servo::ResetRelativeToHome{}, 5'304);  // the position minus the register
    EXPECT_EQ(servo.home(), 4'104);
}

TEST(HomeFact, AZeroMadeAtHomeIsHome) {
    Holding servo;
    servo.inRegister = -304;
    servo.stands(-304);
    servo.foundAt(-304);
    servo.does(ResetPosition{}, 0);
    servo.stands(0);
    EXPECT_EQ(servo.home(), 0);
    const auto planned =
        plan(intent::GoHome{ServoPace{CountsPerTick(65'536), CountsPerTickSquared(100)}}, servo.module);
    ASSERT_TRUE(planned);
    const auto& load = std::get<servo::LoadTrajectory>(std::get<ServoCommand>(planned->front().command));
    EXPECT_EQ(load.position, Counts(0)) << "not -304, which the register still contains";
}

TEST(HomeFact, GoesAlongWithTheCounter) {
    struct Case {
        std::int32_t home, zeroAt, then;
    };
    for (const Case& c : {Case{512, 1'000, -488}, Case{-304, -1'000, 696}, Case{7, 0, 7},
                          // The counter wraps at 32 bits: from the last count, home is 11 counts ahead.
                          Case{-kLastCount + 9, kLastCount, 11}}) {
        Holding servo;
        servo.stands(c.zeroAt);
        servo.foundAt(c.home);
        servo.does(ResetPosition{}, 0);
        EXPECT_EQ(servo.home(), c.then) << c.home << ", zero at " << c.zeroAt;
    }
}

TEST(HomeFact, IsLostWithAZeroThatWasMadeNobodyKnowsWhere) {
    Holding turning;
    turning.foundAt(0);
    turning.says(100);
    turning.says(200);
    turning.does(ResetPosition{}, 3);
    EXPECT_EQ(turning.home(), std::nullopt);
    Holding unheard;
    unheard.stands(100);
    unheard.foundAt(0);
    unheard.time += 5;
    unheard.does(ResetPosition{}, 0);
    EXPECT_EQ(unheard.home(), std::nullopt);
}

/// Positions by the counter are the same places only while nothing sets it, or as far from home as before.
TEST(HomeFact, WhatTheCounterCountsFromIsAnotherOnceItWasSet) {
    Holding servo;
    servo.stands(1'000);
    const HomeFact::Origin before = servo.module.home.origin();
    servo.stands(2'000);
    EXPECT_EQ(servo.module.home.origin(), before) << "it has only moved";
    servo.does(ResetPosition{}, 0);
    const HomeFact::Origin zeroed = servo.module.home.origin();
    EXPECT_NE(zeroed, before);
    servo.module.restarted();
    EXPECT_NE(servo.module.home.origin(), zeroed);

    servo.foundAt(-700);
    const HomeFact::Origin homed = servo.module.home.origin();
    servo.module.restarted();
    EXPECT_NE(servo.module.home.origin(), homed);
    servo.foundAt(-700);
    EXPECT_EQ(servo.module.home.origin(), homed) << "as far from home as before";
}

TEST(HomeFact, IsWhereItWasSavedByTheRegistersWord) {
    Holding servo;
    servo.stands(750);
    servo.foundAt(0);
    servo.does(SaveAsHome{}, 750);  // its answer still contains the old home
    EXPECT_EQ(servo.home(), std::nullopt);
    servo.inRegister = 751;
    servo.says(750);
    EXPECT_EQ(servo.home(), std::nullopt) << "one reply is not enough";
    servo.says(750);
    EXPECT_EQ(servo.home(), 751);
    EXPECT_EQ(servo.module.home.place()->source, HomeFact::Source::Saved);
}

TEST(HomeFact, ALimitStopLeavesItAlone) {
    // A limit stop is armed with Set Homing Mode like a search for home: once it trips, the register contains
    // the position of the limit (DS-V 5.2).
    Holding servo;
    servo.stands(0);
    servo.foundAt(0);
    servo.does(servo::SetHoming{.onLimit1Change = true, .stopAbruptly = true}, 0);
    servo.inRegister = 4'000;
    servo.stands(4'000);
    EXPECT_EQ(servo.home(), 0);
}

TEST(HomeFact, ARestartAndAJumpOfTheCounterLoseIt) {
    Holding restarted;
    restarted.foundAt(0);
    restarted.module.restarted();
    EXPECT_EQ(restarted.home(), std::nullopt);
    Holding jumped;
    jumped.stands(50'000);
    jumped.foundAt(100);
    bus::Sample sample = sampleOf(2, kMoveDone | kPower, kServoOn, 0);
    sample.jumped = true;
    jumped.module.apply(sample);
    EXPECT_EQ(jumped.home(), std::nullopt);
}

// ---- the work offset in use ----

const WorkOffset kFixture{"fixture A", 1'000};

/// A servo at rest that counts from 1000 counts above its home, which is at 200.
Holding atFixture() {
    Holding servo;
    servo.stands(500);
    servo.foundAt(200);
    servo.module.home.useWork(kFixture, 200);
    return servo;
}

TEST(WorkOffsetInUse, CountsFromHomeAndMovesWithIt) {
    Holding servo = atFixture();
    EXPECT_EQ(servo.module.home.workZero(), (WorkZero{kFixture, 1'200.0}));
    EXPECT_EQ(countedFrom(servo.module.home.workZero(), 500), -700.0);
    servo.does(ResetPosition{}, 0);
    EXPECT_EQ(servo.home(), -300);
    EXPECT_EQ(servo.module.home.workZero()->counts, 700.0) << "still 700 counts ahead";
    servo.module.home.useWork(std::nullopt, std::nullopt);
    EXPECT_EQ(servo.module.home.workZero(), std::nullopt);
    EXPECT_EQ(countedFrom(servo.module.home.workZero(), 500), 500.0);
}

TEST(WorkOffsetInUse, IsNotKnownAfterAnythingThatMakesHomeAnotherOne) {
    const std::pair<const char*, void (*)(Holding&)> losses[] = {
        {"a search", [](Holding& servo) { servo.foundAt(200); }},
        {"confirmed", [](Holding& servo) { servo.module.home.declare(atSeconds(servo.time)); }},
        {"in doubt", [](Holding& servo) { servo.module.home.forget(); }},
        {"saved", [](Holding& servo) { servo.does(SaveAsHome{}, 500); }},
        {"restart", [](Holding& servo) { servo.module.restarted(); }},
        {"zero while it turns",
         [](Holding& servo) {
             servo.says(600);
             servo.does(ResetPosition{}, 0);
         }},
        {"jump",
         [](Holding& servo) {
             bus::Sample sample = sampleOf(servo.time + 1, kMoveDone | kPower, kServoOn, 0);
             sample.jumped = true;
             servo.module.apply(sample);
         }},
        {"deleted", [](Holding& servo) { servo.module.home.keepWork({}); }},
        {"changed", [](Holding& servo) {
             servo.module.home.keepWork({{"fixture A", 999}});
         }}};
    for (const auto& [what, lose] : losses) {
        Holding servo = atFixture();
        servo.module.home.keepWork({kFixture});
        ASSERT_TRUE(servo.module.home.workZero()->counts) << what;
        lose(servo);
        EXPECT_EQ(servo.module.home.workZero(), (WorkZero{kFixture, std::nullopt})) << what;
        EXPECT_EQ(countedFrom(servo.module.home.workZero(), 500), std::nullopt) << what;
        servo.foundAt(200);
        EXPECT_EQ(servo.module.home.workZero()->counts, std::nullopt) << what << ": never by itself";
        servo.module.home.useWork(kFixture, 200);
        EXPECT_EQ(servo.module.home.workZero()->counts, 1'200.0) << what;
    }
}

TEST(WorkOffsetInUse, IsNotKnownAfterARestoredHome) {
    Holding servo;
    servo.stands(500);
    servo.module.home.offer(200);
    servo.module.home.useWork(kFixture, std::nullopt);
    servo.module.home.takeOffer(atSeconds(servo.time));
    EXPECT_EQ(servo.home(), 200);
    EXPECT_EQ(servo.module.home.workZero()->counts, std::nullopt);
}

TEST(WorkOffsetInUse, CountsByTheCounterUntilThatIsSetWhileHomeIsUnknown) {
    Holding servo;
    servo.stands(500);
    servo.module.home.useWork(kFixture, std::nullopt);
    EXPECT_EQ(servo.module.home.workZero()->counts, 1'000.0);
    servo.module.home.keepWork({});
    EXPECT_TRUE(servo.module.home.workZero()->counts) << "it is not one of the machine's";
    servo.does(ResetPosition{}, 0);
    EXPECT_EQ(servo.module.home.workZero(), (WorkZero{kFixture, std::nullopt}));
}

TEST(WorkOffsetInUse, WasChosenForTheHomeThatIsThere) {
    Holding servo = atFixture();
    servo.module.home.useWork(std::nullopt, std::nullopt);
    for (const std::optional<std::int32_t>& home : {std::optional<std::int32_t>(), std::optional(199)}) {
        servo.module.home.useWork(kFixture, home);
        EXPECT_EQ(servo.module.home.workZero(), std::nullopt);
    }
}

TEST(WorkOffsetInUse, FollowsFromWhatAPositionIsCalled) {
    Holding servo;
    servo.stands(5'000);
    const auto called = [&](double counts) { return servo.module.home.workOffset("A", 5'000, counts); };
    EXPECT_EQ(called(0), (WorkOffset{"A", 5'000})) << "by the counter";
    EXPECT_EQ(called(5'000.0 - kLastCount), (WorkOffset{"A", kLastCount}));
    EXPECT_EQ(called(4'999.0 - kLastCount), std::nullopt);
    servo.foundAt(-200);
    EXPECT_EQ(called(0), (WorkOffset{"A", 5'200})) << "from home";
    EXPECT_EQ(called(-700), (WorkOffset{"A", 5'900}));
    servo.module.home.useWork(called(700), -200);
    EXPECT_EQ(countedFrom(servo.module.home.workZero(), 5'000), 700.0) << "as it was called";
}

}  // namespace
}  // namespace nmc
