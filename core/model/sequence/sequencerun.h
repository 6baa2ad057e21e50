// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/time.h"
#include "bus/standstill.h"
#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/procedure/procedure.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

enum class SequenceStage : std::uint8_t {
    Running,
    Pausing,   ///< the present row is finished first
    Paused,    ///< goes on where it is
    Stopping,  ///< it has ended, and its motors are told to stop
    Done,
    Over,  ///< before its end, for SequenceReport::end
};

/// Why a run is over before its end.
enum class SequenceEnd : std::uint8_t {
    ByUser,
    StopOfAll,
    TakenOver,    ///< `module` was told something else, or moves because of somebody else
    LimitClosed,  ///< a limit switch of `module` closed on its way
    NotArrived,   ///< `module` stopped on its way
    WentOff,      ///< the motor of `module` went off by itself
    Refused,      ///< for `refusal`
    InputTimeout,
    AnalogTimeout,
    NotHomed,  ///< `module` has not found its home
    // Doubts: nothing is known to be wrong with the machine.
    LinkInDoubt,
    Unresponsive,  ///< `module` does not answer, or has restarted
    NotExecuted,   ///< a command was refused or not answered
};
/// It may be started again from a row when the doubt is gone.
[[nodiscard]] constexpr bool isDoubt(SequenceEnd end) {
    return end == SequenceEnd::LinkInDoubt || end == SequenceEnd::Unresponsive ||
           end == SequenceEnd::NotExecuted;
}

/// What the window shows of a run.
struct SequenceReport {
    SequenceStage stage = SequenceStage::Running;
    /// The sequence that was started, then those that it called; each with the row that is next or under way.
    std::vector<RowPlace> places;
    std::string point{};  ///< of a run that only goes there
    std::optional<SequenceEnd> end{};
    std::optional<ModuleIndex> module{};
    std::optional<Refusal> refusal{};

    [[nodiscard]] bool over() const { return stage == SequenceStage::Done || stage == SequenceStage::Over; }
    bool operator==(const SequenceReport&) const = default;
};

/// One run of a sequence: it is told what the modules say, how what it asked for has ended, and the time, and
/// says what to do next. It asks for what the panel asks for, by plan() and procedureFor(). Pure; the
/// sequence controller runs it on the GUI thread.
///
/// Any stop ends it, and so does any doubt about the link: its motors are told to stop, and it never moves
/// one again. To go on is another run, from a chosen row, which whyNotRun() lets begin only where a fresh run
/// would come to that row in the same state. A pause in between rows keeps the run.
class SequenceRun {
public:
    struct Wait {};
    /// To be submitted, each by itself; as many onFinished() follow.
    struct Send {
        std::vector<std::vector<bus::Order>> operations;
    };
    /// A procedure to begin or to cancel; onProcedure() follows until it is over, or onNotBegun().
    struct Ask {
        ModuleIndex module;
        Intent intent;
    };
    using Next = std::variant<Wait, Send, Ask>;

    /// whyNotRun() has nothing against it. `machine` stays as it is for this run. `singleStep`: it pauses
    /// behind each row.
    SequenceRun(Machine machine, const std::string& sequence, std::size_t row, bool singleStep = false);
    /// To a point and no farther, all axes at once.
    [[nodiscard]] static SequenceRun toPoint(Machine machine, const std::string& point);
    /// The homes of these axes, one after the other.
    [[nodiscard]] static SequenceRun homing(Machine machine, const std::vector<ModuleIndex>& axes);

    /// After every news of a module, and at least ten times a second, until report() is over. `modules`: of
    /// the whole chain.
    [[nodiscard]] Next next(const std::vector<ModuleState>& modules, TimePoint now);

    /// Of an operation that it sent.
    void onFinished(ModuleIndex module, bus::Outcome outcome);
    void onProcedure(const ProcedureReport& report);
    void onNotBegun(ModuleIndex module, Refusal refusal);
    /// The link is in doubt, or that to one module.
    void onLinkSuspect();
    /// This module is told something else, or was stopped by somebody else; nothing if it takes no part.
    /// `sees`: whoever does that sees to its motor; otherwise that is told to stop with the others.
    void onTakenOver(ModuleIndex module, bool sees = true);
    /// All motors have been stopped, or are about to be: nothing more is sent.
    void onStopOfAll();
    /// The connection is over.
    void onClosed();

    /// Finishes the present row, then waits.
    void pause();
    void resume();
    /// One row, then waits again.
    void step();
    void stop();

    [[nodiscard]] const SequenceReport& report() const { return m_report; }
    [[nodiscard]] const Machine& machine() const { return m_machine; }
    /// The one that is next or under way; null behind the last one.
    [[nodiscard]] const Action* row() const { return rowAt(m_machine.program, m_report.places.back()); }
    [[nodiscard]] bool takesPart(ModuleIndex module) const { return m_parts.contains(module); }
    /// All modules that it may ever ask something of.
    [[nodiscard]] const std::set<ModuleIndex>& parts() const { return m_parts; }

private:
    struct Move {
        std::int32_t goal = 0;
        LimitWatch::Limits closedBefore{};  ///< and while it moved
        std::optional<TimePoint> since{};   ///< statuses that are not later tell nothing of it
        Standstill standstill{};
    };
    /// What has been done of the present row.
    struct Row {
        std::size_t sent = 0;  ///< axes of a move, or the one command that another row consists of
        std::optional<TimePoint> began{};
    };
    using Modules = std::vector<ModuleState>;
    /// What a row wants next; nothing: it is done.
    using RowNext = std::optional<Next>;

    void endBy(SequenceEnd end, std::optional<ModuleIndex> module = {}, std::optional<Refusal> refusal = {});
    [[nodiscard]] Next finishEnding(const Modules& modules);
    void watch(const Modules& modules, TimePoint now);
    [[nodiscard]] bool hasArrived(const ModuleState& module, Move& move, TimePoint now);
    [[nodiscard]] Next proceed(const Modules& modules, TimePoint now);
    [[nodiscard]] RowNext perform(const Action& row, const Modules& modules, TimePoint now);
    [[nodiscard]] RowNext moveTo(const action::MoveTo& move, const Modules& modules);
    [[nodiscard]] RowNext setOutput(const action::SetOutput& set, const ModuleState& module);
    [[nodiscard]] RowNext findHome(const action::Home& home);
    [[nodiscard]] Next sendMoves(std::span<const PointAxis> axes, unsigned percent, const Modules& modules);
    [[nodiscard]] bool anyMoves(std::span<const PointAxis> axes) const;
    [[nodiscard]] Next refused(ModuleIndex module, Refusal refusal);
    [[nodiscard]] Next send(std::vector<std::vector<bus::Order>> operations);
    [[nodiscard]] bool ending() const { return m_report.end.has_value() || m_report.over(); }

    Machine m_machine;
    std::set<ModuleIndex> m_parts;  ///< all that it may ever ask something of
    SequenceReport m_report;
    bool m_pauseWanted = false;
    unsigned m_inFlight = 0;
    std::map<ModuleIndex, Move> m_moves;  ///< under way
    std::set<ModuleIndex> m_on;           ///< those that it has moved, which stay on
    std::optional<ModuleIndex> m_procedure;
    std::optional<ProcedureReport> m_procedureEnd;
    bool m_saysNothingMore = false;  ///< somebody else sees to the motors
    bool m_cancelled = false;
    bool m_stopsSent = false;
    std::set<ModuleIndex> m_leftAlone;  ///< by the last word: another has told them what to do
    Row m_row;
};

}  // namespace nmc
