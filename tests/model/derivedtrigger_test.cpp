// SPDX-License-Identifier: GPL-3.0-or-later
// A trigger on derived signals, which no sample contains: acceleration, PWM, count rate, the user's own.
#include <gtest/gtest.h>

#include <functional>

#include "model/scope/derivedsignals.h"
#include "model/scope/scopetrigger.h"
#include "scopesamples.h"
#include "servofixture.h"

namespace nmc {
namespace {

using Condition = TriggerSettings::Condition;
using State = ScopeTrigger::State;
using testing_support::atMs;
using testing_support::kServoOn;

constexpr ModuleIndex kWatched{1};

/// Feeds a sample every 2 ms, from 0 on, of a servo that is on; `fill` sets its values.
class DerivedTrigger : public testing::Test {
protected:
    /// 20 ms before the trigger, 80 ms after it.
    void watch(ScopeSignal signal, Condition condition, double level) {
        watch({.module = kWatched,
               .source = signal,
               .condition = condition,
               .level = level,
               .preTrigger = 0.2,
               .window = 0.1});
    }
    void watch(const TriggerSettings& settings) {
        trigger.set(settings);
        derived = DerivedSignals();
        derived.want({*trigger.derivedSource()}, settings.custom);
        fed = 0;
        trigger.arm(atMs(0));
    }
    /// Begins again with no samples.
    void startOver() {
        history = History(2);
        trigger = ScopeTrigger();
        next = 0;
    }
    void setGains(double milliseconds, const std::optional<servo::SetGain>& set) {
        history.noteGains({kWatched, atMs(milliseconds), set});
    }
    /// Feeds the samples up to number `last`.
    State run(int last, const std::function<void(int, ScopeSample&)>& fill) {
        for (; next <= last; ++next) {
            ScopeSample sample;
            sample.time = atMs(next * 2);
            sample.aux = kServoOn;
            fill(next, sample);
            history.append(kWatched, sample);
            trigger.feed(kWatched, sample);
            follow();
        }
        return trigger.state();
    }
    void follow() {
        derived.follow(history);
        fed = derived.source(history, *trigger.derivedSource())
                  .samples->visitSince(fed, [this](const ScopeSample& value) { trigger.feedDerived(value); });
    }
    void expectFiredAt(double milliseconds) {
        ASSERT_TRUE(trigger.firedAt().has_value());
        EXPECT_NEAR(toSeconds(*trigger.firedAt() - atMs(milliseconds)), 0, 1e-6);
    }

