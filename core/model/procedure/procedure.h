// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "base/time.h"
#include "bus/types.h"
#include "model/frequency/frequencypoint.h"
#include "model/intent/responsetaken.h"
#include "model/module/modulestate.h"
#include "model/procedure/directionfound.h"
#include "model/procedure/repeatability.h"

namespace nmc {

enum class ProcedureKind : std::uint8_t {
    Homing,
    MoveBy,        ///< moves by N, as often as requested
    ChangeMotion,  ///< PIC-STEP: stop, wait, go
    StepResponse,
    StepSeries,
    SquareWave,
    FrequencyResponse,
    DirectionCheck,
    Approach,  ///< a move that takes up the backlash on the way
    TryGains,
    FollowPath,  ///< PIC-SERVO CMC and SC
    Repeatability,
};

/// The time for a motor to come to rest before and after a test.
inline constexpr Duration kStillWithin = std::chrono::seconds(2);

/// True for procedures that measure how the servo follows and need the bus's focus.
[[nodiscard]] constexpr bool isTest(ProcedureKind kind) {
    using enum ProcedureKind;
    return kind == StepResponse || kind == StepSeries || kind == SquareWave || kind == FrequencyResponse ||
           kind == TryGains;
}

/// True for single steps of the command position, each recorded as a run.
[[nodiscard]] constexpr bool makesSteps(ProcedureKind kind) {
    return kind == ProcedureKind::StepResponse || kind == ProcedureKind::StepSeries;
}

/// True for procedures that move the motor about the position that was held.
[[nodiscard]] constexpr bool movesAround(ProcedureKind kind) {
    return isTest(kind) && kind != ProcedureKind::TryGains;
}

/// The stage of a procedure; not every kind has every stage.
enum class ProcedureStage : std::uint8_t {
    Preparing,
    BackingOff,  ///< the switch was active at the start
    Searching,
    SearchingIndex,
    Stopping,
    Reading,  ///< reads the captured home twice
    GoingHome,
    Zeroing,
    TakingUpBacklash,
    Moving,
    Pausing,
    Trying,  ///< with gains that are not kept yet
    Done,
    Failed,
    Cancelled,  ///< by the user, or by a stop
};

enum class ProcedureFailure : std::uint8_t {
    SwitchActive,  ///< and it is impossible to back off from it
    NotFound,      ///< the motion ended without a capture
    TravelLimit,
    TimeLimit,
    LinkSuspect,  ///< an answer was missing or implausible during the procedure, so nothing is certain
    ModuleUnresponsive,
    WentOff,  ///< servo or amplifier went off by itself
    Refused,  ///< a command was refused, forbidden or not answered
    ReadingsDiffer,
    NotStill,      ///< it oscillates where it should stand; the servo stays on
    Unstable,      ///< it went too far and did not come to rest on a hold; it was switched off
    SoftLimit,     ///< the move would leave the travel limits, or a search was about to
    StoppedShort,  ///< the chip ended the move by itself: a limit switch, overheating, the E-stop input
    NotAtHome,     ///< it comes to rest too far from home for home to become zero
    Swings,        ///< it oscillates at rest, with gains on trial
    Saturates,     ///< it reaches its output limit, with gains on trial
    NotStarted,    ///< not every axis of the path started
    UnderRun,      ///< the path buffer ran empty before the end
    OffPath,       ///< the command position was not where the points lead
    NotFollowing,  ///< the position stays, or does not follow the sine of the command
    Reversed,      ///< the motor turned back although it was to keep moving
    Bounced,       ///< the switch changed again while the motor stopped beyond it
};

/// The state of a procedure as shown in the window.
struct ProcedureReport {
    ModuleIndex module;
    ProcedureKind kind = ProcedureKind::Homing;
    ProcedureStage stage = ProcedureStage::Preparing;
    std::optional<ProcedureFailure> failure{};  ///< only for Failed
    std::optional<std::int32_t> home{};         ///< captured position, before it was made zero
    std::int32_t offHome = 0;                   ///< counts from home at rest, for Done and NotAtHome
    unsigned round = 0;  ///< one of `rounds`, counted from 1, for kinds that have rounds
    unsigned rounds = 0;
    std::optional<ResponseTaken> step{};        ///< StepResponse and StepSeries: the last complete step;
                                                ///< SquareWave: the last edge
    std::vector<FrequencyPoint> frequencies{};  ///< FrequencyResponse: the points measured so far
    std::optional<servo::SetGain> gains{};      ///< FrequencyResponse: those with which it is measured;
                                                ///< TryGains: those from before, or kept
    double speed = 0.0;                         ///< FrequencyResponse: counts/s, while it is measured
    std::optional<DirectionFound> direction{};  ///< DirectionCheck: present once it is known
    EdgeCaptures edges{};                       ///< Repeatability: those captured so far
    bool kept = false;                          ///< TryGains: the gains stay in force
    std::optional<bus::PathProgress> path{};    ///< FollowPath: present once it has started

