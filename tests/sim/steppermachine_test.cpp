// SPDX-License-Identifier: GPL-3.0-or-later
// The shaft on a stepper: hard stops, and switches that it operates.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sim/control.h"
#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

class StepperMachineTest : public testing::Test {
protected:
    StepperMachineTest() { wire.parameters(k1x); }

    nlohmann::json say(std::string_view line) {
        return nlohmann::json::parse(handleControlLine(wire.chain, line, wire.now));
    }
    void must(std::string_view line) { EXPECT_EQ(say(line), (nlohmann::json{{"ok", true}})) << line; }
    nlohmann::json state() { return say("state 1"); }
    void moveTo(std::int32_t goal) {
        wire.load({.position = goal, .count = kCount});
        static_cast<void>(wire.timeToStop());
    }
    void run(bool reverse = false) { wire.load({.count = kCount, .reverse = reverse}); }
    StepperWire wire;
};

TEST_F(StepperMachineTest, AStepperThatRunsIntoAStopLosesSteps) {
    must("set 1 travel_max 100");
    must("set 1 travel_min -150");
    moveTo(300);
    EXPECT_EQ(state()["position"], 300);
    EXPECT_EQ(state()["shaft"], 100);
    EXPECT_EQ(wire.stepReport().position, 300) << "the chip does not know";
    EXPECT_EQ(state()["inputs"]["limit1"], false) << "limits are manual";
    moveTo(60);
    EXPECT_EQ(state()["shaft"], -140);
    moveTo(40);
    EXPECT_EQ(state()["shaft"], -150);
    must("set 1 travel_min none");
    moveTo(0);
    EXPECT_EQ(state()["shaft"], -190);
}

TEST_F(StepperMachineTest, AutomaticLimitsFollowTheTravelAndStopTheMotor) {
    must("set 1 travel_max 100");
    must("set 1 travel_min -100");
    must("set 1 limits auto");
    for (const bool reverse : {false, true}) {
        const char* own = reverse ? "limit2" : "limit1";
        const char* other = reverse ? "limit1" : "limit2";
        run(reverse);
        wire.wait(milliseconds(90));
        EXPECT_TRUE(wire.step().moving);
        EXPECT_EQ(state()["inputs"][own], false);
        wire.wait(milliseconds(400));
        EXPECT_FALSE(wire.step().moving);
        EXPECT_EQ(state()["shaft"], reverse ? -100 : 100);
        EXPECT_EQ(state()["inputs"][own], true);
        EXPECT_EQ(state()["inputs"][other], false);
        EXPECT_EQ(wire.stepReport().inputs, reverse ? 0x10U : 0x08U);
        EXPECT_EQ(wire.position(), reverse ? -100 : 100) << "half a step a tick: none is lost";
    }
    run();
    wire.wait(milliseconds(20));
    EXPECT_EQ(wire.stepReport().inputs, 0U);
    wire.stop(0x05);
    must("set 1 limits manual");
    must("set 1 limit1 1");
    EXPECT_EQ(wire.stepReport().inputs, 0x08U);
}

