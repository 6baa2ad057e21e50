// SPDX-License-Identifier: GPL-3.0-or-later
// The calculated command position against the simulator's own, engine and chain together in virtual time. The
// model knows a command's moment to half a tick, and the chip's command is a staircase of ticks: so it must
// be within one tick of travel in motion, and exact at standstill (scope.md).
#include <gtest/gtest.h>

#include <cmath>

#include "model/commandposition.h"
#include "servofixture.h"
#include "tests/support/virtualbus.h"

namespace nmc {
namespace {

using namespace testing_support;
using bus::Outcome;
using test::VirtualBus;

class CommandTruth : public testing::TestWithParam<std::uint32_t> {
protected:
    void SetUp() override {
        ASSERT_TRUE(m_bus.connect());
        // The longer the tick, the weaker: a motor that swings would be stopped.
        const auto kp = static_cast<std::uint16_t>(200 / m_divisor);
        const auto kd = static_cast<std::uint16_t>(2'000 / (m_divisor * m_divisor));
        ASSERT_EQ(perform({servo::SetGain{kp, kd, 0, 200, 255, 0, 16'000, m_divisor, std::uint8_t{0}}}),
                  Outcome::Done);
        ASSERT_EQ(perform({stopWith(servo::StopManner::Abruptly)}), Outcome::Done);
    }

    std::optional<Outcome> perform(std::vector<ServoCommand> commands) {
        std::vector<bus::Step> steps;
        for (ServoCommand& command : commands)
            steps.push_back({ModuleIndex(0), std::move(command)});
        const auto outcome = m_bus.perform(std::move(steps));
        follow();
        return outcome;
    }

    void follow() {
        for (; m_followed < m_bus.events.size(); ++m_followed) {
            const bus::Event& event = m_bus.events[m_followed];
            if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
                m_command.apply(*executed);
            else if (const auto* sample = std::get_if<bus::Sample>(&event))
                m_command.apply(*sample);
        }
    }

    /// Watches for a while.
    void expectTruthFor(double seconds, double toleranceCounts) {
        for (const TimePoint end = m_bus.now + fromSeconds(seconds); m_bus.now < end;) {
            m_bus.runFor(std::chrono::microseconds(777));
            follow();
            const auto calculated = m_command.at(m_bus.now);
            ASSERT_TRUE(calculated.has_value());
            ASSERT_NEAR(*calculated, m_bus.servo(0).commandPosition, toleranceCounts + 0.02)
                << "at " << toSeconds(m_bus.now.time_since_epoch());
        }
    }
    void expectExactly(double position) {
        EXPECT_EQ(m_command.at(m_bus.now), position);
        EXPECT_EQ(m_bus.servo(0).commandPosition, position);
    }

    const std::uint8_t m_divisor = static_cast<std::uint8_t>(GetParam());
    VirtualBus m_bus{{{ModuleType::Servo, 4}}, bus::EngineConfig{115'200}};
    CommandPosition m_command;
    std::size_t m_followed = 0;
};

TEST_P(CommandTruth, HoldsInTrapezoidalMovesOfTenSpeeds) {
    std::int32_t goal = 0;
    for (int i = 1; i <= 10; ++i) {
        const double velocity = 0.8 * i;
        const std::uint32_t acceleration = 150U * static_cast<unsigned>(i);
        goal = (i % 2 == 0 ? -1 : 1) * 700 * i;
        const auto raw = static_cast<std::uint32_t>(velocity * 65'536);
        ASSERT_EQ(perform({trapezoid(goal, raw, acceleration), StartMotion{}}), Outcome::Done);
        const double ticks = 2 * 7'000 / velocity + 2 * velocity * 65'536 / acceleration;
        expectTruthFor((ticks + 20) * 0.000512 * m_divisor, velocity);
        if (HasFatalFailure())
            return;
        expectExactly(goal);
    }
}

TEST_P(CommandTruth, HoldsWhenAVelocityChangesOnTheFlyAndInBothStops) {
    // A change by dv at a moment that is off by half a tick leaves dv/2 counts; half a tick of the staircase
    // is v/2.
    double doubt = 0;
    double before = 0;
    for (const double velocity : {0.5, 6.0, -6.0, 2.0}) {
        const auto raw = static_cast<std::uint32_t>(std::abs(velocity) * 65'536);
        ASSERT_EQ(perform({velocityMode(raw, 1'311, velocity < 0)}), Outcome::Done);
        doubt += std::abs(velocity - before) / 2;
        expectTruthFor(0.4 * m_divisor, doubt + std::max(std::abs(velocity), std::abs(before)) / 2);
        before = velocity;
    }
    ASSERT_EQ(perform({stopWith(servo::StopManner::Smoothly)}), Outcome::Done);
    doubt += before / 2;
    expectTruthFor(0.2 * m_divisor, doubt + before / 2);
    ASSERT_EQ(perform({velocityMode(4 << 16, 1'311)}), Outcome::Done);
    doubt += 4.0 / 2;
    expectTruthFor(0.3 * m_divisor, doubt + 4.0 / 2);
    ASSERT_EQ(perform({stopWith(servo::StopManner::Abruptly)}), Outcome::Done);
    doubt += 4.0;  // it freezes between two steps of the staircase
    expectTruthFor(0.1 * m_divisor, doubt);
    // The next move ends exactly where it was told to, and every doubt with it.
    ASSERT_EQ(perform({trapezoid(100, 8 << 16, 3'000), StartMotion{}}), Outcome::Done);
    m_bus.runFor(fromSeconds(4.0 * m_divisor));
    follow();
    expectExactly(100);
}

INSTANTIATE_TEST_SUITE_P(ServoRateDivisors, CommandTruth, testing::Values(1U, 3U, 10U));

}  // namespace
}  // namespace nmc