    [[nodiscard]] bool over() const {
        return stage == ProcedureStage::Done || stage == ProcedureStage::Failed ||
               stage == ProcedureStage::Cancelled;
    }
    [[nodiscard]] bool tries() const { return kind == ProcedureKind::TryGains && !over(); }
    bool operator==(const ProcedureReport&) const = default;
};

/// A task with one module that takes more than one operation: it receives the module's state and the outcomes
/// of its operations, and decides what to do next. It only ever waits for the module and the clock. Pure; the
/// procedure controller runs it on the GUI thread, and a stop of any kind cancels it.
///
/// This class contains what all kinds share: one operation at a time, and the handling of an early end,
/// whether it fails or is no longer wanted: the final orders (lastWord) stop whatever the procedure may have
/// started, and only then has it ended.
class Procedure {
public:
    /// The result of next(): nothing for now; an operation to be submitted, whose end is passed to
    /// onFinished() before the next call of next(); or the end, after which next() is not called any more.
    struct Wait {};
    using Send = bus::Operation;  ///< the id is set by the submitter
    struct End {};
    using Next = std::variant<Wait, Send, End>;

    Procedure(const Procedure&) = delete;
    Procedure& operator=(const Procedure&) = delete;
    virtual ~Procedure() = default;

    /// Called after every update of the module, and at least ten times a second.
    [[nodiscard]] Next next(const ModuleState& module, TimePoint now);
    /// `sine`, `trial`: as in bus::OperationFinished.
    void onFinished(bus::Outcome outcome, bus::SineRecord sine = {}, std::optional<bus::TrialEnd> trial = {});
    /// True when a sine, a path or a trial is in flight, so that next() may return orders that end it.
    [[nodiscard]] bool interruptible() const { return m_inFlight && m_lasts; }
    /// Called when an exchange with this module went wrong, or the health of the link is no longer good.
    void onLinkSuspect();
    /// The procedure is no longer wanted; the following next() may still return a stop.
    void cancel();
    /// It ends early, and its stop has yet to be returned.
    [[nodiscard]] bool stopsLater() const { return m_end && !m_lastWordSent; }
    /// It has ended, or does so early: what next() returns from now on only ends what it has started.
    [[nodiscard]] bool ends() const { return m_end || m_report.over(); }
    /// The bus has been asked to keep the gains on trial (Engine::keepTrial); other kinds have none.
    virtual void keep() {}
    /// Passes new gains, which the procedure sends when it is their turn. Returns false when it has no use
    /// for them.
    [[nodiscard]] virtual bool take(const servo::SetGain& /*gains*/) { return false; }
    [[nodiscard]] const ProcedureReport& report() const { return m_report; }

protected:
    Procedure(ModuleIndex module, ProcedureKind kind);

    /// Returns the next step; called while nothing is in flight and the procedure has not ended early.
    [[nodiscard]] virtual Next proceed(const ModuleState& module, TimePoint now) = 0;
    /// Returns the final orders for an early end, stops first; may be empty. Called again if the queue was
    /// full.
    [[nodiscard]] virtual std::vector<bus::Order> lastWord(const ModuleState& module) const = 0;
    /// Called after the final orders: returns any further steps, and End when there are none; finish() if
    /// the goal has been reached all the same.
    [[nodiscard]] virtual Next afterLastWord(const ModuleState& /*module*/, TimePoint /*now*/) {
        return End{};
    }

    /// Called while a sine, a path or a trial is in flight; fail() ends it.
    virtual void whileItLasts(const ModuleState& /*module*/) {}

    [[nodiscard]] Next send(std::vector<bus::Order> orders);
    /// For this PIC-SERVO.
    [[nodiscard]] std::vector<bus::Order> orders(std::vector<ServoCommand> commands) const;
    /// `centre`: the Stop Here that is the only order, about which the sine runs.
    [[nodiscard]] Next swing(bus::Order centre, const bus::Sine& sine);
    /// `starts`: as required by bus::Operation::path.
    [[nodiscard]] Next follow(std::vector<bus::Order> starts, std::shared_ptr<const bus::PathPlan> path);
    [[nodiscard]] Next tryOut(bus::Order gains, const bus::GainTrial& trial);
    /// The operation in flight ends by itself, and nothing else is sent before that.
    void awaitEnd() { m_lasts = false; }
    /// The results of the last sine and the last trial.
    [[nodiscard]] const bus::SineRecord& swung() const { return m_swung; }
    [[nodiscard]] std::optional<bus::TrialEnd> tried() const { return m_tried; }
    /// True if the travel limits have changed since a goal was last judged, and this one is beyond them: one
    /// may have been set nearer.
    [[nodiscard]] bool passesNewLimit(std::int64_t goal, const ModuleState& module);
    /// The goal has been reached.
    [[nodiscard]] Next finish();
    /// Ends the procedure with this failure; next() then gives up at once. Only the first failure counts.
    [[nodiscard]] Next fail(ProcedureFailure failure);

    ProcedureReport m_report;
    /// The procedure may have started the motor, and nothing else has stopped it or switched it off since.
    bool m_mayRun = false;
    std::optional<bus::TravelLimits> m_travel;  ///< those by which a goal was last judged

private:
    [[nodiscard]] Next start(Send operation, bool lasts);

    bool m_inFlight = false;
    bool m_lasts = false;  ///< the operation in flight lasts and can be interrupted
    bus::SineRecord m_swung;
    std::optional<bus::TrialEnd> m_tried;
    bool m_lastWordSent = false;
    std::optional<ProcedureStage> m_end;  ///< Failed or Cancelled, to take effect after the final orders
};

}  // namespace nmc
