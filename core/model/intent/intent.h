// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "base/overloaded.h"
#include "bus/types.h"
#include "model/intent/iointent.h"
#include "model/intent/responsetaken.h"
#include "model/intent/stepperintent.h"
#include "model/module/linkstate.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"

namespace nmc {

/// What the operator asks of one module; a PIC-STEP has more in stepperintent.h, a PIC-I/O in iointent.h.
/// Values only; planning it is plan()'s business.
namespace intent {
struct AskAnew {};  ///< No Operation: of any module, whatever it is
struct Enable {};   ///< amplifier on, hold the present position, and clear the sticky bits
struct GoTo {
    Counts position;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
};
/// To home as it is known when this is planned (model/module/homefact.h).
struct GoHome {
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
};
struct RunAtVelocity {
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool reverse = false;
};
struct StopSmoothly {};
struct StopAbruptly {};
struct MotorOff {};
struct ApplyGains {
    servo::SetGain gains;
};
struct ClearStickyBits {};
struct ResetPosition {};  ///< "zero here"
struct SaveAsHome {};     ///< the present position
/// The user's word on the counter, which sends nothing: right, so that home is where it is 0; or in doubt, so
/// that home is not known.
struct DeclarePosition {
    bool right = true;
};
/// As GoTo, to be started by StartLoaded: of this module, or of its group.
struct LoadMove {
    GoTo move;
};
struct StartLoaded {};
/// Holds the position it has now, without a profile.
struct StopHere {};
/// Drives the motor without servo: no position limit, no position error, no output limit applies.
struct DrivePwm {
    std::uint8_t pwm = 0;
    bool reverse = false;
};
/// AMP_EN alone; the servo stays as it is.
struct SetAmplifier {
    bool enable = false;
};
struct ControlIo {
    servo::IoControl io;
};
/// Of an SC: how its amplifier is driven and what a limit does by itself. AMP_EN is taken low first.
struct ControlSc {
    servo::ScIoControl io;
};
/// Of an SC: a reset that keeps, over a power cycle, what the configuration says, its address, and its
/// velocity, acceleration and gains as they are; or that forgets all of them. The module restarts.
struct SaveConfiguration {
    servo::HardReset configuration;
};
/// Look for home; either chip. A procedure.
struct Home {
    HomingRecipe recipe;
    /// Counts that it may rest off its home and make it zero all the same (homeTolerance()).
    std::int32_t tolerance = 0;
};
/// Trapezoidal moves by N, one after the other. A procedure.
struct MoveBy {
    Rounds moves;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
};
/// A small move without a profile, from the position that the servo holds, to see how it follows
/// (looptestplan.h). A procedure.
struct StepResponse {
    std::int32_t counts = 0;  ///< signed
    ResponseMethod method = ResponseMethod::Profile;
    double record = 0.0;                    ///< s, from the step on
    std::optional<servo::SetGain> gains{};  ///< sent before the step; empty: it has those that are wanted
};
/// Such steps one after the other, for a motor to be found from (looptestplan.h). A procedure.
struct StepSeries {
    StepResponse each;                 ///< but for its distance
    std::vector<std::int32_t> counts;  ///< how far each goes, from where the one before has ended
};
/// The command position jumps to and fro about the one that is held, half of `counts` to either side
/// (looptestplan.h). A procedure, which takes other gains for the edges after them.
struct SquareWave {
    std::int32_t counts = 0;  ///< from side to side
    double period = 0.0;      ///< s
    unsigned rounds = 0;
    std::int32_t excursion = 0;  ///< counts beyond either side; farther than that ends it
    ResponseMethod method = ResponseMethod::StopHere;
};
/// Sines of the command position about the one that is held, one frequency after the other (looptestplan.h).
/// A procedure.
struct FrequencyResponse {
    std::int32_t amplitude = 0;  ///< counts
    double from = 0.0;           ///< Hz
    double to = 0.0;             ///< Hz; not reached where the line is too slow for it
};
/// Gains for a while, after which those from before are back, unless they are kept (gainsplan.h). A
/// procedure.
struct TryGains {
    servo::SetGain gains;
    double seconds = 10.0;
};
/// What is being tried stays.
struct KeepGains {};
/// Short, weak pushes in PWM mode that tell whether motor and encoder agree, before the servo is on for the
/// first time. A procedure (model/procedure/directioncheck.h).
struct CheckDirection {
    std::int32_t reach = 0;  ///< counts; farther than that ends it (directionReach())
};
/// Through the points of a path, of this module or of all its axes (model/path/pathplan.h makes one). Asked
/// of its first axis. A procedure.
struct FollowPath {
    std::shared_ptr<const bus::PathPlan> plan;
};
/// Ends whatever procedure runs with this module: the motor is stopped smoothly.
struct CancelProcedure {};
/// Homing used as a safety stop (DS-V 5.2): the chip stops by itself when a chosen limit changes, or when the
/// position error or the current exceeds its limit. None of them: no longer.
struct ArmLimitStop {
    bool limit1 = false;
    bool limit2 = false;
    HomingRecipe::Stop manner = HomingRecipe::Stop::Abruptly;
    bool onPositionError = false;
    bool onCurrentLimit = false;

