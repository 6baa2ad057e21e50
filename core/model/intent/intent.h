// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "base/overloaded.h"
#include "bus/types.h"
#include "model/intent/motion.h"
#include "model/intent/responsetaken.h"
#include "model/module/linkstate.h"
#include "model/module/modulestate.h"
#include "model/settings/machine.h"
#include "protocol/iocommands.h"
#include "protocol/steppercommands.h"

namespace nmc {

/// Moves by a distance, repeated.
struct Rounds {
    std::int32_t counts = 0;  ///< of one move, signed; steps for a PIC-STEP
    unsigned rounds = 1;
    double pause = 0.0;         ///< s, after each move
    bool backAndForth = false;  ///< each round goes there and back
};

/// Requests of the operator to one module; values only, which plan() turns into commands.
namespace intent {
struct AskAnew {};  ///< No Operation, for a module of any type
struct Enable {};   ///< amplifier on, hold the present position, and clear the sticky bits
/// A motion of the module's chip. A run of a servo towards a limit of travel is sent as a move to it.
struct Move {
    MotionSpec motion;
};
/// Moves to home as known when this is planned (model/module/homefact.h).
struct GoHome {
    Pace pace;
};
struct StopSmoothly {};
struct StopAbruptly {};
struct MotorOff {};
struct ApplyGains {
    servo::SetGain gains;
};
struct ClearStickyBits {};
struct ResetPosition {};  ///< "zero here"
struct SaveAsHome {};     ///< saves the present position as home
/// The user's statement about the counter, which sends nothing: it is right, so home is where it is 0; or it
/// is in doubt, so home becomes unknown.
struct DeclarePosition {
    bool right = true;
};
/// A motion like Move, to be started by StartLoaded, of this module or of its group.
struct LoadMove {
    MotionSpec motion;
};
/// Stops a PIC-STEP, waits for standstill, then does a Move, for changes that its Table 4 does not allow in
/// motion. A procedure.
struct ChangeMotion {
    StepperMotion motion;
};
struct StartLoaded {};
/// Holds the present position, without a profile. In motion, it is StopAbruptly.
struct StopHere {};
/// Drives the motor with the servo off: no position limit, position error limit or output limit applies.
struct DrivePwm {
    std::uint8_t pwm = 0;
    bool reverse = false;
};
/// Switches only AMP_EN; the servo is unaffected.
struct SetAmplifier {
    bool enable = false;
};
struct ControlIo {
    servo::IoControl io;
};
/// SC: how the amplifier is driven, and what a limit does by itself. AMP_EN is taken low first.
struct ControlSc {
    servo::ScIoControl io;
};
/// SC: a reset that stores, across power cycles, what the configuration selects, the address, and the present
/// velocity, acceleration and gains; or one that erases all of them. The module restarts.
struct SaveConfiguration {
    servo::HardReset configuration;
};
/// Searches for home, on either motor chip. A procedure.
struct Home {
    HomingRecipe recipe;
    /// Distance from home, in counts, at which the motor may rest and still be set to zero (homeTolerance()).
    std::int32_t tolerance = 0;
};
/// Approaches one switch or the index from both sides, to see how repeatable that is and how much backlash
/// there is. The conditions of `recipe` are that one input; its direction is the one in which the switch
/// closes; how it ends is ignored. A procedure.
struct MeasureRepeatability {
    HomingRecipe recipe;
    unsigned times = 10;  ///< from each side
};
/// Makes trapezoidal moves by a distance, one after the other. A procedure.
struct MoveBy {
    Rounds moves;
    Pace pace;
};
/// Makes a small move without a profile, or a profiled move, from the position that the servo holds, to see
/// how it follows (looptestplan.h). A procedure.
struct StepResponse {
    std::int32_t counts = 0;  ///< signed
    ResponseMethod method = ResponseMethod::Profile;
    double record = 0.0;                    ///< s, from the step or the end of the profile on
    std::optional<servo::SetGain> gains{};  ///< sent before the step; empty: the present gains are used
    ServoPace pace{};                       ///< ResponseMethod::Move
    bool operator==(const StepResponse&) const = default;
};
/// Makes a series of step responses, from which a motor can be identified (looptestplan.h). A procedure.
struct StepSeries {
    StepResponse each;                 ///< except for its distance
    std::vector<std::int32_t> counts;  ///< distance of each, from the end of the previous one
    bool operator==(const StepSeries&) const = default;
};
/// Makes the command position jump to and fro about the one held, by half of `counts` to either side
/// (looptestplan.h). A procedure, which accepts new gains for the following edges.
struct SquareWave {
    std::int32_t counts = 0;  ///< from one side to the other
    double period = 0.0;      ///< s
    unsigned rounds = 0;
    std::int32_t excursion = 0;  ///< counts beyond either side; exceeding it ends the test
    ResponseMethod method = ResponseMethod::StopHere;
};
/// Moves the command position in sines about the one held, one frequency after the other (looptestplan.h).
/// With a speed, the sines ride on a motion away from there and back, so fast that the motor never reverses,
/// and dry friction does not matter. A procedure.
struct FrequencyResponse {
    std::int32_t amplitude = 0;  ///< counts
    double from = 0.0;           ///< Hz
    double to = 0.0;             ///< Hz; not reached if the line is too slow
    double speed = 0.0;          ///< counts per servo tick; negative: backwards first
};
/// Tries gains for a while, after which the previous ones are restored unless the new ones are kept
/// (gainsplan.h). A procedure.
struct TryGains {
    servo::SetGain gains;
    double seconds = 10.0;
};
/// Keeps the gains being tried.
struct KeepGains {};
/// Gives short, weak pushes in PWM mode that show whether motor and encoder agree, before the servo is
/// switched on for the first time. A procedure (model/procedure/directioncheck.h).
struct CheckDirection {
    std::int32_t reach = 0;  ///< counts; exceeding it ends the check (directionReach())
};
/// Follows the points of a path, for this module or for all its axes (model/path/pathplan.h makes one).
/// Addressed to its first axis. A procedure.
struct FollowPath {
    std::shared_ptr<const bus::PathPlan> plan;
};
/// Ends any procedure running with this module; the motor is stopped smoothly.
struct CancelProcedure {};
/// Uses homing as a safety stop (DS-V 5.2): the chip stops by itself when a chosen limit changes, or when the
/// position error or the current exceeds its limit. With no condition chosen, it disarms the stop.
using ArmLimitStop = ChipStop;
/// A single command with any data bytes, for users who know the data sheet (directplan.h).
struct Direct {
    ModuleCommand command;
};
/// Resets this module alone to its power-up state: it loses everything except its address.
struct ResetModule {};
}  // namespace intent

/// Requests of the operator to a PIC-STEP, besides those that both motor chips have.
namespace stepperintent {
/// Sets the parameters, which is required before any motion (DS-S 5.1).
struct SetParameters {
    stepper::SetParameters parameters;
};
/// Sets OUT1..OUT5, all at once, as bits 0..4.
struct SetOutputs {
    std::uint8_t outputs = 0;
};
}  // namespace stepperintent

/// Requests of the operator to a PIC-I/O. Pins and PWM outputs are numbered from 0.
namespace iointent {
struct SetDirection {
    std::uint16_t inputs = io::kAllPins;
};
/// Sets a single output; the others stay as they are.
struct SetOutput {
    unsigned pin = 0;
    bool high = false;
};
/// One command sets both PWM outputs: the one that is not meant stays as it is.
struct SetPwm {
    unsigned output = 0;
    std::uint8_t value = 0;
    std::optional<std::uint8_t> other{};  ///< of the other one, in case its present value is unknown
};
/// Sets the timer mode; the count starts at 0.
struct SetTimer {
    io::SetTimerMode mode;
};
/// Stores outputs for SynchOutput, of this module or of its group.
struct StoreOutputs {
    io::SetSynchOutput outputs;
};
struct SynchOutput {};
/// Latches pins and counter, and reads the latched values.
struct SynchInput {};
}  // namespace iointent

// Each intent is in one of these lists, which state which chips it is for and whether it moves the motor.
using AnyModuleIntent =
    std::variant<intent::AskAnew, intent::CancelProcedure, intent::Direct, intent::ResetModule>;
/// For both motor chips. StartLoaded moves as loaded before.
using MotorSetting = std::variant<intent::Enable, intent::StopSmoothly, intent::StopAbruptly,
                                  intent::MotorOff, intent::SetAmplifier, intent::ResetPosition,
                                  intent::SaveAsHome, intent::DeclarePosition, intent::StartLoaded>;
/// MoveBy, Home and MeasureRepeatability are procedures; so is Move where the axis has backlash to take up.
using MoveIntent = std::variant<intent::Move, intent::LoadMove, intent::GoHome, intent::MoveBy, intent::Home,
                                intent::MeasureRepeatability>;
using ServoSetting =
    std::variant<intent::ApplyGains, intent::KeepGains, intent::ClearStickyBits, intent::StopHere,
                 intent::ControlIo, intent::ControlSc, intent::SaveConfiguration, intent::ArmLimitStop>;
using ServoProcedure =
    std::variant<intent::StepResponse, intent::StepSeries, intent::SquareWave, intent::FrequencyResponse,
                 intent::TryGains, intent::CheckDirection, intent::FollowPath>;
using StepperSetting = std::variant<stepperintent::SetParameters, stepperintent::SetOutputs>;
using IoIntent =
    std::variant<iointent::SetDirection, iointent::SetOutput, iointent::SetPwm, iointent::SetTimer,
                 iointent::StoreOutputs, iointent::SynchOutput, iointent::SynchInput>;

using ServoIntent = Join<std::variant<intent::DrivePwm>, ServoSetting, ServoProcedure>;
using StepperIntent = Join<std::variant<intent::ChangeMotion>, StepperSetting>;
using Intent = Join<AnyModuleIntent, MotorSetting, MoveIntent, ServoIntent, StepperIntent, IoIntent>;

/// True if it stops a motor: such an intent does not wait, and overtakes everything.
[[nodiscard]] bool isStop(const Intent& intent);

/// The preconditions that prevent a request now; the window's texts have a sentence for each.
enum class Refusal : std::uint8_t {
    NotConnected,
    ReadOnly,      ///< the connection is read-only
    Lent,          ///< the line is lent to a program
    OperatorMode,  ///< the panel is locked
    NotAServo,
    NoMotor,  ///< a PIC-I/O
    NotAnIoModule,
    Unresponsive,
    NotAsked,   ///< sending has stopped, because another module restarted
    Looking,    ///< the chain is being searched for again; stops still work
    OtherType,  ///< the machine has another type of module at this place; stops still work
    NoPower,
    GainsUnknown,      ///< a servo with gains 0 or unknown would not hold
    ServoRateUnknown,  ///< SR is unknown, and therefore speeds per second as well
    ServoOff,          ///< enable first
    Moving,            ///< trapezoidal moves start from standstill only
    NoAcceleration,    ///< 0 or unknown: the motor might never start or stop
    NoVelocity,        ///< 0, or unknown because another host has loaded it
    NothingLoaded,     ///< no confirmed load waits for a start
    PositionUnknown,
    HomeUnknown,     ///< not searched for or saved, or the counter may have been set since
    ServoOn,         ///< PWM mode requires the servo to be off
    VersionLacksIt,  ///< the chip's version does not have it
    NothingToFind,   ///< no home condition was chosen
    NoSingleInput,   ///< a measurement needs one switch or the index, and nothing else
    TooFewOrMany,    ///< approaches: kFewestApproaches to kMostApproaches
    NoSearchLimits,  ///< a search without travel or time limit
    LimitActive,     ///< a stop on its change would occur when the switch is left
    LimitClosed,     ///< SC: does not start towards a closed limit
    LimitIsOutput,   ///< the pin is an output, so it reports nothing
    StartApart,      ///< a move to a position must not be started by the command that loads it
    StepTooShort,    ///< a move by 0 counts
    StepTooLong,     ///< a step response requires a small move
    StepWouldTrip,   ///< the position error of the step would exceed its limit, or nearly
    GoalOutOfRange,  ///< beyond the chip's 32 bits
    BeyondTravel,    ///< the goal is outside the travel limits; travel.h has the details of this and the next
                     ///< three
    AtTravelEnd,     ///< no travel is left in that direction
    TooFast,         ///< exceeds the axis's limit set by the user
    TooSlow,         ///< PIC-STEP: it would go faster, at the least speed of its mode and parameters
    RunNeedsStop,    ///< towards a limit, a run must start from standstill, so that the chip ends it there
    LimitStopDue,    ///< the axis uses one for each motion, and it is not armed yet
    NoCurrentLimit,  ///< CL is 0, so the current never exceeds the limit
    CommandUnknown,  ///< the exact position that the servo holds is unknown
    RecordTime,      ///< none, or longer than the bus can be reserved for one module
    MoveTooLong,     ///< a profiled move and the record after it exceed kLongestMove
    PathNotPossible,  ///< pathplan.h has the reason
    NeedsStop,        ///< not allowed on a path, or in the present mode of a PIC-STEP (DS-S Table 4), where
                      ///< ChangeMotion can do it
    TestOutOfRange,   ///< times, frequencies or travel of a loop test
    TestTooSlow,      ///< the motor would reverse although it is to keep moving
    // PIC-STEP
    NotAStepper,
    ParametersUnknown,  ///< no motion and no holding before they are set
    AmplifierOff,       ///< enable first
    EstopActive,
    Limit1Active,  ///< blocks forward
    Limit2Active,  ///< blocks reverse
    TooHot,        ///< the A/D value is below the thermal limit
    TooFar,        ///< a move of more than 0x7FFFFFFF counts or steps
};

/// What a request needs, and its refusal otherwise.
struct Need {
    bool met;
    Refusal otherwise;
};
/// The refusal for the first need that is not met.
[[nodiscard]] std::optional<Refusal> firstUnmet(std::initializer_list<Need> needs);

using Orders = std::vector<bus::Order>;
using Plan = tl::expected<Orders, Refusal>;
/// Returns the commands for an intent, in order, or the precondition that is not met. The same preconditions
/// enable and disable the controls: what whyNot() reports is greyed out and explained.
[[nodiscard]] Plan plan(const Intent& intent, const ModuleState& module);
/// The commands that stop the motor smoothly, even if the module is believed silent; empty if nothing is on.
[[nodiscard]] Orders stopOf(ModuleState module);

/// The kinds of request for which a panel shows a control; values still being typed do not matter here.
enum class IntentKind : std::uint8_t {
    Enable,
    Move,
    Load,  ///< a move to be started later
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
    ControlSc,  ///< also saving it
    Home,
    ArmLimitStop,
    ResetModule,
    // PIC-STEP; the precondition of its motions is in stepperplan.h
    SetParameters,
    SetOutputs  ///< also for a PIC-I/O
};
[[nodiscard]] bool isStop(IntentKind kind);
[[nodiscard]] std::optional<Refusal> whyNot(IntentKind kind, const ModuleState& module);

/// The move to home; empty while home is unknown.
[[nodiscard]] std::optional<MotionSpec> motionOf(const intent::GoHome& goHome, const ModuleState& module);

/// Why the counter cannot be declared right now, for either motor chip.
[[nodiscard]] std::optional<Refusal> whyNotDeclare(const ModuleState& module);

/// Why nothing at all can be sent to this module, whatever the request; every precondition checks this first.
/// MotorOff may always be tried, whatever is believed about the module.
[[nodiscard]] std::optional<Refusal> whyInaccessible(IntentKind kind, const ModuleState& module);
/// Why the chain as a whole cannot be changed now: its rate, its groups, its restart.
[[nodiscard]] std::optional<Refusal> whyInaccessible(const LinkState& link);
/// Why there is no chain now to send requests to.
[[nodiscard]] std::optional<Refusal> whyNoChain(const LinkState& link);
/// Why there is no chain now to send a stop to; a search does not prevent that.
[[nodiscard]] std::optional<Refusal> whyNoStop(const LinkState& link);

}  // namespace nmc
