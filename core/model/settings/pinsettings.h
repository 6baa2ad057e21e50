// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/settings/analogscale.h"

namespace nmc {

/// What hangs on an output of a PIC-I/O, and how careful the panel is with it.
struct OutputSettings {
    std::string name;        ///< UTF-8, as the user typed it; empty: "IO3"
    bool asks = false;       ///< before each change
    bool offAtStop = false;  ///< STOP ALL takes it low; all others stay as they are
    bool operator==(const OutputSettings&) const = default;
};

struct AnalogInput {
    std::string name;
    AnalogScale scale;
    bool operator==(const AnalogInput&) const = default;
};

/// What hangs on a PIC-I/O. The lists end with the last that was set; what is behind has its defaults.
struct PinSettings {
    std::vector<OutputSettings> pins;  ///< IO1..IO12
    std::vector<OutputSettings> pwm;   ///< PWM1, PWM2
    std::vector<AnalogInput> analog;   ///< AD1..AD3

    /// The element of one of these lists, from 0, to be read, and to be changed.
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
    /// Bit 0 is IO1 (PWM1): what STOP ALL takes low.
    [[nodiscard]] static std::uint16_t offAtStop(const std::vector<OutputSettings>& list) {
        unsigned mask = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            mask |= list[i].offAtStop ? 1U << i : 0U;
        return static_cast<std::uint16_t>(mask);
    }
    bool operator==(const PinSettings&) const = default;
};

}  // namespace nmc
