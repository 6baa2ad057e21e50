// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/stepcommands.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {

using stepchip::k1x, stepchip::k2x, stepchip::k4x, stepchip::k8x;
using stepchip::Load;
using stepchip::StepReport;

/// A host with one stepper at address 1, amplifier enabled.
class StepWire : public HostWire {
public:
    explicit StepWire(std::string_view spec = "step", ChainOptions options = {}) : HostWire(spec, options) {
        address(1);
        command(1, 0x17, {0x01});
    }

    void parameters(unsigned mode, unsigned minimum = 1, unsigned run = 200, unsigned hold = 80,
                    unsigned thermal = 0) {
        Bytes data;
        for (const unsigned value : {mode, minimum, run, hold, thermal})
            append(data, value, 1);
        EXPECT_EQ(command(1, 0x56, data).size(), 2U);
    }
    void load(const Load& l) {
        const Bytes data = stepchip::loadData(l);
        EXPECT_EQ(command(1, stepchip::loadByte(data), data).size(), 2U);
    }
    void stop(unsigned control) {
        EXPECT_EQ(command(1, 0x17, {static_cast<std::uint8_t>(control)}).size(), 2U);
    }

    StepReport stepReport() {
        const Bytes r = command(1, 0x13, {0x3F});
        EXPECT_EQ(r.size(), stepchip::kReportSize);
        return r.size() == stepchip::kReportSize ? stepchip::readReport(r) : StepReport{};
    }
    StepSnapshot step() { return truth().step.value_or(StepSnapshot{}); }
    std::int32_t position() { return step().position; }
    /// Steps made in so long.
    std::int32_t stepsIn(Duration time) {
        const std::int32_t before = position();
        wait(time);
        return position() - before;
    }
    /// Runs until it stands still; how long that took, to the tick.
    Duration timeToStop(Duration limit = std::chrono::seconds(20)) {
        const TimePoint from = now;
        while (step().moving && now - from < limit)
            wait(kTick);
        return now - from;
    }
};

/// The shortest whole number of ticks that is a whole number of seconds.
inline constexpr Duration kEightSeconds = kTick * 15'625;

}  // namespace nmc::sim::test
