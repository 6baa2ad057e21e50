// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a servo that holds is reported to swing. Engine and simulator in virtual time, checked against the
// shaft of the simulator.
#include <random>

#include "tests/procedures/procedurebench.h"

namespace nmc::test {
namespace {

using namespace std::chrono_literals;

class Swings : public testing::Test {
protected:
    /// Makes the motor hold with these gains for this time, after a small move has pushed it.
    void hold(const servo::SetGain& gains, Duration time) {
        ASSERT_TRUE(bench.perform(intent::ApplyGains{gains}));
        const std::int32_t goal = bench.truth().position + 50;
        ASSERT_TRUE(bench.perform(intent::Move{
            servomotion::Trapezoid{Counts(goal), CountsPerTick(2 << 16), CountsPerTickSquared(13'110)}}));
        positions.clear();
        bench.bus.onTime = [this] { positions.emplace_back(bench.bus.now, bench.truth().position); };
        bench.bus.runFor(time);
        bench.take();
    }
    /// For the last second: half of the distance from end to end, and how often the shaft passed the mean
    /// upwards.
    [[nodiscard]] std::pair<double, int> truth() const {
        double low = positions.back().second, high = low, sum = 0;
        std::vector<double> last;
        for (const auto& [time, position] : positions)
            if (time > bench.bus.now - 1s) {
                last.push_back(position);
                low = std::min<double>(low, position);
                high = std::max<double>(high, position);
                sum += position;
            }
        const double mean = sum / static_cast<double>(last.size());
        int ups = 0;
        for (std::size_t i = 1; i < last.size(); ++i)
            ups += last[i - 1] < mean && last[i] >= mean ? 1 : 0;
        return {(high - low) / 2, ups};
    }
    ServoBench bench;
    std::vector<std::pair<TimePoint, std::int32_t>> positions;
};

TEST_F(Swings, AreToldWithHowFarAndHowFast) {
    ASSERT_TRUE(bench.enable());
    // There is no damping, and an output limit keeps the swing bounded.
    ASSERT_NO_FATAL_FAILURE(hold({2'000, 0, 0, 0, 60, 0, 16'000, 1, std::uint8_t{0}}, 4s));
    const auto [amplitude, ups] = truth();
    ASSERT_GT(amplitude, 20) << "it does swing";
    const auto& swing = bench.module().swing.swing();
    ASSERT_TRUE(swing && swing->hertz);
    // The sine component of a wave that may be triangular is 0.81 of its height.
    EXPECT_GT(swing->amplitude, 0.75 * amplitude);
    EXPECT_LT(swing->amplitude, 1.3 * amplitude);
    EXPECT_NEAR(*swing->hertz, ups, 1.5);
    ASSERT_TRUE(bench.perform(intent::MotorOff{}));
    EXPECT_FALSE(bench.module().swing.swing());
}

TEST_F(Swings, NoStableSetIsSaidTo) {
    ASSERT_TRUE(bench.enable());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> kp(30, 400), damping(6, 12), friction(0, 0.006), ki(0, 40);
    for (int set = 0; set < 50; ++set) {
        const auto p = static_cast<std::uint16_t>(kp(random));
        const auto d = static_cast<std::uint16_t>(p * damping(random));
        bench.set(sim::Input::Friction, friction(random));
        ASSERT_NO_FATAL_FAILURE(
            hold({p, d, static_cast<std::uint16_t>(ki(random)), 200, 255, 0, 4'000, 1, std::uint8_t{0}}, 3s));
        EXPECT_FALSE(bench.module().swing.swing())
            << "Kp " << p << " Kd " << d << ", truly ± " << truth().first << " counts";
    }
}

}  // namespace
}  // namespace nmc::test
