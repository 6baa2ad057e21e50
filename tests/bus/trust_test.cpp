// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/trust.h"

#include <gtest/gtest.h>

#include "tests/bus/replies.h"

namespace nmc::test {

namespace {

using namespace bus;

/// A servo, and the status that is passed on of its replies.
class TrustedServo {
public:
    TrustedServo() { trust.emplace(ModuleIdentity{ModuleType::Servo, 4}); }
    [[nodiscard]] std::optional<std::uint8_t> says(std::uint8_t status, std::uint8_t items) {
        const auto trusted = trust->confirm(report(status, items));
        return trusted ? std::optional(trusted->status) : std::nullopt;
    }
    void settle(std::uint8_t status) {
        for (int i = 0; i < 3; ++i)
            (void)says(status, i % 2 == 0 ? kLong : kShort);
    }
    [[nodiscard]] static StatusReport report(std::uint8_t status, std::uint8_t items) {
        return accepted(ModuleType::Servo, items, bytesOf(ServoState{.status = status}, items), {}).report;
    }
    std::optional<Trust> trust;
};

TEST(Trust, SaysNothingAfterTheFirstReply) {
    TrustedServo servo;
    EXPECT_EQ(servo.says(0x09, kLong), std::nullopt);
    EXPECT_EQ(servo.says(0x09, kShort), 0x09);
}

TEST(Trust, LetsTwoRepliesOfDifferentLengthPermit) {
    // Before and after: comes to rest, power is back, limits released, homing ended.
    const std::pair<std::uint8_t, std::uint8_t> kPermits[] = {
        {0x08, 0x09}, {0x11, 0x19}, {0x29, 0x09}, {0x49, 0x09}, {0x89, 0x09}};
    for (const auto& [before, after] : kPermits) {
        SCOPED_TRACE(int{before});
        TrustedServo servo;
        servo.settle(before);
        EXPECT_EQ(servo.says(after, kShort), before) << "one reply is not enough";
        EXPECT_EQ(servo.says(after, kLong), after);
    }
}

TEST(Trust, LetsOneReplyWarn) {
    const std::pair<std::uint8_t, std::uint8_t> kWarns[] = {
        {0x09, 0x08}, {0x19, 0x11}, {0x09, 0x29}, {0x09, 0x49}, {0x09, 0x89}, {0x09, 0x0D}, {0x09, 0x19}};
    for (const auto& [before, after] : kWarns) {
        SCOPED_TRACE(int{after});
        TrustedServo servo;
        servo.settle(before);
        EXPECT_EQ(servo.says(after, kShort), after);
    }
}

TEST(Trust, TakesTwoRepliesOfOneLengthForOne) {
    TrustedServo servo;
    servo.settle(0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    EXPECT_EQ(servo.says(0x09, kLong), 0x09);
}

TEST(Trust, BeginsAnewAfterAReplyThatForbidsAgain) {
    TrustedServo servo;
    servo.settle(0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    EXPECT_EQ(servo.says(0x08, kLong), 0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    EXPECT_EQ(servo.says(0x09, kLong), 0x09);
}

TEST(Trust, DoesNotCountRepliesBeforeADoubt) {
    TrustedServo servo;
    servo.settle(0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x08);
    servo.trust->interrupt();
    EXPECT_EQ(servo.says(0x09, kLong), 0x08);
    EXPECT_EQ(servo.says(0x09, kShort), 0x09);
}

TEST(Trust, KeepsWhatWasGrantedThroughADoubt) {
    TrustedServo servo;
    servo.settle(0x09);
    servo.trust->interrupt();
    EXPECT_EQ(servo.says(0x09, kShort), 0x09);
}

TEST(Trust, WantsStandstillShownAnewAfterAStart) {
    TrustedServo servo;
    servo.settle(0x09);
    servo.trust->expectMotion();
    EXPECT_EQ(servo.says(0x09, kShort), 0x08) << "power is not affected";
    EXPECT_EQ(servo.says(0x09, kLong), 0x09);
}

TEST(Trust, WithholdsAReleasedEstopOfAStepperOnce) {
    Trust trust({ModuleType::Stepper, 1});
    const auto says = [&](std::uint8_t status, std::uint8_t inputs, std::uint8_t items) {
        const StepperState state{.status = status, .timer = 60'000, .inputs = inputs};
        return trust.confirm(accepted(ModuleType::Stepper, items, bytesOf(state, items), {}).report);
    };
    // E-stop and both limits; moving and homing.
    for (const std::uint8_t items : {kLong, kShort, kLong})
        (void)says(0x8D, 0x19, items);
    auto trusted = says(0x0C, 0x00, kShort);
    ASSERT_TRUE(trusted);
    EXPECT_EQ(trusted->status, 0x8D);
    EXPECT_EQ(trusted->aux, 0x19);
    // A reply without the inputs permits only what it contains.
    trusted = says(0x0C, 0x00, 0x01);
    EXPECT_EQ(trusted->status, 0x0C);
    EXPECT_FALSE(trusted->aux);
    trusted = says(0x0C, 0x00, kLong);
    EXPECT_EQ(trusted->aux, 0x19) << "the inputs have been seen open once since";
    trusted = says(0x0C, 0x00, kShort);
    EXPECT_EQ(trusted->aux, 0x00);
    trusted = says(0x0C, 0x01, kLong);
    EXPECT_EQ(trusted->aux, 0x01) << "a pressed E-stop is reported at once";
}

TEST(Trust, PassesOnWhatAnUnknownModuleSays) {
    Trust trust({ModuleType::Io, 1});
    const auto says = [&](std::uint8_t status) {
        const auto bytes = withSum({status, 2, 1});
        return trust.confirm(accepted(ModuleType::Io, 0x20, bytes, {}).report);
    };
    EXPECT_FALSE(says(0x00));
    EXPECT_EQ(says(0x55)->status, 0x55);
    EXPECT_EQ(says(0xA8)->status, 0xA8);
}

}  // namespace

}  // namespace nmc::test
