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

namespace nmc {

enum class ProcedureKind : std::uint8_t {
    Homing,
    MoveBy,        ///< moves by N, as often as asked for
    ChangeMotion,  ///< PIC-STEP: stop, wait, go
    StepResponse,
    StepSeries,
    SquareWave,
    FrequencyResponse,
    DirectionCheck,
    Approach,  ///< a move that takes up the backlash on its way
    TryGains,
    FollowPath,  ///< PIC-SERVO CMC and SC
};

/// For a motor to stand still, before a test drives it and after.
inline constexpr Duration kStillWithin = std::chrono::seconds(2);

/// It looks at how the servo follows, and wants the bus's focus.
[[nodiscard]] constexpr bool isTest(ProcedureKind kind) {
    using enum ProcedureKind;
    return kind == StepResponse || kind == StepSeries || kind == SquareWave || kind == FrequencyResponse ||
           kind == TryGains;
}

/// Single steps of the command, each recorded as a run.
[[nodiscard]] constexpr bool makesSteps(ProcedureKind kind) {
    return kind == ProcedureKind::StepResponse || kind == ProcedureKind::StepSeries;
}

/// It drives the motor about the position that was held.
[[nodiscard]] constexpr bool movesAround(ProcedureKind kind) {
    return isTest(kind) && kind != ProcedureKind::TryGains;
}

/// Where a procedure is; not every kind has every stage.
enum class ProcedureStage : std::uint8_t {
    Preparing,
    BackingOff,  ///< the switch was active at the start
    Searching,
    SearchingIndex,
    Stopping,
    Reading,  ///< the captured home, twice
    GoingHome,
    Zeroing,
    TakingUpBacklash,
    Moving,
    Pausing,
    Trying,  ///< gains that are not kept yet
    Done,
    Failed,
    Cancelled,  ///< by the user, or overtaken by a stop
};

enum class ProcedureFailure : std::uint8_t {
    SwitchActive,  ///< and there is no way to back off from it
    NotFound,      ///< the motion ended, and nothing was captured
    TravelLimit,
    TimeLimit,
    LinkSuspect,  ///< an answer was missed or not believed meanwhile, so nothing is certain
    ModuleUnresponsive,
    WentOff,  ///< servo or amplifier went off by itself
    Refused,  ///< a command was refused, forbidden or not answered
    ReadingsDiffer,
    NotStill,      ///< it swings where it should stand; the servo stays on
    Unstable,      ///< it has gone too far, and did not come to rest by a hold; it was switched off
    SoftLimit,     ///< the next move would leave the limits of travel, or a search was about to
    StoppedShort,  ///< the chip has ended the move by itself: a limit switch, heat, the E-stop input
    NotAtHome,     ///< it comes to rest too far from home for that to become zero
    Swings,        ///< at rest, with gains that were being tried
    Saturates,     ///< the same: its output limit is reached
    NotStarted,    ///< not every axis of the path
    UnderRun,      ///< the path buffer ran dry before the end
    OffPath,       ///< the command position was not where the points lead
    NotFollowing,  ///< its position stays, or goes another way than a sine of the command
};

/// What the window shows of a procedure.
struct ProcedureReport {
    ModuleIndex module;
    ProcedureKind kind = ProcedureKind::Homing;
    ProcedureStage stage = ProcedureStage::Preparing;
    std::optional<ProcedureFailure> failure{};  ///< of Failed
    std::optional<std::int32_t> home{};         ///< captured, before it was made zero
    std::int32_t offHome = 0;                   ///< counts that it rests off its home, of Done and NotAtHome
    unsigned round = 0;                         ///< of `rounds`, where the kind has them; from 1
    unsigned rounds = 0;
    std::optional<ResponseTaken> step{};  ///< of StepResponse and StepSeries the last that is recorded whole;
                                          ///< of SquareWave the last edge
    std::vector<FrequencyPoint> frequencies{};  ///< of FrequencyResponse, those that were measured
    std::optional<DirectionFound> direction{};  ///< of DirectionCheck, once it is known
    bool kept = false;                          ///< of TryGains: they stay
    std::optional<bus::PathProgress> path{};    ///< of FollowPath, once it is under way

