// SPDX-License-Identifier: GPL-3.0-or-later
// DS-S 5.1, Table 4: which mode may follow which, and what must be loaded for the transition.
#include <memory>

#include "tests/sim/stepperwire.h"

namespace nmc::sim::test {
namespace {

using Kinds = std::vector<ViolationKind>;
using enum StepperMode;

constexpr std::int32_t kFar = 1'000'000;

/// Brings a new stepper into a mode.
std::unique_ptr<StepperWire> inMode(StepperMode mode) {
    auto wire = std::make_unique<StepperWire>();
    wire->parameters(k1x, 10);
    wire->load({.speed = std::uint8_t{60}, .acceleration = std::uint8_t{4}, .start = false});
    switch (mode) {
        case Stopped:
            break;
        case Trapezoidal:
            wire->load({.position = kFar});
            break;
        case Velocity:
            wire->load({});
            break;
        case UnprofiledWithStop:
            wire->load({.position = kFar, .count = kCount, .nearest = 40});
            break;
        case Unprofiled:
            wire->load({.count = kCount, .nearest = 40});
            break;
    }
    EXPECT_EQ(wire->step().mode, mode);
    EXPECT_EQ(wire->violations(), Kinds{});
    return wire;
}

/// The parameters that lead to the mode `goal`, from standstill or in motion.
Load toward(StepperMode goal, bool fromStandstill) {
    Load l;
    if (goal == Trapezoidal || (goal == UnprofiledWithStop && fromStandstill))
        l.position = kFar + 1000;
    if (goal == UnprofiledWithStop || goal == Unprofiled) {
        l.count = kCount + 100;
        l.nearest = 48;
    }
    return l;
}

TEST(ModeTable, AllTransitionsAreAsInTable4) {
    struct Row {
        StepperMode goal;
        // From stopped, trapezoidal, velocity profile, unprofiled with a stop, unprofiled without.
        bool allowed[5];
    };
    constexpr StepperMode kFrom[] = {Stopped, Trapezoidal, Velocity, UnprofiledWithStop, Unprofiled};
    constexpr Row kRows[] = {
        {Trapezoidal, {true, false, false, false, false}},
        {Velocity, {true, true, true, true, true}},
        {UnprofiledWithStop, {true, true, false, true, false}},
        {Unprofiled, {true, false, true, false, true}},
    };
    for (const Row& row : kRows) {
        for (std::size_t i = 0; i < 5; ++i) {
            SCOPED_TRACE(std::string(toText(kFrom[i])) + " " + std::to_string(i) + " to " +
                         std::string(toText(row.goal)));
            // A timer count alone means "with a stop" where the present mode has one, and "without" where it
            // has none, so two cells cannot be requested. With a position, it means "with a stop".
            const bool timerOnlyMeansStop =
                row.goal == Unprofiled && (kFrom[i] == Trapezoidal || kFrom[i] == UnprofiledWithStop);
            const auto wire = inMode(kFrom[i]);
            Load load = toward(row.goal, kFrom[i] == Stopped);
            if (row.goal == UnprofiledWithStop && (kFrom[i] == Velocity || kFrom[i] == Unprofiled))
                load.position = kFar;
            if (row.goal == Velocity && kFrom[i] == Trapezoidal) {
                load.speed = 30;  // distinguishes it from "unprofiled with stop"
                load.count = kCount;
                load.nearest = 40;
            }
            wire->load(load);
            if (timerOnlyMeansStop) {
                EXPECT_EQ(wire->step().mode, UnprofiledWithStop);
                continue;
            }
            EXPECT_EQ(wire->step().mode, row.allowed[i] ? row.goal : kFrom[i]);
            EXPECT_EQ(wire->violations(), row.allowed[i] ? Kinds{} : Kinds{ViolationKind::ModeTransition});
        }
    }
}

TEST(ModeTable, FromAnyModeToStoppedWithTheStopCommand) {
    for (const StepperMode from : {Stopped, Trapezoidal, Velocity, UnprofiledWithStop, Unprofiled}) {
        for (const unsigned control : {0x05U, 0x09U}) {
            const auto wire = inMode(from);
            wire->stop(control);
            static_cast<void>(wire->timeToStop());
            EXPECT_EQ(wire->step().mode, Stopped);
            EXPECT_LT(wire->position(), 10'000);
            EXPECT_EQ(wire->violations(), Kinds{});
            EXPECT_EQ(wire->stepReport().status & 0x75U, 0x04U) << "the amplifier stays on";
        }
    }
}

TEST(ModeTable, AParameterMarkedDoNotLoadIsAViolationAndNothingIsExecuted) {
    struct Case {
        StepperMode from;
        Load load;
    };
    const Case cases[] = {
        {Stopped, {.position = 5, .speed = std::uint8_t{9}, .count = kCount}},
        {Stopped, {.acceleration = std::uint8_t{9}, .count = kCount}},
        {Velocity, {.speed = std::uint8_t{9}, .count = kCount}},
        {Velocity, {.position = 5, .speed = std::uint8_t{9}}},
        {UnprofiledWithStop, {.position = 5, .count = kCount}},
        {UnprofiledWithStop, {.speed = std::uint8_t{9}, .count = kCount}},
        {Unprofiled, {.acceleration = std::uint8_t{9}, .count = kCount}},
        {Trapezoidal, {.position = 5, .count = kCount}},
        {Trapezoidal, {.speed = std::uint8_t{9}}},  // The timer count must be loaded.
    };
    for (const Case& c : cases) {
        const auto wire = inMode(c.from);
        wire->wait(std::chrono::milliseconds(300));
        const StepperSnapshot before = wire->step();
        wire->load(c.load);
        EXPECT_EQ(wire->violations(), Kinds{ViolationKind::ModeTransition}) << toText(c.from);
        EXPECT_EQ(wire->step().mode, c.from);
        EXPECT_EQ(wire->step().stepRate, before.stepRate);
        EXPECT_EQ(wire->step().timerCount, before.timerCount);
    }
}

TEST(ModeTable, AParameterThatIsNotLoadedKeepsItsValue) {
    const auto wire = inMode(Stopped);  // Speed 60, acceleration time 4 are loaded.
    wire->load({.position = 2000});
    wire->wait(std::chrono::milliseconds(100));
    EXPECT_EQ(wire->step().speed, 60U);
    static_cast<void>(wire->timeToStop());
    wire->load({.position = 0, .speed = std::uint8_t{30}});
    wire->wait(std::chrono::milliseconds(100));
    EXPECT_EQ(wire->step().speed, 30U);
    EXPECT_EQ(wire->violations(), Kinds{});
}

TEST(ModeTable, AnUnprofiledMoveOutOfATrapezoidStopsAtItsGoal) {
    const auto wire = inMode(Stopped);
    wire->load({.position = 2000});
    wire->wait(std::chrono::milliseconds(300));
    wire->load({.count = kCount, .nearest = 40});
    EXPECT_NEAR(wire->step().stepRate, 1000, 1e-9);
    static_cast<void>(wire->timeToStop());
    EXPECT_EQ(wire->position(), 2000);
}

TEST(ModeTable, AVelocityProfileOutOfATrapezoidBeginsAtTheLoadedNearestSpeed) {
    const auto wire = inMode(Trapezoidal);
    wire->wait(std::chrono::milliseconds(300));
    wire->load(
        {.speed = std::uint8_t{20}, .acceleration = std::uint8_t{200}, .count = kCount, .nearest = 40});
    EXPECT_EQ(wire->step().speed, 40U);
    wire->wait(std::chrono::milliseconds(75));  // 50 ms for each speed
    EXPECT_EQ(wire->step().speed, 39U);
}

TEST(StepDirection, CannotBeChangedWithoutAStop) {
    for (const StepperMode mode : {Velocity, Unprofiled}) {
        const auto wire = inMode(mode);
        Load back = toward(mode, false);
        back.reverse = true;
        wire->load(back);
        EXPECT_EQ(wire->violations(), Kinds{ViolationKind::DirectionChange});
        EXPECT_FALSE(wire->step().reverse);
        EXPECT_GT(wire->stepsIn(std::chrono::milliseconds(100)), 0);
        wire->stop(0x05);
        wire->load(back);
        EXPECT_EQ(wire->violations().size(), 1U);
        EXPECT_TRUE(wire->step().reverse);
        EXPECT_LT(wire->stepsIn(std::chrono::milliseconds(300)), 0);
    }
}

TEST(StepperParameters, MustBeSetBeforeAnyMotion) {
    StepperWire wire;
    wire.load({.count = kCount});
    EXPECT_EQ(wire.violations(), Kinds{ViolationKind::ParametersNotSet});
    EXPECT_EQ(wire.stepsIn(std::chrono::seconds(1)), 0);
    wire.parameters(k1x);
    wire.load({.count = kCount});
    EXPECT_GT(wire.stepsIn(std::chrono::seconds(1)), 990);
    wire.command(0xFF, 0x0F);
    wire.wait(std::chrono::milliseconds(10));
    wire.address(1);
    wire.load({.count = kCount});
    EXPECT_EQ(wire.violations().size(), 2U) << "a reset forgets them";
}

TEST(StepperParameters, SpeedModeAndMinimumSpeedAreIgnoredInMotion) {
    const auto wire = inMode(Velocity);
    wire->wait(std::chrono::milliseconds(300));
    wire->parameters(k8x, 30, 111, 22);
    EXPECT_NEAR(wire->step().stepRate, 60 * 25, 1e-9);
    EXPECT_EQ(wire->step().currentLimit, 111) << "the other parameters take effect";
    wire->load({.speed = std::uint8_t{1}});
    wire->wait(std::chrono::milliseconds(500));
    EXPECT_NEAR(wire->step().stepRate, 10 * 25, 1e-9);
    wire->stop(0x05);
    wire->load({});
    EXPECT_NEAR(wire->step().stepRate, 10 * 25, 1e-9) << "they do not take effect later either";
}

}  // namespace
}  // namespace nmc::sim::test
