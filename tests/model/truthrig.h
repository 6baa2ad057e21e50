// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "servofixture.h"
#include "tests/support/commandtruth.h"
#include "tests/support/virtualbus.h"

namespace nmc::testing_support {

/// One servo in virtual time, its calculated command position, and the simulator's own in the very tick in
/// which it latched each sample.
class TruthRig {
public:
    TruthRig(std::uint8_t divisor, const bus::EngineConfig& config, std::uint64_t seed = 1)
        : bus(test::servos(1), config, options(seed)), m_divisor(divisor) {}

    [[nodiscard]] bool enable() {
        // The longer the tick, the lower the gains: a motor that swings would be stopped.
        const auto kp = static_cast<std::uint16_t>(200 / m_divisor);
        const auto kd = static_cast<std::uint16_t>(2'000 / (m_divisor * m_divisor));
        return bus.connect() &&
               perform({servo::SetGain{kp, kd, 0, 200, 255, 0, 16'000, m_divisor, std::uint8_t{0}}}) &&
               perform({stopWith(servo::StopManner::Abruptly)});
    }

    [[nodiscard]] bool perform(std::vector<ServoCommand> commands) {
        std::vector<bus::Order> steps;
        for (ServoCommand& next : commands)
            steps.push_back({ModuleIndex(0), std::move(next)});
        const auto outcome = bus.perform(std::move(steps));
        follow();
        return outcome == bus::Outcome::Done;
    }
    /// Runs for `ticks` servo ticks.
    void runTicks(double ticks) {
        bus.runFor(fromSeconds(ticks * 0.000512 * m_divisor));
        follow();
    }

    [[nodiscard]] double truth() { return bus.servo(0).commandPosition; }

    CommandComparison comparison;
    test::VirtualBus bus;

private:
    [[nodiscard]] sim::ChainOptions options(std::uint64_t seed) {
        sim::ChainOptions options;
        options.seed = seed;
        options.onExecuted = [this](ModuleIndex, const sim::ModuleSnapshot& module) {
            comparison.truth.add(module);
        };
        return options;
    }
    void follow() {
        for (; m_followed < bus.events.size(); ++m_followed)
            comparison.take(bus.events[m_followed]);
    }

    std::uint8_t m_divisor;
    std::size_t m_followed = 0;
};

}  // namespace nmc::testing_support
