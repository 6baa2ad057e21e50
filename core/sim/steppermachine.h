// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "sim/snapshot.h"

namespace nmc::sim {

/// What a stepper chip is wired to: the levels on its pins, and the shaft that operates some of the switches.
/// Neither Reset Position nor power changes it.
class StepperMachine {
public:
    /// The value must be in the range that Input states. An input that a stepper does not have changes
    /// nothing.
    void set(Input input, std::optional<double> value);
    /// The driver makes this many steps. Steps beyond a hard stop are lost.
    void turn(std::int64_t steps);

    [[nodiscard]] const StepperSurroundings& surroundings() const { return m_around; }
    /// The pins as the chip sees them: levels that were set, and levels that follow from the shaft's
    /// position.
    [[nodiscard]] StepperPins pins() const;
    /// True when turning the shaft may change a pin.
    [[nodiscard]] bool shaftMovesPins() const;

private:
    StepperPins m_set;
    StepperSurroundings m_around;
    std::int64_t m_load = 0;  ///< lags the shaft by at most its play
};

}  // namespace nmc::sim