    [[nodiscard]] bool any() const { return limit1 || limit2 || onPositionError || onCurrentLimit; }
};
/// One command with all that its data bytes can say, for who knows the data sheet (directplan.h).
struct Direct {
    ModuleCommand command;
};
/// Back to its power-up state, alone: it loses all but its address.
struct ResetModule {};
}  // namespace intent

// Each intent stands in one of these lists, which say whom it is for and whether it moves the motor.
using AnyModuleIntent =
    std::variant<intent::AskAnew, intent::CancelProcedure, intent::Direct, intent::ResetModule>;
/// Of either motor chip. Home is a procedure; StartLoaded moves as it was loaded.
using MotorIntent = std::variant<intent::Enable, intent::StopSmoothly, intent::StopAbruptly, intent::MotorOff,
                                 intent::SetAmplifier, intent::ResetPosition, intent::SaveAsHome,
                                 intent::DeclarePosition, intent::StartLoaded, intent::Home>;
using ServoMotion =
    std::variant<intent::GoTo, intent::GoHome, intent::RunAtVelocity, intent::LoadMove, intent::DrivePwm>;
using ServoSetting =
    std::variant<intent::ApplyGains, intent::KeepGains, intent::ClearStickyBits, intent::StopHere,
                 intent::ControlIo, intent::ControlSc, intent::SaveConfiguration, intent::ArmLimitStop>;
using ServoProcedure =
    std::variant<intent::MoveBy, intent::StepResponse, intent::StepSeries, intent::SquareWave,
                 intent::FrequencyResponse, intent::TryGains, intent::CheckDirection, intent::FollowPath>;
/// ChangeMotion and MoveBy are procedures.
using StepperMotionIntent =
    std::variant<stepperintent::Move, stepperintent::LoadMove, stepperintent::ChangeMotion,
                 stepperintent::MoveBy, stepperintent::GoHome>;
using StepperSetting = std::variant<stepperintent::SetParameters, stepperintent::SetOutputs>;
using IoIntent =
    std::variant<iointent::SetDirection, iointent::SetOutput, iointent::SetPwm, iointent::SetTimer,
                 iointent::StoreOutputs, iointent::SynchOutput, iointent::SynchInput>;

using ServoIntent = Join<ServoMotion, ServoSetting, ServoProcedure>;
using StepperIntent = Join<StepperMotionIntent, StepperSetting>;
using Intent = Join<AnyModuleIntent, MotorIntent, ServoIntent, StepperIntent, IoIntent>;

/// It stops a motor: it waits for nothing, and goes past everything.
[[nodiscard]] bool isStop(const Intent& intent);

/// Why something cannot be asked for now; the window's texts have a sentence for each.
enum class Refusal : std::uint8_t {
    NotConnected,
    ReadOnly,      ///< the connection only looks
    OperatorMode,  ///< the panel is locked
    NotAServo,
    NoMotor,  ///< a PIC-I/O
    NotAnIoModule,
    Unresponsive,
    Looking,  ///< the chain is looked for again; stops act
    NoPower,
    GainsUnknown,      ///< a servo with gains 0 or unknown would not hold
    ServoRateUnknown,  ///< SR is not known, so speeds per second are not either
    ServoOff,          ///< enable first
    Moving,            ///< trapezoidal moves start from standstill only
    NoAcceleration,    ///< with acceleration 0 nothing would ever move or stop
    NoVelocity,
    NothingLoaded,  ///< no confirmed load waits for a start
    PositionUnknown,
    HomeUnknown,      ///< nobody has searched or saved it, or the counter may have been set since
    ServoOn,          ///< PWM mode is for a servo that is off
    VersionLacksIt,   ///< the chip's version cannot do it
    NothingToFind,    ///< no condition for home was chosen
    NoSearchLimits,   ///< a search without a travel or a time limit
    LimitActive,      ///< a stop on its change would come when it is left
    LimitClosed,      ///< SC: it does not start towards a closed limit
    LimitIsOutput,    ///< the pin is an output, so it tells nothing
    StartApart,       ///< a trapezoidal move is not started by the command that loads it
    StepTooShort,     ///< a move by 0 counts
    StepTooLong,      ///< a step response is for a small move
    StepWouldTrip,    ///< the position error of the step would exceed its limit, or nearly
    GoalOutOfRange,   ///< beyond the chip's 32 bits
    BeyondTravel,     ///< the goal is outside the limits of travel; travel.h knows the details of these four
    AtTravelEnd,      ///< nothing is left to go that way
    TooFast,          ///< for this axis, as the user has set it
    RunNeedsStop,     ///< towards a limit a run starts from standstill, so that the chip ends it there
    LimitStopDue,     ///< the axis wants one for each motion, and it is not armed yet
    NoCurrentLimit,   ///< CL is 0, so the current never exceeds it
    CommandUnknown,   ///< which position the servo holds, to the count
    RecordTime,       ///< none, or longer than the bus can be given to one module
    PathNotPossible,  ///< pathplan.h says why
    TestOutOfRange,   ///< times, frequencies or travel of a test of the loop
    // PIC-STEP
    NotAStepper,
    ParametersUnknown,  ///< nothing moves, and nothing holds, before they were set
    AmplifierOff,       ///< enable first
    NeedsStop,          ///< DS-S Table 4: not from what it does now; ChangeMotion does it
    EstopActive,
    Limit1Active,  ///< blocks forward
    Limit2Active,  ///< blocks reverse
    TooHot,        ///< the A/D value is below the thermal limit
    TooFar,        ///< a move of more than 0x7FFFFFFF steps
};

/// The commands for an intent, in order, or why not. The same rule enables and disables the controls:
/// what whyNot() refuses is greyed out and says so.
[[nodiscard]] tl::expected<std::vector<bus::Order>, Refusal> plan(const Intent& intent,
                                                                  const ModuleState& module);

/// The kinds of request a panel shows a control for; values that are still being typed do not matter here.
enum class IntentKind : std::uint8_t {
    Enable,
    Move,
    Load,  ///< a move, to be started later
    GoHome,
    Run,
    Hold,
    StopMotion,
    MotorOff,
    ApplyGains,
    ClearStickyBits,
    ResetPosition,
    SaveAsHome,
    DeclarePosition,
    StartLoaded,
    StopHere,
    DrivePwm,
    CheckDirection,
    SetAmplifier,
    ControlIo,
    ControlSc,  ///< or save it
    Home,
    ArmLimitStop,
    ResetModule,
    // PIC-STEP; its motions have a rule of their own, in stepplan.h
    SetParameters,
    SetOutputs  ///< of a PIC-I/O, too
};
[[nodiscard]] bool isStop(IntentKind kind);
[[nodiscard]] std::optional<Refusal> whyNot(IntentKind kind, const ModuleState& module);

/// Why nobody can say now that the counter is right, of either chip.
[[nodiscard]] std::optional<Refusal> whyNotDeclare(const ModuleState& module);

/// Why nothing at all can be told to this module, whoever asks for what: every rule asks this one first.
/// MotorOff is worth trying whatever is believed of it.
[[nodiscard]] std::optional<Refusal> whyInaccessible(IntentKind kind, const ModuleState& module);
/// The same of the chain as a whole: its rate, its groups, its restart.
[[nodiscard]] std::optional<Refusal> whyInaccessible(const LinkState& link);
/// Why there is no chain now that could be asked for anything.
[[nodiscard]] std::optional<Refusal> whyNoChain(const LinkState& link);

}  // namespace nmc
