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
#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/module/arrival.h"
#include "model/procedure/procedure.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

enum class SequenceStage : std::uint8_t {
    Running,
    Pausing,   ///< the current row is finished first
    Paused,    ///< can be resumed where it is
    Stopping,  ///< the run has ended, and its motors are being stopped
    Done,
    Over,  ///< ended early; SequenceReport::end is the reason
};

/// Why a run ended early.
enum class SequenceEnd : std::uint8_t {
    ByUser,
    StopOfAll,
    Closed,       ///< the connection has ended: nothing more can be sent
    TakenOver,    ///< `module` was sent something else, or is moved by something else
    LimitClosed,  ///< a limit switch of `module` closed during the move
    NotArrived,   ///< `module` stopped before its goal, or was given another one
    NotSettled,   ///< `module` does not stay within its tolerance (Arrival)
    WentOff,      ///< the motor of `module` is unexpectedly off
    Refused,      ///< because of `refusal`
    InputTimeout,
    AnalogTimeout,
    NotHomed,         ///< `module` has not found its home
    TaughtElsewhere,  ///< point `taught`: `module` was taught with home unknown, but it is known by now
    NotAnOutput,      ///< a pin of `module` has become an input
    OutputsUnknown,   ///< of `module`, or their directions
    // Doubts: the machine itself has no known fault.
    LinkInDoubt,
    Unresponsive,  ///< `module` does not answer, or has restarted
    NotExecuted,   ///< a command was refused or not answered
};

/// What the window shows of a run.
struct SequenceReport {
    SequenceStage stage = SequenceStage::Running;
    /// The sequence that was started, then the called sequences, each with the row that is next or in
    /// progress.
    std::vector<RowPlace> places;
    std::string point{};  ///< set in a run that only moves to this point
    std::optional<SequenceEnd> end{};
    std::optional<ModuleIndex> module{};
    std::optional<Refusal> refusal{};
    std::string taught{};
    std::optional<Action> awaited{};  ///< the wait that timed out

    [[nodiscard]] bool over() const { return stage == SequenceStage::Done || stage == SequenceStage::Over; }
    bool operator==(const SequenceReport&) const = default;
};

/// One run of a sequence. From the state of the modules, the results of its requests, and the time, it
/// determines what to do next. Its requests are planned like the panel's own, by plan() and procedureFor().
/// Pure; the sequence controller runs it on the GUI thread.
///
/// Any stop ends the run, and so does any doubt about the link: its motors are sent a stop, and it never
/// moves one again. To continue takes a new run from a chosen row, which whyNotRun() permits only if a run
/// from the top would reach that row in the same state. A pause between rows does not end the run.
class SequenceRun {
public:
    struct Wait {};
    /// Operations, each to be submitted separately; onFinished() follows for each.
    struct Send {
        std::vector<std::vector<bus::Order>> operations;
    };
    /// A procedure to be started or cancelled; onProcedure() follows until it is over, or onNotBegun().
    struct Ask {
        ModuleIndex module;
        Intent intent;
    };
    using Next = std::variant<Wait, Send, Ask>;

    /// Requires that whyNotRun() finds no problem. `machine` is used unchanged for the whole run.
    /// `singleStep`: the run pauses after each row.
    SequenceRun(Machine machine, const std::string& sequence, std::size_t row, bool singleStep = false);
    /// A run that only moves to a point, all axes at once.
    [[nodiscard]] static SequenceRun toPoint(Machine machine, const std::string& point);
    /// A run that homes these axes, one after the other.
    [[nodiscard]] static SequenceRun homing(Machine machine, const std::vector<ModuleIndex>& axes);

    /// Call after every event of a module, and at least ten times a second, until report() is over.
    /// `modules`: those of the whole chain.
    [[nodiscard]] Next next(const std::vector<ModuleState>& modules, TimePoint now);

    /// An operation of this run has ended.
    void onFinished(ModuleIndex module, bus::Outcome outcome);
    void onProcedure(const ProcedureReport& report);
    void onNotBegun(ModuleIndex module, Refusal refusal);
    /// The link as a whole, or to one module, is in doubt.
    void onLinkSuspect();
    /// The module is sent something else, or was stopped by something else. This has no effect if it takes no
    /// part. `sees`: its motor is taken care of elsewhere; otherwise it is sent a stop with the others.
    void onTakenOver(ModuleIndex module, bool sees = true);
    /// All motors have been stopped, or are about to be; nothing more is sent.
    void onStopOfAll();
    /// The connection has ended.
    void onClosed();