    ScopeTrigger trigger;
    History history{2};
    DerivedSignals derived;
    std::uint64_t fed = 0;  ///< values
    int next = 0;
};

/// Proportional gain alone: PWM is kp * error / 256 (DS-V 4.3).
servo::SetGain proportional(std::uint16_t kp) {
    return {kp, 0, 0, 0, 255, 0, 16'000, 1, std::uint8_t{0}};
}
std::function<void(int, ScopeSample&)> errorOf(const std::function<float(int)>& error) {
    return
        [error](int i, ScopeSample& sample) { sample.error = sample.errorLow = sample.errorHigh = error(i); };
}

// ---- acceleration ----

/// 2 / (2 ms)^2 = 500 000 counts/s^2.
void parabola(int i, ScopeSample& sample) {
    sample.position = i * i;
}
/// 6 i / (2 ms)^2: it rises by 1 500 000 counts/s^2 with every sample.
void thirdPower(int i, ScopeSample& sample) {
    sample.position = i * i * i;
}

TEST_F(DerivedTrigger, AConstantAccelerationIsAboveWhatIsLessAndNotAboveWhatIsMore) {
    watch(ScopeSignal::Acceleration, Condition::Above, 500'001);
    EXPECT_EQ(run(100, parabola), State::Armed);
    watch(ScopeSignal::Acceleration, Condition::Above, 499'999);
    EXPECT_EQ(run(101, parabola), State::Complete);
}

/// With samples up to 82 ms, the acceleration is known up to 62 ms.
TEST_F(DerivedTrigger, AnAccelerationCrossesTheLevelWhenItDidAndNotWhenItIsKnown) {
    watch(ScopeSignal::Acceleration, Condition::Rising, 30.5 * 1'500'000);
    EXPECT_EQ(run(40, thirdPower), State::Armed);
    EXPECT_EQ(run(41, thirdPower), State::Fired);
    expectFiredAt(61);
}

TEST_F(DerivedTrigger, ThePictureIsCompleteWhenTheAccelerationIsKnownToItsEnd) {
    watch(ScopeSignal::Acceleration, Condition::Rising, 30.5 * 1'500'000);
    // The picture extends from 41 to 141 ms; the value for 142 ms requires the samples up to 162 ms.
    EXPECT_EQ(run(80, thirdPower), State::Fired);
    EXPECT_EQ(run(81, thirdPower), State::Complete);
    EXPECT_NEAR(toSeconds(trigger.picture()->from - atMs(41)), 0, 1e-6);
    EXPECT_NEAR(toSeconds(trigger.picture()->to - atMs(141)), 0, 1e-6);
}

/// The sample that completes the value came after arming, but the value itself belongs to a time before.
TEST_F(DerivedTrigger, AValueFromBeforeArmingDoesNotTrigger) {
    watch(ScopeSignal::Acceleration, Condition::Above, 499'999);
    trigger.disarm();
    run(25, parabola);
    trigger.arm(atMs(50));
    EXPECT_EQ(run(34, parabola), State::Armed) << "known up to 48 ms";
    EXPECT_EQ(run(35, parabola), State::Fired);
    expectFiredAt(50);
}

TEST_F(DerivedTrigger, NoEdgeOfAnAccelerationLiesInAGap) {
    const auto startsToMove = [](bool gap) {
        return [gap](int i, ScopeSample& sample) {
            sample.position = i < 50 ? 0 : (i - 50) * (i - 50);
            sample.gapBefore = gap && i == 50;
        };
    };
    watch(ScopeSignal::Acceleration, Condition::Rising, 250'000);
    EXPECT_EQ(run(200, startsToMove(true)), State::Armed) << "0 before the gap, 500 000 after it";
    startOver();
    watch(ScopeSignal::Acceleration, Condition::Rising, 250'000);
    EXPECT_EQ(run(200, startsToMove(false)), State::Complete);
    // A parabola through 21 samples with the start in their middle has half of the acceleration.
    expectFiredAt(100);
}

TEST_F(DerivedTrigger, APictureThatTheAccelerationDoesNotReachTheEndOfIsCompleteAllTheSame) {
    const auto gapAtTheEnd = [](int i, ScopeSample& sample) {
        thirdPower(i, sample);
        sample.gapBefore = i == 71;
    };
    watch(ScopeSignal::Acceleration, Condition::Rising, 30.5 * 1'500'000);
    // The picture ends at 141 ms; the gap is from 140 to 142 ms, and the first value after it is for 162 ms.
    EXPECT_EQ(run(71, gapAtTheEnd), State::Fired);
    EXPECT_EQ(run(91, gapAtTheEnd), State::Complete);
}

// ---- PWM ----

TEST_F(DerivedTrigger, APwmCrossesTheLevelBetweenTwoSamples) {
    setGains(0, proportional(512));
    watch(ScopeSignal::Pwm, Condition::Rising, 40);
    const auto error = errorOf([](int i) { return i < 50 ? 10.0F : 30.0F; });  // a PWM of 20 and 60
    EXPECT_EQ(run(50, error), State::Armed) << "the value of a sample requires the next one";
    EXPECT_EQ(run(51, error), State::Fired);
    expectFiredAt(99);
    // The picture extends to 179 ms; the value for 180 ms requires the sample of 182 ms.
    EXPECT_EQ(run(90, error), State::Fired);
    EXPECT_EQ(run(91, error), State::Complete);
}

TEST_F(DerivedTrigger, WithoutGainsThereIsNoPwmAndNoTrigger) {
    const auto error = errorOf([](int i) { return i < 50 ? -100.0F : 100.0F; });
    for (const Condition condition :
         {Condition::Rising, Condition::Falling, Condition::Above, Condition::Below}) {
        startOver();
        watch(ScopeSignal::Pwm, condition, 0);
        EXPECT_EQ(run(200, error), State::Armed) << static_cast<int>(condition);
    }
}

TEST_F(DerivedTrigger, APwmThatBecomesKnownIsNoEdge) {
    setGains(201, proportional(256));
    const auto error = errorOf([](int i) { return i < 150 ? 100.0F : i < 160 ? 0.0F : 100.0F; });
    watch(ScopeSignal::Pwm, Condition::Rising, 50);
    EXPECT_EQ(run(158, error), State::Armed) << "it is 100 as soon as it is known";
    EXPECT_EQ(run(161, error), State::Fired);
    expectFiredAt(319);
}

TEST_F(DerivedTrigger, OtherGainsMoveThePwmWhileItWaits) {
    setGains(0, proportional(256));
    setGains(100, proportional(1'024));
    const auto standing = errorOf([](int) { return 10.0F; });
    watch(ScopeSignal::Pwm, Condition::Rising, 25);
    EXPECT_EQ(run(50, standing), State::Armed) << "the PWM is 10";
    EXPECT_EQ(run(51, standing), State::Fired) << "the PWM is 40";
    expectFiredAt(99);
}

TEST_F(DerivedTrigger, GainsOfAnotherModuleDoNot) {
    setGains(0, proportional(256));
    history.noteGains({ModuleIndex(0), atMs(100), proportional(1'024)});
    watch(ScopeSignal::Pwm, Condition::Rising, 25);
    EXPECT_EQ(run(200, errorOf([](int) { return 10.0F; })), State::Armed);
}

TEST_F(DerivedTrigger, GainsThatAreForgottenWhileItWaitsAreNoEdge) {
    setGains(0, proportional(256));
    setGains(100, std::nullopt);
    const auto error = errorOf([](int i) { return i < 50 ? 100.0F : -100.0F; });
    watch(ScopeSignal::Pwm, Condition::Below, 0);
    EXPECT_EQ(run(200, error), State::Armed);
}

/// The servo is switched off 20 ms after the trigger.
TEST_F(DerivedTrigger, APictureInWhichThePwmEndsIsCompleteAllTheSame) {
    setGains(0, proportional(512));
    watch(ScopeSignal::Pwm, Condition::Rising, 40);
    const auto error = [](int i, ScopeSample& sample) {
        sample.error = sample.errorLow = sample.errorHigh = i < 50 ? 10.0F : 30.0F;
        sample.aux = i < 60 ? kServoOn : 0;
    };
    EXPECT_EQ(run(90, error), State::Fired) << "180 ms: the end is reached, but a value may still come";
    EXPECT_EQ(run(120, error), State::Complete);
    expectFiredAt(99);
}

TEST_F(DerivedTrigger, TakesTheNextEdgeWhenItIsArmedAgain) {
    setGains(0, proportional(256));
    const auto square = errorOf([](int i) { return i % 100 < 50 ? 0.0F : 100.0F; });
    watch(ScopeSignal::Pwm, Condition::Rising, 50);
    ASSERT_EQ(run(100, square), State::Complete);
    expectFiredAt(99);
    trigger.arm(atMs(200));
    EXPECT_EQ(run(150, square), State::Armed);
    EXPECT_EQ(run(151, square), State::Fired);
    expectFiredAt(299);
}

// ---- count rate ----

/// The counter stands still until 200 ms, then counts once in a millisecond: its rate over the last 100 ms
/// rises by 20 counts/s with every sample.
TEST_F(DerivedTrigger, ACountRateReachesTheLevel) {
    const auto counts = [](int i, ScopeSample& sample) {
        sample.io = sample.counted = true;
        sample.setCounter(i < 100 ? 7 : 7 + static_cast<std::uint32_t>(2 * (i - 100)));
    };
    watch(ScopeSignal::CountRate, Condition::Rising, 450);
    EXPECT_EQ(run(122, counts), State::Armed);
    EXPECT_EQ(run(123, counts), State::Fired) << "440 at 244 ms, 460 at 246 ms";
    expectFiredAt(245);
    EXPECT_EQ(run(162, counts), State::Fired);
    EXPECT_EQ(run(163, counts), State::Complete) << "up to 325 ms";
}

// ---- the user's own ----

/// The position of the watched module less that of the other one, which has a sample 1 ms after each.
TEST_F(DerivedTrigger, ADifferenceOfTwoModulesReachesTheLevel) {
    constexpr ModuleSignal kOwn{kWatched, ScopeSignal::Custom1};
    watch({.module = kWatched,
           .source = ScopeSignal::Custom1,
           .condition = Condition::Falling,
           .level = -25,
           .preTrigger = 0.2,
           .window = 0.1,
           .custom = {{kOwn,
                       {{kWatched, ScopeSignal::Position}},
                       CustomSignal::Part{{ModuleIndex(0), ScopeSignal::Position}, {-1, 0}}}}});
    const auto both = [this](int last) {
        for (int i = next; i <= last; ++i) {
            run(i, [](int n, ScopeSample& sample) { sample.position = 1'000 + 5 * n; });
            ScopeSample other;
            other.time = atMs(i * 2 + 1);
            other.position = 1'000 + (i < 50 ? 5 * i : 5 * i + (i - 49) * 10);
            history.append(ModuleIndex(0), other);
            trigger.feed(ModuleIndex(0), other);
            follow();
        }
        return trigger.state();
    };
    // The other one runs ahead by 10, 20, 30 counts at 101, 103, 105 ms; half-way between two of its samples,
    // it is 2.5 counts behind that. The difference is -2.5 at 100 ms, -12.5 at 102, -22.5 at 104 and -32.5 at
    // 106 ms, so it reaches -25 at 104.5 ms.
    EXPECT_EQ(both(52), State::Armed);
    EXPECT_EQ(both(53), State::Fired);
    expectFiredAt(104.5);
    EXPECT_EQ(both(92), State::Fired) << "the picture extends to 184.5 ms";
    EXPECT_EQ(both(93), State::Complete);
}

// ---- the samples that were fed before ----

TEST_F(DerivedTrigger, AnotherWindowKeepsWhatIsKnown) {
    watch(ScopeSignal::Acceleration, Condition::Above, 499'999);
    run(30, parabola);
    trigger.setWindow(0.05);
    EXPECT_EQ(trigger.state(), State::Off);
    trigger.arm(atMs(0));
    EXPECT_EQ(run(31, parabola), State::Fired) << "20 samples are enough";
    EXPECT_EQ(trigger.picture()->to - trigger.picture()->from, std::chrono::milliseconds(50));
}

TEST_F(DerivedTrigger, OtherDataIsNotJoinedOnTo) {
    watch(ScopeSignal::Acceleration, Condition::Above, 0);
    const auto standing = [](int, ScopeSample& sample) { sample.position = 1'000'000; };
    run(30, [](int, ScopeSample&) {});
    derived.forget();
    history = History(2);
    fed = 0;
    trigger.forgetSamples();
    EXPECT_EQ(run(100, standing), State::Armed) << "nothing moved";
}

}  // namespace
}  // namespace nmc
