// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "tests/sim/hostwire.h"

namespace nmc::sim::test {

/// What a reply with all of a stepper's items says.
struct StepReport {
    unsigned status = 0;
    std::int32_t position = 0;
    unsigned analog = 0;
    unsigned timerCount = 0;
    unsigned inputs = 0;
    std::int32_t home = 0;
    unsigned type = 0;
    unsigned version = 0;
};

// Set Parameters, bits 1,0 (DS-S 5.1).
inline constexpr unsigned k8x = 0, k4x = 1, k2x = 2, k1x = 3;

/// What a Load Trajectory command loads; what is absent is not.
struct Load {
    std::optional<std::int32_t> position{};
    std::optional<std::uint8_t> speed{};
    std::optional<std::uint8_t> acceleration{};
    std::optional<std::uint16_t> count{};
    std::uint8_t nearest = 1;
    bool reverse = false;
    bool start = true;
};

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
        unsigned control = (l.reverse ? 0x10U : 0U) | (l.start ? 0x80U : 0U);
        Bytes data{0};
        if (l.position) {
            control |= 1U;
            append(data, static_cast<std::uint32_t>(*l.position), 4);
        }
        if (l.speed) {
            control |= 2U;
            append(data, *l.speed, 1);
        }
        if (l.acceleration) {
            control |= 4U;
            append(data, *l.acceleration, 1);
        }
        if (l.count) {
            control |= 8U;
            append(data, *l.count, 2);
            append(data, l.nearest, 1);
        }
        data[0] = static_cast<std::uint8_t>(control);
        EXPECT_EQ(command(1, static_cast<unsigned>(data.size()) << 4U | 4U, data).size(), 2U);
    }
    void stop(unsigned control) {
        EXPECT_EQ(command(1, 0x17, {static_cast<std::uint8_t>(control)}).size(), 2U);
    }

    StepReport stepReport() {
        const Bytes r = command(1, 0x13, {0x3F});
        StepReport report;
        EXPECT_EQ(r.size(), 16U);
        if (r.size() != 16)
            return report;
        const auto number = [&r](std::size_t at, std::size_t count) {
            std::uint32_t value = 0;
            for (std::size_t i = count; i-- > 0;)
                value = value << 8U | r[at + i];
            return value;
        };
        report.status = r[0];
        report.position = static_cast<std::int32_t>(number(1, 4));
        report.analog = r[5];
        report.timerCount = number(6, 2);
        report.inputs = r[8];
        report.home = static_cast<std::int32_t>(number(9, 4));
        report.type = r[13];
        report.version = r[14];
        return report;
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
