// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "sim/snapshot.h"

namespace nmc::sim {

/// What a stepper chip is wired to: the levels on its pins, and the shaft that operates some of the switches.
/// Neither Reset Position nor power changes it.
class StepperMachine {
public:
    /// The value must be in the range that Input states.
    void set(Input input, std::optional<double> value);
    /// The driver makes this many steps. Steps beyond a hard stop are lost.
    void turn(std::int64_t steps);

    /// Shaft position in steps since the simulation began.
    [[nodiscard]] std::int64_t shaft() const { return m_shaft; }
    /// The pins as the chip sees them: levels that were set, and levels that follow from the shaft's
    /// position.
    [[nodiscard]] StepperPins pins() const;
    /// True when turning the shaft may change a pin.
    [[nodiscard]] bool shaftMovesPins() const;
    [[nodiscard]] bool limitsAutomatic() const { return m_limitsAutomatic; }
    [[nodiscard]] std::optional<std::int64_t> travelMin() const;
    [[nodiscard]] std::optional<std::int64_t> travelMax() const;
    [[nodiscard]] std::optional<std::int64_t> homeSwitchAt() const { return m_homeSwitchAt; }
    [[nodiscard]] std::int64_t loadPlay() const { return m_loadPlay; }

private:
    static constexpr std::int64_t kNoMin = std::numeric_limits<std::int64_t>::min();
    static constexpr std::int64_t kNoMax = std::numeric_limits<std::int64_t>::max();

    StepperPins m_set;
    std::int64_t m_shaft = 0;
    std::int64_t m_loadPlay = 0;
    std::int64_t m_load = 0;  ///< lags the shaft by at most its play
    std::int64_t m_travelMin = kNoMin;
    std::int64_t m_travelMax = kNoMax;
    bool m_limitsAutomatic = false;
    std::optional<std::int64_t> m_homeSwitchAt;
};

}  // namespace nmc::sim
