// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

/// The stepper's frames (DS-S 5), made and read independently of the program's code.
namespace nmc::stepperchip {

using Bytes = std::vector<std::uint8_t>;

// Set Parameters, first byte.
inline constexpr unsigned k8x = 0, k4x = 1, k2x = 2, k1x = 3;
inline constexpr unsigned kIgnoreLimits = 0x04, kIgnoreEstop = 0x08, kMotorOffAtLimit = 0x10;

/// 1x, 1000 steps per second: 65 536 - 625 000 / 1000 + 2.
inline constexpr std::uint16_t kCount = 64'913;

inline void append(Bytes& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU));
}

/// The parameters of a Load Trajectory command; absent ones are not loaded.
struct Load {
    std::optional<std::int32_t> position{};
    std::optional<std::uint8_t> speed{};
    std::optional<std::uint8_t> acceleration{};
    std::optional<std::uint16_t> count{};
    std::uint8_t nearest = 1;
    bool reverse = false;
    bool start = true;
};

/// The parameters of both loads; those of `more` take precedence.
inline Load operator+(Load load, const Load& more) {
    load.position = more.position ? more.position : load.position;
    load.speed = more.speed ? more.speed : load.speed;
    load.acceleration = more.acceleration ? more.acceleration : load.acceleration;
    load.count = more.count ? more.count : load.count;
    load.nearest = more.count ? more.nearest : load.nearest;
    return load;
}

/// The data bytes of Load Trajectory.
inline Bytes loadData(const Load& load) {
    unsigned control = (load.reverse ? 0x10U : 0U) | (load.start ? 0x80U : 0U);
    Bytes data{0};
    if (load.position) {
        control |= 1U;
        append(data, static_cast<std::uint32_t>(*load.position), 4);
    }
    if (load.speed) {
        control |= 2U;
        append(data, *load.speed, 1);
    }
    if (load.acceleration) {
        control |= 4U;
        append(data, *load.acceleration, 1);
    }
    if (load.count) {
        control |= 8U;
        append(data, *load.count, 2);
        append(data, load.nearest, 1);
    }
    data[0] = static_cast<std::uint8_t>(control);
    return data;
}

/// Load Trajectory's command byte for this data.
inline unsigned loadByte(const Bytes& data) {
    return static_cast<unsigned>(data.size()) << 4U | 4U;
}

/// The contents of a reply with all items (3F).
struct StepperReport {
    unsigned status = 0;
    std::int32_t position = 0;
    unsigned analog = 0;
    unsigned timerCount = 0;
    unsigned inputs = 0;
    std::int32_t home = 0;
    unsigned type = 0;
    unsigned version = 0;
};
inline constexpr std::size_t kReportSize = 16;

/// Decodes `reply`, which has kReportSize bytes.
inline StepperReport readReport(const Bytes& reply) {
    const auto number = [&reply](std::size_t at, std::size_t count) {
        std::uint32_t value = 0;
        for (std::size_t i = count; i-- > 0;)
            value = value << 8U | reply[at + i];
        return value;
    };
    StepperReport report;
    report.status = reply[0];
    report.position = static_cast<std::int32_t>(number(1, 4));
    report.analog = reply[5];
    report.timerCount = number(6, 2);
    report.inputs = reply[8];
    report.home = static_cast<std::int32_t>(number(9, 4));
    report.type = reply[13];
    report.version = reply[14];
    return report;
}

}  // namespace nmc::stepperchip
