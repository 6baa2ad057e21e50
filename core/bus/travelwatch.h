// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/belief.h"
#include "bus/stoptarget.h"
#include "bus/types.h"

namespace nmc::bus {

/// Stops a motion that has no end of its own before it leaves the limits of travel: a PWM output, which no
/// chip ends, and a run that was begun before its limits were in force. Only motions that this connection
/// started are stopped, not those of another host. One object per module. Pure.
class TravelWatch {
public:
    /// From a report to the stop that answers it; or as long as the module is left unasked, if that is
    /// longer.
    static constexpr Duration kLatency = std::chrono::milliseconds(100);
    /// Speeds are taken over so long at least.
    static constexpr Duration kSpeedOver = std::chrono::milliseconds(50);

    void setLimits(const TravelLimits& limits) { m_limits = limits; }
    /// The counter was set: limits mean other places now, and are not in force before they are set again.
    void onCounterSet() { *this = {}; }
    /// A report that may be believed, which `belief` has already. How the motor has to be stopped; nothing:
    /// it may go on.
    [[nodiscard]] std::optional<StopManner> onReport(const StatusReport& report, TimePoint latched,
                                                     const Belief& belief);

private:
    struct Place {
        TimePoint time;
        std::int32_t counts = 0;
    };
    void measure(std::int32_t position, TimePoint latched);

    TravelLimits m_limits;
    std::optional<Place> m_from;  ///< what the speed is being taken from
    double m_speed = 0;           ///< counts (steps) per second, signed
    std::optional<TimePoint> m_reported;
    Duration m_between{};  ///< the last two reports
};

}  // namespace nmc::bus
