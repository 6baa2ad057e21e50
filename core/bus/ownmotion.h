// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "bus/standstill.h"
#include "bus/types.h"

namespace nmc::bus {

/// Whether a motion of one module is this connection's, or somebody else's (faults.md F-45): a module that
/// was seen at rest, was sent nothing since but questions, and moves under power, has been told so by another
/// host. A shaft that is turned while the motor is off is not that; nor is a servo that gives way. One object
/// per module. Pure.
///
/// It tells, and stops nothing: whoever moves the motor may be in the midst of something that a stop from
/// here would ruin, and would go on by his next command. The operator is told at once, and has STOP.
class OwnMotion {
public:
    /// A servo that holds gives way to a load by less, as a rule: a turn of a usual motor.
    static constexpr std::int64_t kGivesWay = 2'000;
    /// A single wrong frame shows no motion.
    static constexpr unsigned kLooks = 2;

    explicit OwnMotion(ModuleType type) : m_type(type) {}

    void onSent(const ModuleCommand& command);
    /// A report that may be believed. `mayMove`: by what it was told, for all it shows. True when somebody
    /// else has set it in motion; once, until it has been seen at rest.
    [[nodiscard]] bool onReport(const StatusReport& report, TimePoint latched, bool mayMove);
    /// It was sent something from here that may move it, and was not seen at rest since.
    [[nodiscard]] bool commanded() const { return m_commanded; }

private:
    [[nodiscard]] bool saysMoving(const StatusReport& report) const;
    [[nodiscard]] bool underPower(const StatusReport& report) const;

    ModuleType m_type;
    bool m_commanded = false;  ///< from a command that may move it, until it is seen at rest
    bool m_rested = false;     ///< was seen at rest, and nobody has been told of a motion since
    std::int32_t m_place = 0;
    Standstill m_still;
    unsigned m_looks = 0;  ///< in a row that show a motion
};

}  // namespace nmc::bus