    [[nodiscard]] bool over() const {
        return stage == ProcedureStage::Done || stage == ProcedureStage::Failed ||
               stage == ProcedureStage::Cancelled;
    }
    bool operator==(const ProcedureReport&) const = default;
};

/// Something with one module that takes more than one operation: it is told what the module says and how its
/// operations ended, and says what to do next. It never waits for anything but the module and the clock.
/// Pure; the procedure controller runs it on the GUI thread, and a stop of any kind cancels it.
///
/// What is common to all is here: one operation at a time; an end before the goal, for a reason or because it
/// is not wanted any more, sends a last word, which stops what this may have set going, and is an end only
/// then.
class Procedure {
public:
    /// Nothing for now; an operation to be submitted, whose end comes by onFinished() before next() is asked
    /// again; or the end, after which it is asked no more.
    struct Wait {};
    using Send = bus::Operation;  ///< its id is for whoever submits it
    struct End {};
    using Next = std::variant<Wait, Send, End>;

    Procedure(const Procedure&) = delete;
    Procedure& operator=(const Procedure&) = delete;
    virtual ~Procedure() = default;

    /// After every news of the module, and at least ten times a second.
    [[nodiscard]] Next next(const ModuleState& module, TimePoint now);
    /// `sine`, `trial`: as in bus::OperationFinished.
    void onFinished(bus::Outcome outcome, bus::SineRecord sine = {}, std::optional<bus::TrialEnd> trial = {});
    /// What is in flight is a sine, a path or a trial, and next() may have something to send that ends it.
    [[nodiscard]] bool interruptible() const { return m_inFlight && m_lasts; }
    /// An exchange with this module went wrong, or the link's health is not good any more.
    void onLinkSuspect();
    /// Nothing more is wanted of it; the next() after this may still send a stop.
    void cancel();
    /// The bus has been asked to keep what it tries (Engine::keepTrial); of the other kinds nothing is tried.
    virtual void keep() {}
    /// Other gains, from its next edge on. False: it has no use for them.
    [[nodiscard]] virtual bool take(const servo::SetGain& /*gains*/) { return false; }
    [[nodiscard]] const ProcedureReport& report() const { return m_report; }

protected:
    Procedure(ModuleIndex module, ProcedureKind kind);

    /// What comes next; while nothing is in flight, and as long as it has not ended early.
    [[nodiscard]] virtual Next proceed(const ModuleState& module, TimePoint now) = 0;
    /// What must be sent when it ends early; nothing for nothing. Once.
    [[nodiscard]] virtual std::vector<bus::Order> lastWord(const ModuleState& module) const = 0;
    /// Behind the last word: whatever else it takes; End when that is all.
    [[nodiscard]] virtual Next afterLastWord(const ModuleState& /*module*/, TimePoint /*now*/) {
        return End{};
    }

    /// While a sine, a path or a trial is in flight: fail() ends it.
    virtual void whileItLasts(const ModuleState& /*module*/) {}

    [[nodiscard]] Next send(std::vector<bus::Order> orders);
    /// About the Stop Here that is the only step.
    [[nodiscard]] Next swing(bus::Order centre, const bus::Sine& sine);
    /// `starts`: as bus::Operation::path wants them.
    [[nodiscard]] Next follow(std::vector<bus::Order> starts, std::shared_ptr<const bus::PathPlan> path);
    [[nodiscard]] Next tryOut(bus::Order gains, const bus::GainTrial& trial);
    /// What is in flight ends by itself, and only then anything else is sent.
    void awaitEnd() { m_lasts = false; }
    /// What came of the last sine, and of the last trial.
    [[nodiscard]] const bus::SineRecord& swung() const { return m_swung; }
    [[nodiscard]] std::optional<bus::TrialEnd> tried() const { return m_tried; }
    /// The goal is reached.
    [[nodiscard]] Next finish();
    /// It ends for that reason; next() gives up at once. The first reason counts.
    [[nodiscard]] Next fail(ProcedureFailure failure);

    ProcedureReport m_report;
    /// This may have set the motor going, and nobody else has stopped it or switched it off since.
    bool m_mayRun = false;

private:
    [[nodiscard]] Next start(Send operation, bool lasts);
    [[nodiscard]] bool ends() const { return m_end || m_report.over(); }

    bool m_inFlight = false;
    bool m_lasts = false;  ///< what is in flight
    bus::SineRecord m_swung;
    std::optional<bus::TrialEnd> m_tried;
    bool m_lastWordSent = false;
    std::optional<ProcedureStage> m_end;  ///< Failed or Cancelled, once all has been said
};

}  // namespace nmc