    /// Finishes the current row, then waits.
    void pause();
    void resume();
    /// Runs one row, then waits again.
    void step();
    void stop();

    [[nodiscard]] const SequenceReport& report() const { return m_report; }
    [[nodiscard]] const Machine& machine() const { return m_machine; }
    /// The row that is next or in progress; null past the last one.
    [[nodiscard]] const Action* row() const { return rowAt(m_machine.program, m_report.places.back()); }
    [[nodiscard]] bool takesPart(ModuleIndex module) const { return m_parts.contains(module); }
    /// All modules that this run may ever use.
    [[nodiscard]] const std::set<ModuleIndex>& parts() const { return m_parts; }

private:
    struct Move {
        std::int32_t goal = 0;
        LimitWatch::Limits closedBefore{};  ///< closed by an earlier motion (LimitWatch::ranInto)
        std::optional<Leg> then{};          ///< follows when this one has arrived (PointMove)
        bool turns = false;                 ///< it has, and the next one is due
        bool toStop = true;                 ///< when the run ends, it still has to be sent a stop
        bool stopWaits = false;             ///< for the reply that decides whether the motor is off
        std::optional<TimePoint> since{};   ///< only later statuses show the result of the move
        Arrival arrival{};
    };
    /// Progress of the current row.
    struct Row {
        std::size_t sent = 0;  ///< axes of a move, or the single command of any other row
        std::optional<TimePoint> began{};
    };
    using Modules = std::vector<ModuleState>;
    /// What a row needs next; empty: the row is done.
    using RowNext = std::optional<Next>;

    void endBy(SequenceEnd end, std::optional<ModuleIndex> module = {}, std::optional<Refusal> refusal = {});
    [[nodiscard]] Next finishEnding(const Modules& modules);
    void watch(const Modules& modules, TimePoint now);
    [[nodiscard]] bool hasArrived(const ModuleState& module, Move& move, TimePoint now);
    [[nodiscard]] Next proceed(const Modules& modules, TimePoint now);
    [[nodiscard]] RowNext perform(const Action& row, const Modules& modules, TimePoint now);
    [[nodiscard]] RowNext moveTo(const action::MoveTo& move, const Modules& modules, TimePoint now);
    [[nodiscard]] RowNext setOutput(const action::SetOutput& set, const ModuleState& module);
    [[nodiscard]] RowNext findHome(const action::Home& home);
    [[nodiscard]] Next sendMoves(std::span<const PointAxis> axes, unsigned percent, const Modules& modules);
    [[nodiscard]] RowNext turnRound(const Modules& modules, TimePoint now);
    [[nodiscard]] bool awaitsLimitStop(const ModuleState& module, TimePoint now);
    [[nodiscard]] bool anyMoves(std::span<const PointAxis> axes) const;
    [[nodiscard]] Next refused(ModuleIndex module, Refusal refusal);
    [[nodiscard]] Next send(std::vector<std::vector<bus::Order>> operations);
    [[nodiscard]] bool ending() const { return m_report.end.has_value() || m_report.over(); }

    Machine m_machine;
    std::set<ModuleIndex> m_parts;
    SequenceReport m_report;
    bool m_pauseWanted = false;
    unsigned m_inFlight = 0;
    std::map<ModuleIndex, Move> m_moves;         ///< in progress
    std::map<ModuleIndex, TimePoint> m_unarmed;  ///< since when a limit stop is due before their next move
    std::set<ModuleIndex> m_on;                  ///< modules that this run has moved, which stay on
    std::optional<ModuleIndex> m_procedure;
    std::optional<ProcedureReport> m_procedureEnd;
    bool m_saysNothingMore = false;  ///< the motors are taken care of elsewhere
    bool m_cancelled = false;
    bool m_stopsSent = false;           ///< those that need not wait; what follows waits for the results
    std::set<ModuleIndex> m_leftAlone;  ///< not sent the final stop: something else controls them
    Row m_row;
};

}  // namespace nmc
