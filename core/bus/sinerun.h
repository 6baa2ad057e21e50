// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "bus/exchange.h"
#include "bus/types.h"

namespace nmc::bus {

/// A sine being commanded: its present position, when the next command is due, and the results. Between two
/// commands, the line is left to the polls for as long as an exchange takes, so that the other modules stay
/// monitored. The times between commands all differ: at a steady rate, the steps of the command would be
/// mistaken for the motor's response to a slower sine. Pure.
class SineRun {
public:
    static constexpr Duration kShortest = std::chrono::milliseconds(5);
    static constexpr Duration kSpread = std::chrono::microseconds(1500);

    /// `centre`: a Stop Here.
    SineRun(const Sine& sine, const ModuleCommand& centre);

    /// The first call begins the sine.
    [[nodiscard]] ModuleCommand commandAt(TimePoint now);
    [[nodiscard]] TimePoint due() const { return m_due; }
    /// True once it has lasted long enough.
    [[nodiscard]] bool over(TimePoint now) const { return m_began && now - *m_began >= m_sine.lasts; }
    /// The chip has switched off or stopped by itself: its servo is off, it has tripped, or a stop by Set
    /// Homing Mode has occurred. Another Stop Here would switch it on, or move it further.
    [[nodiscard]] bool endedByChip() const { return m_endedByChip; }
    /// The command was carried out; `end`: of its exchange.
    void note(const ReplyEnd& end);
    /// A poll between two commands was answered.
    void notePoll(const ReplyEnd& end);
    [[nodiscard]] SineRecord takeRecord() { return std::exchange(m_record, {}); }

private:
    void look(const StatusReport& report);

    Sine m_sine;
    servo::StopMotor m_command;
    std::int32_t m_centre;
    std::optional<TimePoint> m_began;
    TimePoint m_due{};
    SineRecord m_record;
    std::optional<servo::StatusByte> m_first;  ///< at the first command
    bool m_endedByChip = false;
};

}  // namespace nmc::bus