TEST_F(StepperMachineTest, AWholeRunInOneGoEndsAtTheSwitchAsInSmallSlices) {
    const auto end = [](Duration slice) {
        StepperWire fast;
        fast.parameters(k8x);
        fast.set(Input::TravelMax, 70'000);
        fast.set(Input::Limits, 1);
        fast.load({.count = std::uint16_t{65'452}});  // 50 000/s
        for (const TimePoint until = fast.now + milliseconds(2520); fast.now < until;)
            fast.wait(slice);
        EXPECT_EQ(fast.step().shaft, 70'000);
        // It makes 25.6 steps in the tick in which it arrives there.
        EXPECT_NEAR(fast.position(), 70'013, 13);
        return fast.position();
    };
    EXPECT_EQ(end(milliseconds(2520)), end(std::chrono::microseconds(700)));
}

TEST_F(StepperMachineTest, TheHomeSwitchIsClosedFromItsPlaceOnForward) {
    must("set 1 home_switch_at 50");
    EXPECT_EQ(state()["inputs"]["home_switch"], false);
    wire.command(1, 0x19, {0x18});  // capture on a change, stop abruptly
    run();
    wire.wait(milliseconds(500));
    EXPECT_FALSE(wire.step().moving);
    EXPECT_EQ(wire.stepReport().home, 50);
    EXPECT_EQ(wire.stepReport().inputs, 0x20U);
    moveTo(1000);
    EXPECT_EQ(state()["inputs"]["home_switch"], true);
    moveTo(49);
    EXPECT_EQ(state()["inputs"]["home_switch"], false);
    must("set 1 home_switch_at none");
    moveTo(1000);
    EXPECT_EQ(state()["inputs"]["home_switch"], false);
    must("set 1 home_switch 1");
    EXPECT_EQ(state()["inputs"]["home_switch"], true);
}

TEST_F(StepperMachineTest, TheHomeSwitchIsBehindTheLoadsPlay) {
    must("set 1 home_switch_at 50");
    must("set 1 load_play 20");
    moveTo(69);
    EXPECT_EQ(state()["inputs"]["home_switch"], false);
    moveTo(70);
    EXPECT_EQ(state()["inputs"]["home_switch"], true);
    moveTo(50);
    EXPECT_EQ(state()["inputs"]["home_switch"], true) << "the shaft turns within the play";
    moveTo(49);
    EXPECT_EQ(state()["inputs"]["home_switch"], false);
    EXPECT_EQ(state()["load_play"], 20);
}

TEST_F(StepperMachineTest, WhatFollowsTheShaftCannotBeSetNorAStopPutBeyondIt) {
    must("set 1 limits auto");
    EXPECT_EQ(say("set 1 limit1 1")["error"],
              "the limit switches follow the travel; use limits manual first");
    EXPECT_EQ(say("set 1 limit2 1")["error"],
              "the limit switches follow the travel; use limits manual first");
    must("set 1 home_switch_at -5");
    EXPECT_EQ(state()["inputs"]["home_switch"], true) << "at once";
    EXPECT_EQ(say("set 1 home_switch 0")["error"],
              "the home switch follows the shaft; use home_switch_at none first");
    EXPECT_THAT(say("set 1 travel_min 5").value("error", ""), HasSubstr("allowed is up to that"));
    EXPECT_THAT(say("set 1 travel_max -5").value("error", ""), HasSubstr("allowed is from that on"));
    EXPECT_THAT(say("set 1 travel_max 0.5").value("error", ""), HasSubstr("counts or none"));
    EXPECT_THAT(say("set 1 limits 1").value("error", ""), HasSubstr("auto or manual"));
    must("set 1 travel_max 0");
    EXPECT_EQ(state()["inputs"]["limit1"], true);
    must("set 1 travel_max none");
    EXPECT_EQ(state()["inputs"]["limit1"], false);
}

TEST_F(StepperMachineTest, NeitherResetPositionNorPowerMovesTheShaft) {
    must("set 1 home_switch_at 150");
    moveTo(100);
    wire.command(1, 0x00);
    EXPECT_EQ(state()["position"], 0);
    EXPECT_EQ(state()["shaft"], 100);
    moveTo(60);
    EXPECT_EQ(state()["shaft"], 160);
    must("power-cycle 1");
    wire.wait(milliseconds(10));
    EXPECT_EQ(state()["position"], 0);
    EXPECT_EQ(state()["shaft"], 160);
    EXPECT_EQ(state()["inputs"]["home_switch"], true);
}

TEST_F(StepperMachineTest, ADisabledDriverDoesNotTurnTheShaft) {
    wire.stop(0x00);
    moveTo(100);
    EXPECT_EQ(state()["position"], 100);
    EXPECT_EQ(state()["shaft"], 0);
    wire.stop(0x01);
    moveTo(0);
    EXPECT_EQ(state()["shaft"], -100);
}

TEST_F(StepperMachineTest, TheShaftCountsOnWhereThePositionCounterWraps) {
    wire.parameters(k8x | kIgnoreLimits);
    wire.load({.count = std::uint16_t{65'452}});
    wire.wait(seconds(100'000));  // 5e9 steps, more than 2^32, in one go
    wire.stop(0x05);
    const auto s = state();
    EXPECT_NEAR(s["shaft"].get<double>(), 5e9, 3000);
    // 2^32 = 4 294 967 296.
    EXPECT_EQ(s["shaft"].get<std::int64_t>() - 4'294'967'296, s["position"].get<std::int64_t>());
}

}  // namespace
}  // namespace nmc::sim::test
