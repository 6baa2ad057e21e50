// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "model/commandposition.h"
#include "servofixture.h"
#include "tests/support/virtualbus.h"

namespace nmc::testing_support {

/// How calculated and true command position compare, at the samples.
class Comparison {
public:
    /// `perTick`: how far the command goes in a servo tick just now; `steady`: and went before.
    void add(const CommandEstimate& calculated, double truth, double perTick, bool steady) {
        constexpr double kPrecision = 1e-6;  // of doubles
        ++m_samples;
        m_inside += truth >= calculated.low - kPrecision && truth <= calculated.high + kPrecision ? 1U : 0U;
        const double half = (calculated.high - calculated.low) / 2;
        m_fastest = half == 0.0 ? perTick : std::max(m_fastest, perTick);
        if (perTick == 0.0) {
            m_standing.push_back(std::abs(truth - calculated.position));
            m_standingBand.push_back(half);
        } else {
            m_moving.push_back(std::abs(truth - calculated.position) / perTick);
            m_movingFast.push_back(std::abs(truth - calculated.position) / m_fastest);
            if (steady)
                m_movingBand.push_back(std::max(0.0, half - 1.0) / perTick);
        }
    }
    void addUnknown() { ++m_unknown; }

    [[nodiscard]] std::size_t samples() const { return m_samples; }
    [[nodiscard]] std::size_t unknown() const { return m_unknown; }
    [[nodiscard]] double inside() const {
        return static_cast<double>(m_inside) / static_cast<double>(std::max<std::size_t>(m_samples, 1));
    }
    /// Median |difference| at standstill, counts.
    [[nodiscard]] double standing() const { return quantile(m_standing, 0.5); }
    /// Median |difference| in motion, in servo ticks of travel.
    [[nodiscard]] double moving() const { return quantile(m_moving, 0.5); }
    /// The same in ticks of travel at the fastest since it was last known exactly: a slow motion keeps the
    /// doubt that a fast one has left.
    [[nodiscard]] double movingOfFastest() const { return quantile(m_movingFast, 0.5); }
    /// Half the band in steady motion less one count, in servo ticks of travel.
    [[nodiscard]] double halfBand(double share) const { return quantile(m_movingBand, share); }
    [[nodiscard]] double halfBandStanding() const { return quantile(m_standingBand, 0.5); }

    void print(const std::string& name) const {
        std::printf(
            "%-56s %6zu samples, %6.2f %% inside; median off %4.2f counts at rest (band +-%.2f), %4.2f ticks "
            "in motion (%4.2f of the fastest; band +-%.2f, 99 %%: %.2f)\n",
            name.c_str(), m_samples, 100 * inside(), standing(), halfBandStanding(), moving(),
            movingOfFastest(), halfBand(0.5), halfBand(0.99));
    }

private:
    static double quantile(std::vector<double> values, double share) {
        if (values.empty())
            return 0.0;
        const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), values.begin() + at, values.end());
        return values[static_cast<std::size_t>(at)];
    }

    std::size_t m_samples = 0;
    std::size_t m_inside = 0;
    std::size_t m_unknown = 0;
    std::vector<double> m_standing;
    std::vector<double> m_standingBand;
    std::vector<double> m_moving;
    std::vector<double> m_movingFast;
    std::vector<double> m_movingBand;
    double m_fastest = 0;
};

/// One servo in virtual time, its calculated command position, and what the simulator says it was in the very
/// tick in which it latched each sample.
class TruthRig {
public:
    TruthRig(std::uint8_t divisor, const bus::EngineConfig& config, std::uint64_t seed = 1)
        : bus(test::servos(1), config, {.seed = seed}), m_divisor(divisor) {
        bus.onTime = [this] {
            follow();
            noteLatch();
        };
    }

    [[nodiscard]] bool enable() {
        // The longer the tick, the weaker: a motor that swings would be stopped.
        const auto kp = static_cast<std::uint16_t>(200 / m_divisor);
        const auto kd = static_cast<std::uint16_t>(2'000 / (m_divisor * m_divisor));
        return bus.connect() &&
               perform({servo::SetGain{kp, kd, 0, 200, 255, 0, 16'000, m_divisor, std::uint8_t{0}}}) &&
               perform({stopWith(servo::StopManner::Abruptly)});
    }

    [[nodiscard]] bool perform(std::vector<ServoCommand> commands) {
        std::vector<bus::Step> steps;
        for (ServoCommand& next : commands)
            steps.push_back({ModuleIndex(0), std::move(next)});
        const auto outcome = bus.perform(std::move(steps));
        follow();
        return outcome == bus::Outcome::Done;
    }
    /// In servo ticks.
    void runTicks(double ticks) { bus.runFor(fromSeconds(ticks * 0.000512 * m_divisor)); }

    [[nodiscard]] double truth() { return bus.servo(0).commandPosition; }

    test::VirtualBus bus;
    CommandPosition command;
    Comparison comparison;

private:
    struct Latch {
        TimePoint time;
        double command = 0;
        double perTick = 0;
        bool steady = false;
        std::int32_t position = 0;
        bool servoOn = false;
    };

    /// The chain stops at each tick in which a module carries something out.
    void noteLatch() {
        const sim::ChainStatistics statistics = bus.chain.statistics();
        const auto& counts = statistics.modules[0].executed;
        const auto executed = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
        if (std::exchange(m_executed, executed) == executed)
            return;
        const sim::ServoSnapshot servo = bus.servo(0);
        const double perTick = std::abs(servo.commandVelocity);
        const bool steady = !m_latches.empty() && m_latches.back().perTick == perTick;
        m_latches.push_back({bus.now, servo.commandPosition, perTick, steady, servo.position, servo.servoOn});
    }
    /// No module latches before its command has left, and the one before was latched before that.
    [[nodiscard]] Latch latchOf(const bus::Sample& sample) {
        while (m_latches.size() > 1 && m_latches.front().time < sample.time - kServoTick / 2)
            m_latches.pop_front();
        return m_latches.front();
    }

    void follow() {
        for (; m_followed < bus.events.size(); ++m_followed) {
            const bus::Event& event = bus.events[m_followed];
            if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
                command.apply(*executed);
            else if (const auto* sample = std::get_if<bus::Sample>(&event))
                compare(*sample);
        }
    }

    void compare(const bus::Sample& sample) {
        command.apply(sample);
        if (!sample.report.position)
            return;
        const Latch latch = latchOf(sample);
        EXPECT_EQ(*sample.report.position, latch.position) << "the rig took another tick for the sample's";
        if (!latch.servoOn)
            return;
        if (const auto calculated = command.at(sample.time, sample.late))
            comparison.add(*calculated, latch.command, latch.perTick, latch.steady);
        else
            comparison.addUnknown();
    }

    std::uint8_t m_divisor;
    std::size_t m_followed = 0;
    std::uint64_t m_executed = 0;
    std::deque<Latch> m_latches;
};

}  // namespace nmc::testing_support
