// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scope/scopetrigger.h"

#include <gtest/gtest.h>

#include <limits>

#include "scopesamples.h"

namespace nmc {
namespace {

using Condition = TriggerSettings::Condition;
using State = ScopeTrigger::State;
using testing_support::atMs;

constexpr ModuleIndex kAxis{2};
constexpr ModuleIndex kOther{0};

/// 20 ms before the trigger, 80 ms after it.
TriggerSettings watching(std::variant<ScopeSignal, ScopeBit> source, Condition condition,
                         double level = 0.0) {
    return {.module = kAxis,
            .source = source,
            .condition = condition,
            .level = level,
            .preTrigger = 0.2,
            .window = 0.1};
}

ScopeSample position(int milliseconds, std::int32_t counts) {
    ScopeSample sample;
    sample.time = atMs(milliseconds);
    sample.position = counts;
    return sample;
}
ScopeSample status(int milliseconds, std::uint8_t bits) {
    ScopeSample sample = position(milliseconds, 0);
    sample.status = bits;
    return sample;
}
ScopeSample error(int milliseconds, float counts) {
    ScopeSample sample = position(milliseconds, 100);
    sample.error = counts;
    return sample;
}

/// A trigger that is armed at 100 ms, with samples since 0 ms that do not trigger.
class ScopeTriggerTest : public testing::Test {
protected:
    void armed(const TriggerSettings& settings, ScopeSample before = position(0, 0)) {
        trigger.set(settings);
        before.time = atMs(0);
        trigger.feed(kAxis, before);
        trigger.arm(atMs(100));
        before.time = atMs(100);
        EXPECT_EQ(trigger.feed(kAxis, before), State::Armed);
    }
    State feed(const ScopeSample& sample) { return trigger.feed(kAxis, sample); }

