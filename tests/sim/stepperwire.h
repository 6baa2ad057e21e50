// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/conformance/steppercommands.h"
#include "tests/sim/hostwire.h"

namespace nmc::sim::test {

using stepperchip::k1x, stepperchip::k2x, stepperchip::k4x, stepperchip::k8x;
using stepperchip::kCount;
using stepperchip::kIgnoreEstop, stepperchip::kIgnoreLimits, stepperchip::kMotorOffAtLimit;
using stepperchip::Load;
using stepperchip::StepperReport;

/// A host with one stepper at address 1, amplifier enabled.
class StepperWire : public HostWire {
public:
    explicit StepperWire(std::string_view spec = "step", ChainOptions options = {})
        : HostWire(spec, options) {
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
        const Bytes data = stepperchip::loadData(l);
        EXPECT_EQ(command(1, stepperchip::loadByte(data), data).size(), 2U);
    }
    void stop(unsigned control) {
        EXPECT_EQ(command(1, 0x17, {static_cast<std::uint8_t>(control)}).size(), 2U);
    }

    StepperReport stepReport() {
        const Bytes r = command(1, 0x13, {0x3F});
        EXPECT_EQ(r.size(), stepperchip::kReportSize);
        return r.size() == stepperchip::kReportSize ? stepperchip::readReport(r) : StepperReport{};
    }
    StepperSnapshot step() { return truth().stepper.value_or(StepperSnapshot{}); }
    std::int32_t position() { return step().position; }
    /// The steps made within `time`.
    std::int32_t stepsIn(Duration time) {
        const std::int32_t before = position();
        wait(time);
        return position() - before;
    }
    /// Waits until the motor is at rest; returns how long that took, to the tick.
    Duration timeToStop(Duration limit = std::chrono::seconds(20)) {
        const TimePoint from = now;
        while (step().moving && now - from < limit)
            wait(kTick);
        return now - from;
    }
};

}  // namespace nmc::sim::test
