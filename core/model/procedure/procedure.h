// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "base/time.h"
#include "bus/types.h"
#include "model/intent/steptaken.h"
#include "model/module/modulestate.h"

namespace nmc {

enum class ProcedureKind : std::uint8_t {
    Homing,
    StepBy,        ///< moves by N, as often as asked for
    ChangeMotion,  ///< PIC-STEP: stop, wait, go
    StepResponse,
};

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
    Moving,
    Pausing,
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
    ModuleSilent,
    WentOff,  ///< servo or amplifier went off by itself
    Refused,  ///< a command was refused, forbidden or not answered
    ReadingsDiffer,
    NotStill,   ///< it swings where it should stand; the servo stays on
    Unstable,   ///< it has gone too far, and did not come to rest by a hold; it was switched off
    NotAtHome,  ///< it does not come to rest at home exactly, so that must not become zero
};

/// What the window shows of a procedure.
struct ProcedureReport {
    ModuleIndex module;
    ProcedureKind kind = ProcedureKind::Homing;
    ProcedureStage stage = ProcedureStage::Preparing;
    std::optional<ProcedureFailure> failure{};  ///< of Failed
    std::optional<std::int32_t> home{};         ///< captured, before it was made zero
    unsigned round = 0;                         ///< of `rounds`, where the kind has them; from 1
    unsigned rounds = 0;
    std::optional<StepTaken> step{};  ///< of StepResponse, once it was taken

    [[nodiscard]] bool over() const {
        return stage == ProcedureStage::Done || stage == ProcedureStage::Failed ||
               stage == ProcedureStage::Cancelled;
    }
    bool operator==(const ProcedureReport&) const = default;
};

/// Something with one module that takes more than one operation: it is told what the module says and how its
/// operations ended, and says what to do next. It never waits for anything but the module and the clock.
/// Pure; the procedure controller runs it on the GUI thread, and a stop of any kind cancels it.
class Procedure {
public:
    /// Nothing for now; an operation to be submitted, whose end comes by onFinished() before next() is asked
    /// again; or the end, after which it is asked no more.
    struct Wait {};
    struct Send {
        std::vector<bus::Step> steps;
    };
    struct End {};
    using Next = std::variant<Wait, Send, End>;

    Procedure() = default;
    Procedure(const Procedure&) = delete;
    Procedure& operator=(const Procedure&) = delete;
    virtual ~Procedure() = default;

    /// After every news of the module, and at least ten times a second.
    [[nodiscard]] virtual Next next(const ModuleState& module, TimePoint now) = 0;
    virtual void onFinished(bus::Outcome outcome) = 0;
    /// An exchange with this module went wrong, or the link's health is not good any more.
    virtual void onLinkSuspect() = 0;
    /// Nothing more is wanted of it; the next() after this may still send a stop.
    virtual void cancel() = 0;
    [[nodiscard]] virtual ProcedureReport report() const = 0;
};

}  // namespace nmc