    ScopeTrigger trigger;
};

TEST_F(ScopeTriggerTest, ARisingEdgeIsWhereTheLineCrossesTheLevel) {
    armed(watching(ScopeSignal::Position, Condition::Rising, 150));
    EXPECT_EQ(feed(position(110, 100)), State::Armed);
    EXPECT_EQ(feed(position(120, 200)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(115)) << "100 at 110 ms, 200 at 120 ms";
    EXPECT_EQ(trigger.picture(), (ScopeTrigger::Picture{atMs(95), atMs(195)}));
    EXPECT_EQ(feed(position(194, 0)), State::Fired);
    EXPECT_EQ(feed(position(195, 500)), State::Complete);
    EXPECT_EQ(trigger.firedAt(), atMs(115));
}

TEST_F(ScopeTriggerTest, AFallingEdgeIsWhereTheLineCrossesTheLevel) {
    armed(watching(ScopeSignal::Position, Condition::Falling, -30));
    EXPECT_EQ(feed(position(110, -20)), State::Armed);
    EXPECT_EQ(feed(position(120, 40)), State::Armed);
    EXPECT_EQ(feed(position(130, -60)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(127)) << "40 at 120 ms, -60 at 130 ms";
}

TEST_F(ScopeTriggerTest, AnEdgeComesTrulyFromTheOtherSide) {
    armed(watching(ScopeSignal::Position, Condition::Rising, 50), position(0, 50));
    EXPECT_EQ(feed(position(110, 80)), State::Armed) << "it was at the level";
    EXPECT_EQ(feed(position(120, 50)), State::Armed);
    EXPECT_EQ(feed(position(130, 80)), State::Armed);
    EXPECT_EQ(feed(position(140, 49)), State::Armed);
    EXPECT_EQ(feed(position(150, 50)), State::Fired) << "reaching it is enough";
    EXPECT_EQ(trigger.firedAt(), atMs(150));
}

TEST_F(ScopeTriggerTest, NoEdgeLiesInAGap) {
    armed(watching(ScopeSignal::Position, Condition::Rising, 50));
    ScopeSample afterGap = position(120, 100);
    afterGap.gapBefore = true;
    EXPECT_EQ(feed(afterGap), State::Armed);
    EXPECT_EQ(feed(position(130, 0)), State::Armed);
    EXPECT_EQ(feed(position(140, 100)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(135));
}

TEST_F(ScopeTriggerTest, NoEdgeLiesWhereTheSignalWasNotKnown) {
    armed(watching(ScopeSignal::Error, Condition::Rising, 5), error(0, 0.0F));
    EXPECT_EQ(feed(error(110, ScopeSample::kUnknown)), State::Armed);
    EXPECT_EQ(feed(error(120, 10.0F)), State::Armed);
    EXPECT_EQ(feed(error(130, 0.0F)), State::Armed);
    EXPECT_EQ(feed(error(140, 10.0F)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(135));
}

TEST_F(ScopeTriggerTest, WatchesEachSignal) {
    struct Case {
        ScopeSignal signal;
        double level;
    };
    // Position 100, error -4, velocity -250 and A/D 130, after all were 0: each crosses its level half-way.
    ScopeSample after = error(120, -4.0F);
    after.velocity = -250.0F;
    after.analog = 130;
    ScopeSample before = error(100, 0.0F);
    before.position = 0;
    before.velocity = 0.0F;
    for (const Case& c : {Case{ScopeSignal::Position, 50},
                          {ScopeSignal::Command, 48},
                          {ScopeSignal::Error, -2},
                          {ScopeSignal::Velocity, -125},
                          {ScopeSignal::Analog, 65}}) {
        armed(watching(c.signal, c.level > 0 ? Condition::Rising : Condition::Falling, c.level), before);
        EXPECT_EQ(feed(after), State::Fired) << static_cast<int>(c.signal);
        EXPECT_EQ(trigger.firedAt(), atMs(110)) << static_cast<int>(c.signal);
    }
}

TEST_F(ScopeTriggerTest, APositionThatWrapsDoesNotCrossTheLevelsInBetween) {
    constexpr std::int32_t kTop = std::numeric_limits<std::int32_t>::max();
    armed(watching(ScopeSignal::Position, Condition::Falling, 0), position(0, kTop - 10));
    EXPECT_EQ(feed(position(110, -kTop)), State::Armed);
    armed(watching(ScopeSignal::Position, Condition::Rising, kTop), position(0, kTop - 1));
    EXPECT_EQ(feed(position(110, -kTop)), State::Fired) << "three counts further, across the wrap";
}

TEST_F(ScopeTriggerTest, ABitIsSetOrClearedAtTheSampleThatShowsIt) {
    const ScopeBit bit3{ScopeBit::Byte::Status, 3};
    armed(watching(bit3, Condition::Rising, 77), status(0, 0xF7));
    EXPECT_EQ(feed(status(110, 0xF0)), State::Armed);
    EXPECT_EQ(feed(status(120, 0x08)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(120));
    armed(watching(bit3, Condition::Falling), status(0, 0x08));
    EXPECT_EQ(feed(status(110, 0xFF)), State::Armed);
    EXPECT_EQ(feed(status(120, 0xF7)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(120));
}

TEST_F(ScopeTriggerTest, TheAuxByteHasBitsOfItsOwn) {
    armed(watching(ScopeBit{ScopeBit::Byte::Aux, 0}, Condition::Rising), status(0, 0x00));
    EXPECT_EQ(feed(status(110, 0xFF)), State::Armed);
    ScopeSample aux = status(120, 0x00);
    aux.aux = 0x01;
    EXPECT_EQ(feed(aux), State::Fired);
}

TEST_F(ScopeTriggerTest, ALevelTriggersWhenItHoldsAlready) {
    trigger.set(watching(ScopeSignal::Position, Condition::Above, 50));
    feed(position(0, 90));
    trigger.arm(atMs(100));
    EXPECT_EQ(feed(position(105, 50)), State::Armed) << "not above";
    EXPECT_EQ(feed(position(110, 90)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(110));
    trigger.set(watching(ScopeSignal::Position, Condition::Below, 50));
    trigger.arm(atMs(200));
    EXPECT_EQ(feed(position(210, 90)), State::Armed);
    EXPECT_EQ(feed(position(220, 10)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(220));
    trigger.set(watching(ScopeBit{ScopeBit::Byte::Status, 7}, Condition::Below));
    trigger.arm(atMs(300));
    EXPECT_EQ(feed(status(310, 0x80)), State::Armed);
    EXPECT_EQ(feed(status(320, 0x7F)), State::Fired);
}

TEST_F(ScopeTriggerTest, WaitsUntilThereIsEnoughBeforeTheTrigger) {
    trigger.set(watching(ScopeSignal::Position, Condition::Rising, 50));
    trigger.arm(atMs(100));
    EXPECT_EQ(feed(position(100, 0)), State::Armed);
    EXPECT_EQ(feed(position(118, 100)), State::Armed) << "crossed at 109 ms: there are 9 of 20 ms before it";
    EXPECT_EQ(feed(position(119, 0)), State::Armed);
    EXPECT_EQ(feed(position(121, 100)), State::Fired) << "crossed at 120 ms";
    EXPECT_EQ(trigger.picture()->from, atMs(100));
}

TEST_F(ScopeTriggerTest, SamplesOfOtherModulesAndFromBeforeArmingCountAsBefore) {
    trigger.set(watching(ScopeSignal::Position, Condition::Rising, 50));
    trigger.feed(kOther, position(85, 0));
    feed(position(90, 0));
    trigger.arm(atMs(100));
    EXPECT_EQ(feed(position(120, 100)), State::Fired);
    EXPECT_EQ(trigger.picture()->from, atMs(85));
    trigger.forgetSamples();
    trigger.arm(atMs(130));
    feed(position(130, 0));
    EXPECT_EQ(feed(position(140, 100)), State::Armed) << "the history was emptied";
}

TEST_F(ScopeTriggerTest, AnEdgeFromBeforeArmingDoesNotTrigger) {
    trigger.set(watching(ScopeSignal::Position, Condition::Rising, 50));
    feed(position(0, 0));
    trigger.arm(atMs(100));
    EXPECT_EQ(feed(position(110, 100)), State::Armed) << "crossed at 55 ms";
    EXPECT_EQ(feed(position(120, 0)), State::Armed);
    EXPECT_EQ(feed(position(130, 100)), State::Fired);
}

TEST_F(ScopeTriggerTest, OtherModulesDoNotTrigger) {
    armed(watching(ScopeSignal::Position, Condition::Rising, 50));
    EXPECT_EQ(trigger.feed(kOther, position(110, 0)), State::Armed);
    EXPECT_EQ(trigger.feed(kOther, position(120, 100)), State::Armed);
    EXPECT_EQ(feed(position(130, 100)), State::Fired);
    EXPECT_EQ(trigger.feed(kOther, position(900, 0)), State::Fired)
        << "the samples of the axis are still missing";
    EXPECT_EQ(feed(position(900, 0)), State::Complete);
}

TEST_F(ScopeTriggerTest, ASinglePictureStaysUntilItIsArmedAgain) {
    armed(watching(ScopeSignal::Position, Condition::Rising, 50));
    feed(position(120, 100));
    ASSERT_EQ(feed(position(400, 0)), State::Complete);
    EXPECT_EQ(feed(position(420, 100)), State::Complete);
    EXPECT_EQ(trigger.firedAt(), atMs(110));
    trigger.arm(atMs(430));
    EXPECT_EQ(trigger.firedAt(), std::nullopt);
    EXPECT_EQ(trigger.picture(), std::nullopt);
    feed(position(440, 0));
    EXPECT_EQ(feed(position(460, 100)), State::Fired);
    EXPECT_EQ(trigger.firedAt(), atMs(450));
}

TEST_F(ScopeTriggerTest, IsOffUntilArmedAndAfterOtherSettings) {
    EXPECT_EQ(trigger.state(), State::Off);
    trigger.set(watching(ScopeSignal::Position, Condition::Above, 0));
    EXPECT_EQ(feed(position(0, 100)), State::Off);
    trigger.arm(atMs(50));
    EXPECT_EQ(feed(position(60, 100)), State::Fired);
    trigger.disarm();
    EXPECT_EQ(trigger.state(), State::Off);
    EXPECT_EQ(trigger.picture(), std::nullopt);
    trigger.arm(atMs(60));
    trigger.set(watching(ScopeSignal::Position, Condition::Above, 200));
    EXPECT_EQ(feed(position(70, 300)), State::Off);
}

TEST_F(ScopeTriggerTest, ThePictureMayLieWhollyBeforeOrBehindTheTrigger) {
    TriggerSettings settings = watching(ScopeSignal::Position, Condition::Rising, 50);
    settings.preTrigger = 1.0;
    armed(settings);
    EXPECT_EQ(feed(position(120, 100)), State::Complete) << "all of it is there";
    EXPECT_EQ(trigger.picture(), (ScopeTrigger::Picture{atMs(10), atMs(110)}));
    settings.preTrigger = 0.0;
    armed(settings);
    EXPECT_EQ(feed(position(120, 100)), State::Fired);
    EXPECT_EQ(trigger.picture(), (ScopeTrigger::Picture{atMs(110), atMs(210)}));
}

TEST_F(ScopeTriggerTest, SettingsWithoutSenseDoNoHarm) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    for (const double window : {0.0, -1.0, kNone, kInfinite})
        for (const double share : {-1.0, kNone, kInfinite}) {
            TriggerSettings settings = watching(ScopeSignal::Position, Condition::Rising, 50);
            settings.window = window;
            settings.preTrigger = share;
            armed(settings);
            feed(position(120, 100));
            const auto picture = trigger.picture();
            EXPECT_TRUE(!picture || picture->to > picture->from);
        }
    armed(watching(ScopeSignal::Position, Condition::Rising, kNone));
    EXPECT_EQ(feed(position(120, 100)), State::Armed);
}

}  // namespace
}  // namespace nmc
