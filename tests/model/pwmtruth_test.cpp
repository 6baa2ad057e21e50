// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the reconstructed PWM value with the one that the simulated module set in the very tick in which
// it latched each sample. Engine and chain run together in virtual time.
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "model/scope/pwmoutput.h"
#include "model/scope/scopefeed.h"
#include "servofixture.h"
#include "tests/support/virtualbus.h"

namespace nmc {
namespace {

using namespace testing_support;
using servo::StopManner;

class PwmTruth : public testing::Test {
protected:
    PwmTruth() : bus(test::servos(1), {}, options()) {}

    void enable(const servo::SetGain& wanted) {
        gains = wanted;
        ASSERT_TRUE(bus.connect());
        perform({wanted});
        perform({stopWith(StopManner::Abruptly)});
    }
    void perform(std::vector<ServoCommand> commands) {
        std::vector<bus::Order> steps;
        for (ServoCommand& next : commands)
            steps.push_back({ModuleIndex(0), std::move(next)});
        ASSERT_EQ(bus.perform(std::move(steps)), bus::Outcome::Done);
        follow();
    }
    void runFor(double seconds) {
        bus.runFor(fromSeconds(seconds));
        follow();
    }
    [[nodiscard]] double inside() const {
        return static_cast<double>(std::count(m_inside.begin(), m_inside.end(), true)) /
               static_cast<double>(std::max<std::size_t>(m_inside.size(), 1));
    }
    [[nodiscard]] double halfBand(double share) {
        std::sort(m_halfBands.begin(), m_halfBands.end());
        return m_halfBands[static_cast<std::size_t>(share * static_cast<double>(m_halfBands.size() - 1))];
    }
    [[nodiscard]] std::size_t compared() const { return m_inside.size(); }

    test::VirtualBus bus;
    servo::SetGain gains;

private:
    struct Latch {
        TimePoint time;
        std::int32_t position = 0;
        int pwm = 0;
    };
    [[nodiscard]] sim::ChainOptions options() {
        sim::ChainOptions options;
        options.onExecuted = [this](ModuleIndex, const sim::ModuleSnapshot& module) {
            m_latches.push_back({module.time, module.servo.position, module.servo.pwm});
        };
        return options;
    }
    void follow() {
        for (; m_followed < bus.events.size(); ++m_followed) {
            if (const auto* executed = std::get_if<bus::CommandExecuted>(&bus.events[m_followed]))
                m_feed.apply(*executed);
            else if (const auto* sample = std::get_if<bus::Sample>(&bus.events[m_followed]))
                take(*sample);
        }
    }
    void take(const bus::Sample& sample) {
        while (!m_latches.empty() && m_latches.front().time < sample.time - kServoTick / 2)
            m_latches.pop_front();
        const auto made = m_feed.take(sample);
        if (!made)
            return;
        ASSERT_FALSE(m_latches.empty());
        ASSERT_EQ(m_latches.front().position, made->position);
        // The value belongs to the sample before.
        if (const auto value = m_pwm.take(*made, gains)) {
            const auto low = static_cast<double>(value->errorLow);
            const auto high = static_cast<double>(value->errorHigh);
            m_inside.push_back(m_truthBefore >= low && m_truthBefore <= high);
            m_halfBands.push_back((high - low) / 2);
        }
        m_truthBefore = m_latches.front().pwm;
    }

    std::deque<Latch> m_latches;
    std::size_t m_followed = 0;
    ScopeFeed m_feed;
    PwmOutput m_pwm;
    int m_truthBefore = 0;
    std::vector<bool> m_inside;
    std::vector<double> m_halfBands;
};

/// At rest, in ramps, at speed and in jumps, with the damping of the data sheet's example gains.
TEST_F(PwmTruth, LiesWithinTheBand) {
    enable({100, 1'000, 0, 0, 255, 0, 16'000, 1, std::uint8_t{0}});
    std::int32_t goal = 0;
    for (const std::uint32_t acceleration : {200U, 2'000U, 20'000U})
        for (const double speed : {0.5, 2.0, 8.0}) {
            goal = goal == 0 ? 4'000 : 0;
            perform(
                {trapezoid(goal, static_cast<std::uint32_t>(speed * 65'536), acceleration), StartMotion{}});
            runFor((4'000 / speed + speed * 65'536 / acceleration + 200) * 0.000512);
        }
    EXPECT_GT(compared(), 1'000U);
    EXPECT_GE(inside(), 0.99);
    EXPECT_LE(halfBand(0.9), 16) << "a count of rounding in the damping makes 4 of PWM";
}

}  // namespace
}  // namespace nmc
