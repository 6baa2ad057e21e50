// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "model/intent/responsetaken.h"
#include "model/procedure/procedure.h"
#include "model/procedure/standstillwait.h"

namespace nmc {

/// Common parts of the tests of a PIC-SERVO's loop (DS-V 4.3). Each begins at rest at the position that the
/// servo holds, and ends with a stop, which clears a step's velocity in the chip (every motion loads its own
/// acceleration), and a Stop Here at the final position, so that it is held to the count; version 1 has no
/// Stop Here.
///
/// A motor that goes too far, or oscillates widely at the end, is sent a hold; if that does not calm it, the
/// servo itself keeps it going and is switched off. Any stop ends the test, including the chip's own. A test
/// needs the bus's focus while it runs.
class LoopTest : public Procedure {
protected:
    LoopTest(ProcedureKind kind, const ModuleState& module) : Procedure(module.info.index, kind) {}

    /// A step to take before the wait for standstill; nothing by default.
    [[nodiscard]] virtual std::optional<Next> beforeStandstill(const ModuleState& /*module*/) { return {}; }
    /// Called at standstill; returns the first commands.
    [[nodiscard]] virtual Next begin(const ModuleState& module) = 0;
    /// Called in stage Moving while nothing is in flight.
    [[nodiscard]] virtual Next goOn(const ModuleState& module, TimePoint now) = 0;
    /// Called at the end of what conclude() began: the motor stands, or has not come to rest in time.
    [[nodiscard]] virtual Next settled(const ModuleState& module, bool stands);
    /// True when the motor is farther away than the test allows.
    [[nodiscard]] virtual bool goneTooFar(const ModuleState& module) const = 0;
    /// The range of commanded positions, in counts.
    [[nodiscard]] virtual std::int32_t span() const = 0;

    /// Command position at the start, in counts.
    [[nodiscard]] std::int32_t from() const { return m_from; }
    /// Shaft position at the start, in counts.
    [[nodiscard]] std::int32_t stood() const { return m_stood; }
    /// Called at standstill: arms the limit stop if it is due, and starts from here with begin().
    [[nodiscard]] Next start(const ModuleState& module);
    /// The method by which this module makes the test. CMC and SC keep a velocity through every stop
    /// (docs/family.md): after a step by profile, a move of another program that loads only its goal would
    /// jump there, too. They step by Stop Here instead.
    [[nodiscard]] static ResponseMethod methodOf(ResponseMethod wanted, const ModuleState& module);
    /// Moves the command position to `goal`: in one tick unless it is a profiled move.
    [[nodiscard]] std::vector<bus::Order> jump(const ModuleState& module, std::int32_t goal,
                                               ResponseMethod method,
                                               const std::optional<ServoPace>& pace = {}) const;
    /// While `taken` is being recorded, returns the next step; nothing when the record is complete. Another
    /// party may take over the motion, or it may go too far.
    [[nodiscard]] std::optional<Next> record(const ModuleState& module, TimePoint now,
                                             const ResponseTaken& taken);
    /// Ends the test; the motor is then held at `goal`.
    [[nodiscard]] Next conclude(const ModuleState& module, std::int32_t goal);

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) final;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const final;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) final;
    void whileItLasts(const ModuleState& module) final;
    [[nodiscard]] Next prepare(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next overtaken();
    [[nodiscard]] Next settle(const ModuleState& module, TimePoint now);
    [[nodiscard]] std::vector<bus::Order> hold(const ModuleState& module) const;
    [[nodiscard]] bool swingsFar(const ModuleState& module) const;

    /// The reason why the module can no longer be tested, if any.
    [[nodiscard]] std::optional<ProcedureFailure> trouble(const ModuleState& module) const;

    std::int32_t m_from = 0;
    std::int32_t m_stood = 0;
    bool m_arms = false;     ///< the limit stop has just been armed, and start() goes on
    bool m_limited = false;  ///< the chip was armed to stop by itself when the test began
    bool m_calming = false;
    StandstillWait m_rest;
    std::optional<TimePoint> m_heldAt;  ///< time of the command that conclude() has sent
};

}  // namespace nmc
