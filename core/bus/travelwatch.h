// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "bus/belief.h"
#include "bus/types.h"

namespace nmc::bus {

/// Stops a motion without an end of its own before it leaves the travel limits: a PWM output, which no chip
/// ends, and a run that began before its limits were in force. Only motions that this connection started are
/// stopped, not those of another host. One object per module. Pure.
class TravelWatch {
public:
    /// Time from a report to the stop that follows from it; or the time between reports of the module, if
    /// that is longer.
    static constexpr Duration kLatency = std::chrono::milliseconds(100);
    /// Minimum time over which a speed is measured.
    static constexpr Duration kSpeedOver = std::chrono::milliseconds(50);

    void setLimits(const TravelLimits& limits) { m_limits = limits; }
    /// The counter was set: the limits denote other positions now, and are not in force until they are set
    /// again.
    void onCounterSet() { *this = {}; }
    /// Takes a believed report, which `belief` already includes. Returns how the motor must be stopped;
    /// empty: it may continue.
    [[nodiscard]] std::optional<StopManner> onReport(const StatusReport& report, TimePoint latched,
                                                     const Belief& belief);
    /// True if a motor that moves towards that limit may run on at `velocity` counts (steps) per second until
    /// onReport() stops it: there is room for the stop even if it is a report late.
    [[nodiscard]] bool mayRunOn(bool reverse, double velocity, const Belief& belief) const;

private:
    struct Place {
        TimePoint time;
        std::int32_t counts = 0;
    };
    void measure(std::int32_t position, TimePoint latched);
    /// Time from a report to the stop that follows from it.
    [[nodiscard]] Duration latency() const;

    TravelLimits m_limits;
    std::optional<Place> m_from;  ///< starting point of the speed measurement
    double m_speed = 0;           ///< counts (steps) per second, signed
    std::optional<TimePoint> m_reported;
    Duration m_between{};  ///< time between the last two reports
};

}  // namespace nmc::bus
