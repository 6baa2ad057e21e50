// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "model/scope/commandposition.h"
#include "sim/snapshot.h"

namespace nmc::testing_support {

/// The command positions of a simulated servo in the ticks in which it latched a status. The simulator may
/// run in its own thread.
class LatchLog {
public:
    struct Latch {
        TimePoint time;
        double command = 0;
        double perTick = 0;   ///< how far it moves in this servo tick
        bool steady = false;  ///< it moved as far at the latch before
        std::int32_t position = 0;
        bool servoOn = false;
    };

    /// For sim::ChainOptions::onExecuted; `began` is when the simulation started.
    void add(const sim::ModuleSnapshot& module, TimePoint began = {}) {
        const std::scoped_lock lock(m_mutex);
        const sim::ServoSnapshot& servo = module.servo;
        const double perTick = std::abs(servo.commandVelocity);
        const bool steady = !m_latches.empty() && m_latches.back().perTick == perTick;
        m_latches.push_back({began + module.time.time_since_epoch(), servo.commandPosition, perTick, steady,
                             servo.position, servo.servoOn});
    }
    /// The latch of this sample; empty if it is not in the log. No module latches before its command has
    /// left, and the previous status was latched before that.
    [[nodiscard]] std::optional<Latch> of(const bus::Sample& sample) {
        const std::scoped_lock lock(m_mutex);
        constexpr Duration kStamps = std::chrono::microseconds(20);  // of two threads that read one clock
        while (!m_latches.empty() && m_latches.front().time < sample.time - kServoTick / 2 - kStamps)
            m_latches.pop_front();
        if (m_latches.empty() || m_latches.front().position != sample.report.position)
            return std::nullopt;
        return m_latches.front();
    }

private:
    std::mutex m_mutex;
    std::deque<Latch> m_latches;
};

/// Compares calculated and true command positions at the samples.
class Comparison {
public:
    /// `perTick`: how far the command moves in this servo tick; `steady`: it moved as far before.
    void add(const CommandEstimate& calculated, double truth, double perTick, bool steady) {
        constexpr double kPrecision = 1e-6;  // of calculations with doubles
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
    /// The true position is not known.
    void addUnmatched() { ++m_unmatched; }

    [[nodiscard]] std::size_t samples() const { return m_samples; }
    [[nodiscard]] std::size_t unknown() const { return m_unknown; }
    [[nodiscard]] std::size_t unmatched() const { return m_unmatched; }
    [[nodiscard]] double inside() const {
        return static_cast<double>(m_inside) / static_cast<double>(std::max<std::size_t>(m_samples, 1));
    }
    /// Median |difference| at standstill, in counts.
    [[nodiscard]] double standing() const { return quantile(m_standing, 0.5); }
    /// Median |difference| in motion, in servo ticks of travel.
    [[nodiscard]] double moving() const { return quantile(m_moving, 0.5); }
    /// Median |difference| in motion, in servo ticks of travel at the highest speed since the command
    /// position was last known exactly: a slow motion keeps the uncertainty that a fast one has left.
    [[nodiscard]] double movingOfFastest() const { return quantile(m_movingFast, 0.5); }
    /// Half the band in steady motion, less one count, in servo ticks of travel.
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
    std::size_t m_unmatched = 0;
    std::vector<double> m_standing;
    std::vector<double> m_standingBand;
    std::vector<double> m_moving;
    std::vector<double> m_movingFast;
    std::vector<double> m_movingBand;
    double m_fastest = 0;
};

/// Follows a module's commands and samples, and compares the position calculated for a sample with the true
/// one.
class CommandComparison {
public:
    void take(const bus::Event& event) {
        if (const auto* executed = std::get_if<bus::CommandExecuted>(&event))
            command.apply(*executed);
        else if (const auto* sample = std::get_if<bus::Sample>(&event))
            take(*sample);
        else if (const auto* finished = std::get_if<bus::OperationFinished>(&event))
            if (finished->outcome == bus::Outcome::NoAnswer)
                command.forget();  // as the store does
    }

    CommandPosition command;
    Comparison figures;
    LatchLog truth;

private:
    void take(const bus::Sample& sample) {
        command.apply(sample);
        if (!sample.report.position)
            return;
        const auto latch = truth.of(sample);
        const auto calculated = command.at(sample.time, sample.late);
        if (!latch)
            figures.addUnmatched();
        else if (latch->servoOn && calculated)
            figures.add(*calculated, latch->command, latch->perTick, latch->steady);
        else if (latch->servoOn)
            figures.addUnknown();
    }
};

}  // namespace nmc::testing_support
