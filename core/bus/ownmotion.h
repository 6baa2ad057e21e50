// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "bus/standstill.h"
#include "bus/types.h"

namespace nmc::bus {

/// Determines whether a motion of a module was started by this connection or by another host (faults.md
/// F-45): a module that was seen at rest, was sent only queries since, and moves under power, was commanded
/// by another host. A shaft that is turned while the motor is off does not count, nor does a servo that
/// yields to a load. One object per module. Pure.
///
/// It reports, and stops nothing: the other host may be in the middle of something that a stop from here
/// would ruin, and its next command would continue the motion anyway. The user is informed at once, and has
/// STOP.
class OwnMotion {
public:
    /// A servo that holds normally yields to a load by less than this: a turn of a common motor.
    static constexpr std::int64_t kGivesWay = 2'000;
    /// A single wrong frame does not prove motion.
    static constexpr unsigned kLooks = 2;

    explicit OwnMotion(ModuleType type) : m_type(type) {}

    void onSent(const ModuleCommand& command);
    /// Takes a believed report. `mayMove`: according to the commands sent, whatever the report shows. Returns
    /// true if another host has set the module in motion; once, until it has been seen at rest.
    [[nodiscard]] bool onReport(const StatusReport& report, TimePoint latched, bool mayMove);
    /// This connection sent a command that may move it, and it was not seen at rest since.
    [[nodiscard]] bool commanded() const { return m_commanded; }

private:
    [[nodiscard]] bool underPower(const StatusReport& report) const;

    ModuleType m_type;
    bool m_commanded = false;  ///< since a command that may move it, until it is seen at rest
    bool m_rested = false;     ///< it was seen at rest, and no motion was reported since
    std::int32_t m_place = 0;
    Standstill m_still;
    unsigned m_looks = 0;  ///< consecutive ones that show motion
};

}  // namespace nmc::bus
