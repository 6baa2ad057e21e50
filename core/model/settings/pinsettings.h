// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/settings/analogscale.h"

namespace nmc {

/// What is connected to an output of a PIC-I/O, and the panel's precautions.
struct OutputSettings {
    std::string name;        ///< UTF-8, as the user typed it; empty: "IO3"
    bool asks = false;       ///< asks for confirmation before each change
    bool offAtStop = false;  ///< STOP ALL takes it low; other outputs stay unchanged
    bool operator==(const OutputSettings&) const = default;
};

struct AnalogInput {
    std::string name;
    AnalogScale scale;
    bool operator==(const AnalogInput&) const = default;
};

/// What is connected to a PIC-I/O. Each list ends with the last element that was set; elements beyond it have
/// their defaults.
struct PinSettings {
    std::vector<OutputSettings> pins;  ///< IO1..IO12
    std::vector<OutputSettings> pwm;   ///< PWM1, PWM2
    std::vector<AnalogInput> analog;   ///< AD1..AD3

    /// The element of one of these lists, counted from 0, for reading (of) and for changing (in).
    template <typename T>
    [[nodiscard]] static T of(const std::vector<T>& list, std::size_t number) {
        return number < list.size() ? list[number] : T{};
    }
    template <typename T>
    [[nodiscard]] static T& in(std::vector<T>& list, std::size_t number) {
        if (number >= list.size())
            list.resize(number + 1);
        return list[number];
    }
    /// The outputs that STOP ALL takes low; bit 0 is IO1 (PWM1).
    [[nodiscard]] static std::uint16_t offAtStop(const std::vector<OutputSettings>& list) {
        unsigned mask = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            mask |= list[i].offAtStop ? 1U << i : 0U;
        return static_cast<std::uint16_t>(mask);
    }
    bool operator==(const PinSettings&) const = default;
};

}  // namespace nmc
