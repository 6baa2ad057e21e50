// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "bus/standstill.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Tells whether a PIC-SERVO's motor and encoder agree before the servo is on for the first time: with either
/// reversed the position loop drives away from where it should hold. It pushes the motor in PWM mode (DS-V
/// 4.4, 5.2 Load Trajectory), forward until it moves, then in reverse, a little stronger each time, and waits
/// for standstill in between.
///
/// How far the shaft goes: a push is one operation, start, four questions, stop, and the bus thread carries
/// it out in one go: it lasts five exchanges, 10 ms at 115 200 Bd, 40 ms at 19 200, 100 ms behind an adapter
/// that waits 16 ms for every answer, whatever the rest of the program does. A motor that moves is seen to
/// after its push, so beyond kMovedCounts it goes as far as that one push and running down carry it, with
/// hardly more drive than its friction takes, since the push before did not move it. An answer that is lost
/// prolongs a push until the line is trusted again, some tenths of a second (link.md 2.2), at a quarter of
/// the supply at most. The guardian sees it as any motion.
///
/// Between pushes, and at every end, servo, PWM and amplifier are off, so the last word goes out behind
/// somebody else's stop, too. It begins only where the servo is off and nothing moves. A servo that is on
/// meanwhile is somebody else's: that ends it, and nothing is sent.
class DirectionCheck : public Procedure {
public:
    /// `wanted` is possible now.
    DirectionCheck(const intent::CheckDirection& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next begin(const ModuleState& module);
    [[nodiscard]] Next look(const ModuleState& module);
    [[nodiscard]] Next push();
    [[nodiscard]] Next conclude(DirectionVerdict verdict, const ModuleState& module);
    [[nodiscard]] bool stands(const ModuleState& module, TimePoint now);
    [[nodiscard]] std::vector<bus::Order> orders(std::vector<ServoCommand> commands) const;

    intent::CheckDirection m_wanted;
    DirectionFound m_found;
    bool m_pushed = false;
    bool m_concluded = false;
    bool m_reverse = false;
    std::uint8_t m_push = 0;
    std::int32_t m_start = 0;  ///< where it stood
    std::int32_t m_from = 0;   ///< where it stood before it was pushed this way
    bool m_limit1 = false;     ///< active at the start, which may be how it is wired
    bool m_limit2 = false;
    std::optional<TimePoint> m_since;
    Standstill m_standstill;
};

}  // namespace nmc
