// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/standstill.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// Decides when a move has arrived: at standstill or, on a PIC-SERVO whose axis has a tolerance, once its
/// profile has ended and the motor has stayed within the tolerance of the goal for long enough. One for each
/// move. Pure.
class Arrival {
public:
    enum class State : std::uint8_t {
        Underway,
        There,
        Missed,  ///< not within the tolerance for long enough, kPatience after the end of the profile
    };
    static constexpr Duration kPatience = std::chrono::seconds(10);

    /// Call once for each status with a position, in order.
    [[nodiscard]] State look(const ModuleState& module, std::int32_t goal, const ArrivalSettings& axis);

private:
    Standstill m_standstill;
    std::optional<TimePoint> m_ended;   ///< first status after the profile
    std::optional<TimePoint> m_within;  ///< first status since then from which on it was within the tolerance
};

}  // namespace nmc
