// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/standstill.h"
#include "model/intent/responsetaken.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// What the tests of a PIC-SERVO's loop have in common (DS-V 4.3): each begins at rest at the position that
/// the servo holds, and ends with a stop, by which the chip forgets a step's velocity (an acceleration every
/// motion brings along itself), and a Stop Here where it is to stay, so that this is held to the count;
/// version 1 has no Stop Here.
///
/// A motor that goes too far, or swings far when it is over, is told to hold; if that does not calm it the
/// servo itself keeps it going, and is switched off. Any stop ends it, the chip's own too. Wants the bus's
/// focus while it runs.
class LoopTest : public Procedure {
protected:
    LoopTest(ProcedureKind kind, const ModuleState& module) : Procedure(module.info.index, kind) {}

    /// Before the motor is looked at for standing still; nothing.
    [[nodiscard]] virtual std::optional<Next> beforeStandstill(const ModuleState& /*module*/) { return {}; }
    /// It stands: the first command.
    [[nodiscard]] virtual Next begin(const ModuleState& module) = 0;
    /// Stage Moving, nothing in flight.
    [[nodiscard]] virtual Next goOn(const ModuleState& module, TimePoint now) = 0;
    /// What conclude() began has ended: it stands, or does not come to rest in time.
    [[nodiscard]] virtual Next settled(const ModuleState& module, bool stands);
    /// Farther than the test allows.
    [[nodiscard]] virtual bool goneTooFar(const ModuleState& module) const = 0;
    /// Counts, from one end of what is commanded to the other.
    [[nodiscard]] virtual std::int32_t span() const = 0;

    /// Counts, that the servo held when it began.
    [[nodiscard]] std::int32_t from() const { return m_from; }
    /// Counts, where the shaft stood then.
    [[nodiscard]] std::int32_t stood() const { return m_stood; }
    /// It stands: from here, by begin().
    [[nodiscard]] Next start(const ModuleState& module);
    /// The command position goes there in one tick.
    [[nodiscard]] std::vector<bus::Order> jump(const ModuleState& module, std::int32_t goal,
                                               ResponseMethod method) const;
    /// While `taken` is recorded: what comes next until it is over. The motion may be somebody else's by
    /// then, or go too far.
    [[nodiscard]] std::optional<Next> record(const ModuleState& module, TimePoint now,
                                             const ResponseTaken& taken);
    /// The test is over: it is held at `goal`.
    [[nodiscard]] Next conclude(const ModuleState& module, std::int32_t goal);
    [[nodiscard]] std::vector<bus::Order> orders(std::vector<ServoCommand> commands) const;

private:
    [[nodiscard]] Next proceed(const ModuleState& module, TimePoint now) final;
    [[nodiscard]] std::vector<bus::Order> lastWord(const ModuleState& module) const final;
    [[nodiscard]] Next afterLastWord(const ModuleState& module, TimePoint now) final;
    void whileItLasts(const ModuleState& module) final;
    [[nodiscard]] Next prepare(const ModuleState& module, TimePoint now);
    [[nodiscard]] Next overtaken();
    [[nodiscard]] Next settle(const ModuleState& module, TimePoint now);
    [[nodiscard]] std::vector<bus::Order> hold(const ModuleState& module) const;
    [[nodiscard]] bool stands(const ModuleState& module, TimePoint now);
    [[nodiscard]] bool swingsFar(const ModuleState& module) const;

    /// Of a module that cannot be tested any more.
    [[nodiscard]] std::optional<ProcedureFailure> trouble(const ModuleState& module) const;

    std::int32_t m_from = 0;
    std::int32_t m_stood = 0;
    bool m_limited = false;  ///< the chip was told to stop by itself, and watched when it began
    bool m_calming = false;
    std::optional<TimePoint> m_since;   ///< when it was first looked at for standing still
    std::optional<TimePoint> m_heldAt;  ///< what conclude() has sent
    Standstill m_standstill;
};

}  // namespace nmc
