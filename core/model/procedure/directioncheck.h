// SPDX-License-Identifier: MIT
#pragma once

#include "model/intent/intent.h"
#include "model/procedure/procedure.h"
#include "model/procedure/standstillwait.h"

namespace nmc {

/// Checks that a PIC-SERVO's motor and encoder agree before the servo is switched on for the first time: if
/// either is reversed, the position loop drives the motor away from where it should hold. The check pushes
/// the motor in PWM mode (DS-V 4.4, 5.2 Load Trajectory), forward until it moves and then in reverse, a
/// little more strongly each time, and waits for standstill in between.
///
/// How far the shaft moves: a push is a single operation (start, four reads, stop) that the bus thread
/// executes without interruption. It lasts five exchanges: 10 ms at 115 200 Bd, 40 ms at 19 200, and 100 ms
/// with an adapter that delays every answer by 16 ms, whatever the rest of the program does. A motor that
/// moves is detected after its push, so beyond kMovedCounts it goes as far as that one push and the run-down
/// carry it, with hardly more drive than its friction takes, because the previous push did not move it. A
/// lost answer prolongs a push until the line is trusted again, some tenths of a second (link.md 2.2), at no
/// more than a quarter of the supply. The guardian treats a push like any motion.
///
/// Between pushes, and however the check ends, servo, PWM and amplifier are off, so the final orders are sent
/// even after another party's stop. The check begins only when the servo is off and nothing moves. If the
/// servo is switched on in the meantime, another party has done so: the check then ends without sending
/// anything.
class DirectionCheck : public Procedure {
public:
    /// `wanted` must be possible now.
    DirectionCheck(const intent::CheckDirection& wanted, const ModuleState& module);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) override;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const override;
    [[nodiscard]] Next begin(const ModuleState& module);
    [[nodiscard]] Next look(const ModuleState& module);
    [[nodiscard]] Next push();
    [[nodiscard]] Next conclude(DirectionVerdict verdict, const ModuleState& module);

    intent::CheckDirection m_wanted;
    DirectionFound m_found;
    bool m_pushed = false;
    bool m_concluded = false;
    bool m_reverse = false;
    std::uint8_t m_push = 0;
    std::int32_t m_start = 0;  ///< position at the start of the check
    std::int32_t m_from = 0;   ///< position before the pushes in this direction
    bool m_limit1 = false;     ///< active at the start, which may be due to the wiring
    bool m_limit2 = false;
    StandstillWait m_rest;
};

}  // namespace nmc
