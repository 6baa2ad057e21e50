// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "bus/path.h"
#include "bus/rejection.h"
#include "module/modulecommand.h"
#include "module/stopmanner.h"

/// Inputs and outputs of the bus engine. Values only; any thread may hold copies.
namespace nmc::bus {

/// The travel limits of an axis, in its chip's present counts; empty: no limit on that side.
struct TravelLimits {
    std::optional<std::int32_t> lowest;
    std::optional<std::int32_t> highest;
    bool operator==(const TravelLimits&) const = default;
};

using OperationId = Strong<struct OperationIdTag, std::uint32_t>;

/// One command to one module.
struct Order {
    ModuleIndex module;
    ModuleCommand command;
};

/// A sine of the command position about one position, which may itself move, by Stop Here, to see how a servo
/// follows it (DS-V 5.2).
struct Sine {
    double amplitude = 0.0;  ///< counts
    double frequency = 0.0;  ///< Hz
    Duration lasts{};
    double velocity = 0.0;  ///< counts/s, of the position about which it swings
};

/// A command position that was sent, or a position that was reported.
struct SinePoint {
    TimePoint time;  ///< when the module latched it, +- half a tick
    std::int32_t counts = 0;
};
/// The results of a sine, in order of time.
struct SineRecord {
    std::vector<SinePoint> commands;
    std::vector<SinePoint> answers;  ///< positions in the replies to the commands, latched with these
    std::vector<SinePoint> polls;    ///< positions between the commands
};

/// Where a servo holds still while gains are tried on it, and what they are restored to (trialtask.h).
struct GainTrial {
    servo::SetGain back;     ///< the previous gains
    std::int32_t stood = 0;  ///< counts
    double reach = 0.0;      ///< permitted distance from there, in counts
    Duration lasts{};
};

/// The outcome of gains that were tried: in all cases except Kept, the previous ones were restored.
enum class TrialEnd : std::uint8_t { Kept, TimeOver, Swings, Saturates, TooFar, WentOff };

/// The request of one click: orders carried out in sequence, each after the previous one was answered without
/// the communication-error bit. The first failure ends it, so that "load, check, start" never starts on a
/// doubt; what it has loaded by then cannot be started any more.
struct Operation {
    OperationId id;
    std::vector<Order> orders;
    /// The only order is a Stop Here, and the first centre of this sine: sent repeatedly, up to 200 times a
    /// second, with polls in between. Any other request ends it, as Cancelled; a chip that switches off or
    /// stops by itself, as Forbidden.
    std::optional<Sine> sine{};
    /// The orders are Add Path Points without points, one to each of its axes: the engine sends the points,
    /// starts the path and keeps the buffers filled alongside its other work (pathtask.h). A stop of any of
    /// its axes ends it for all, as Cancelled. Only one path at a time.
    std::shared_ptr<const PathPlan> path{};
    /// The only order is a Set Gain, to be tried.
    std::optional<GainTrial> trial{};
};

/// The group whose commands a module obeys in addition to its own address (DS-V 4.1). The leader answers for
/// all members.
struct GroupPlace {
    std::uint8_t group = 0xFF;  ///< 0x80..0xFF; FF is the default after a reset, and never has a leader here
    bool leader = false;
    bool operator==(const GroupPlace&) const = default;
};

/// Puts a module into a group; its address is kept. Another leader of that group is first made a plain
/// member.
struct GroupChange {
    ModuleIndex module;
    GroupPlace place;
    bool operator==(const GroupChange&) const = default;
};

/// A command to all members of a group, carried out in the same tick.
struct GroupCommand {
    enum class Action : std::uint8_t {
        /// Withheld unless each member has confirmed its load, and while a stop is owed to one for a fault;
        /// PIC-I/O: Synch Output.
        StartMotion,
        SaveAsHome,       ///< PIC-I/O: Synch Input
        ResetPosition,    ///< withheld while any member moves
        ClearStickyBits,  ///< PIC-SERVO only
        /// A stop overtakes everything that is waiting, is never withheld from a known member, and leaves a
        /// member that is off as it is. Done: each member is owed its stop, and OwedStopConfirmed follows for
        /// each.
        StopSmoothly,
        StopAbruptly,
        MotorOff,
    };
    std::uint8_t group = 0xFF;
    Action action = Action::StartMotion;
    bool operator==(const GroupCommand&) const = default;
};

[[nodiscard]] constexpr bool isStop(GroupCommand::Action action) {
    using enum GroupCommand::Action;
    return action == StopSmoothly || action == StopAbruptly || action == MotorOff;
}

struct GroupOperation {
    OperationId id;
    std::variant<GroupChange, GroupCommand> what;
};

enum class Outcome : std::uint8_t {
    Done,
    Refused,    ///< the module answered with the communication-error bit, every time
    NoAnswer,   ///< the command may or may not have been carried out
    Forbidden,  ///< by the command gate: the chip does not allow it in its present state; or the connection
                ///< is read-only. Nothing was sent
    Cancelled,  ///< overtaken by a stop, or the connection ended; any motion has been stopped
    QueueFull,  ///< too many requests are waiting already. Nothing was sent
};

/// The place and identity of a module.
struct ModuleInfo {
    ModuleIndex index;
    BusAddress address;
    ModuleIdentity identity;
    /// Empty: another host left it there, or a change was not answered.
    std::optional<GroupPlace> group{};
    bool operator==(const ModuleInfo&) const = default;
};

/// Speed of a PIC-STEP in velocity profile mode (DS-S 4.2).
struct StepperPace {
    std::uint8_t speed = 1;             ///< 1..250
    std::uint8_t accelerationTime = 1;  ///< 1..255
    bool operator==(const StepperPace&) const = default;
};

/// Held motion (interface.md, "Moving"): a velocity that must be requested repeatedly. Once ended for any
/// reason, it is over until the button is released: only a press with a higher number moves the motor again.
struct HoldToMove {
    ModuleIndex module;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool reverse = false;
    std::optional<StepperPace> pace{};  ///< PIC-STEP, instead of velocity and acceleration
    std::uint32_t press = 0;            ///< number of the button press; increases with each press
    /// A travel limit that it moves towards: the motion is a move to it, from standstill, which the chip ends
    /// by itself. Empty: it continues for as long as it is held.
    std::optional<std::int32_t> goal{};
    bool operator==(const HoldToMove&) const = default;
};

// ---- output of the engine ----

/// A reply no later than this after the calculated time is prompt, because of thread scheduling.
inline constexpr Duration kPromptWithin = kServoTick / 2;

/// One accepted status reply.
struct Sample {
    ModuleIndex module;
    /// When the module latched the status: end of its command on the line plus half a tick, +- half a tick.
    TimePoint time;
    StatusReport report;
    /// Delay of the reply beyond what line, tick, the adapter's known latency and kPromptWithin explain. It
    /// cannot be known whether the command or the reply was delayed: the status was latched up to this much
    /// later than half a tick and kPromptWithin after `time`. Negative: the reply arrived, and was latched,
    /// earlier by this much.
    Duration late{};
    /// The status byte as received; `report` withholds what permits until another reply confirms it.
    std::optional<std::uint8_t> heard{};
    /// The position does not follow from the previous one, and was confirmed: another host has set the
    /// counter.
    bool jumped = false;
    /// The answer to an earlier command was lost, and it is being verified whether that was carried out, or
    /// it is about to be repeated.
    bool unsettled = false;
};

/// A command was answered as carried out; `time` and `late` as in Sample. Polls are not reported.
struct CommandExecuted {
    ModuleIndex module;
    TimePoint time;
    ModuleCommand command;
    Duration late{};
    /// It had been sent before without an answer: it may have been carried out this much earlier.
    Duration early{};
    bool ofTrial = false;  ///< gains being tried, or the ones from before being restored by the trial
};

enum class ConnectStage : std::uint8_t {
    Looking,
    Restarting,
    Addressing,
    Identifying,
    ChangingRate,
    Preparing
};

struct ConnectProgress {
    ConnectStage stage;
    std::uint8_t modules = 0;  ///< found so far
};

/// Discovery succeeded; polling has begun.
struct ChainFound {
    std::vector<ModuleInfo> modules;
    std::uint32_t baud = 0;
    /// The chain already had addresses and was left as it was: positions, gains and motions are unchanged,
    /// and what cannot be read back is unknown. Otherwise it has just been assigned addresses.
    bool attached = false;
    /// With `attached`: a module without an address answers as well, so one has restarted or is new.
    bool unaddressed = false;
    /// Those of `modules` that belong to the chain known before but do not answer at their address.
    /// ModuleUnresponsive follows for each, or ModuleRestarted.
    std::vector<ModuleIndex> absent{};
    /// Those of `modules` that are sent a stop again (EngineConfig::unconfirmed).
    std::vector<ModuleIndex> commandedToStop{};
    /// As EngineConfig::readOnly.
    bool readOnly = false;
    /// The longest pause within a reply seen on the line, which is allowed for; 0: none.
    Duration replyGap{};
};

enum class ConnectFailure : std::uint8_t {
    NobodyAnswers,
    RateChange,   ///< some modules did not answer at the new rate
    Garbled,      ///< answers were received but could not be read
    Collision,    ///< two modules answer at one address
    HeldLow,      ///< only zero bytes: the line is held low
    Echo,         ///< the adapter returns what is sent, and no answer follows
    Disturbed,    ///< modules that had answered fell silent while addresses were being assigned
    Unaddressed,  ///< modules without addresses, on a read-only connection, which assigns none
};

struct ConnectFailed {
    ConnectFailure reason;
    std::vector<ModuleIndex> modules;  ///< the modules concerned, if known
    std::uint32_t baud = 0;            ///< the rate that was tried
    bool fixedRate = false;            ///< as EngineConfig::fixedRate
};

struct OperationFinished {
    OperationId id;
    Outcome outcome;
    ModuleIndex module;                   ///< of the order that ended it
    std::uint8_t commandByte = 0;         ///< of that order
    std::vector<ModuleIndex> unloaded{};  ///< their loads are forgotten: a start would run none of them
    SineRecord sine{};                    ///< for Operation::sine
    std::optional<TrialEnd> trial{};      ///< for Operation::trial, with Done
    bool sent = false;                    ///< with Cancelled: that order may have been carried out
};

enum class MemberOutcome : std::uint8_t {
    Done,
    NotDone,   ///< certainly not: it is at its old position, or refused
    Unknown,   ///< it answers, but the result is not visible
    NoAnswer,  ///< it may have been carried out
    Withheld,  ///< nothing was sent because of this module
};

struct GroupMember {
    ModuleIndex module;
    MemberOutcome outcome;
    bool operator==(const GroupMember&) const = default;
};

/// The end of a GroupOperation, exactly one for each. Done: by all members. NoAnswer: see `members`.
struct GroupFinished {
    OperationId id;
    Outcome outcome;
    std::variant<GroupChange, GroupCommand> what;
    std::vector<GroupMember> members;
    bool stopped = false;  ///< only some members started, so all of them were sent a stop
};

/// The group of a module has changed, or has become unknown.
struct GroupChanged {
    ModuleIndex module;
    std::optional<GroupPlace> place;
};

/// The whole chain is at another rate, at which each module has answered. Nothing else has changed.
struct RateChanged {
    std::uint32_t baud = 0;
};

/// The chain is at its previous rate, except for modules that are lost.
struct RateChangeFailed {
    enum class Reason : std::uint8_t {
        NoSuchRate,
        PortCannot,     ///< the host's port cannot set it to within 2 %
        NotNow,         ///< something moves, or is about to; not connected; read-only
        Missing,        ///< `modules` do not answer, and would be left behind
        GroupsUnknown,  ///< `modules` may be in unknown groups, and would not receive it
        Leader,         ///< `modules` are leaders: their answers would collide, at the new rate
        NotHeard,       ///< `modules` did not answer at the new rate
        Interrupted,    ///< by a stop
    };
    Reason reason = Reason::NotNow;
    std::uint32_t wanted = 0;
    std::uint32_t baud = 0;  ///< unchanged
    std::vector<ModuleIndex> modules;
    std::vector<ModuleIndex> lost;  ///< do not answer at the old rate either
};

/// A stop of all motors has ended. Each module of the known chain is in one list.
struct StopFinished {
    std::vector<ModuleIndex> stopped;      ///< seen at rest, twice
    std::vector<ModuleIndex> unreached;    ///< did not answer: use the hardware stop
    std::vector<ModuleIndex> unconfirmed;  ///< sent a stop, but not seen at rest: use the hardware stop
    std::vector<ModuleIndex> noStopKnown;  ///< !hasStop(): not sent a stop; use the hardware stop
    Duration took{};
    std::vector<ModuleIndex> wereOff{};  ///< off when it began: they needed no stop
    bool unasked = false;                ///< not requested by the user, but for example before closing a port

    [[nodiscard]] bool reachedNobody() const {
        return stopped.empty() && unreached.empty() && unconfirmed.empty() && noStopKnown.empty();
    }
};

/// Why the engine sent a stop to a module outside a stop of all modules.
enum class StopCause : std::uint8_t {
    HoldReleased,
    HoldExpired,
    MotionSuspect,
    GroupHalfStarted,
    LinkGivenUp,  ///< the link, or that to this module: its motion is no longer monitored
    StopAll,      ///< a stop of all modules did not see it at rest
    ForeignTraffic,
    GroupStop,  ///< the user stopped its group, or the module itself where its operation had to wait
                ///< or was not answered
    PathEnded,  ///< a path ended before its last point
    TravelLimit,
    ConnectionEnded,  ///< its stop had not been confirmed when the last connection ended
};

/// True if the user wanted the motion to end, or it was about to leave its limits: the user may request
/// another one before it has ended.
[[nodiscard]] constexpr bool ofOperator(StopCause cause) {
    return cause == StopCause::HoldReleased || cause == StopCause::HoldExpired ||
           cause == StopCause::GroupStop || cause == StopCause::TravelLimit;
}

/// A stop that was owed to a module is confirmed: the module was seen at rest, twice. Until then, nothing is
/// known except that the stop was sent.
struct OwedStopConfirmed {
    ModuleIndex module;
    StopCause cause = StopCause::HoldReleased;
};

/// A stop that had not been confirmed when its connection ended.
struct UnconfirmedStop {
    ModuleInfo module;
    StopManner manner = StopManner::Abruptly;
};

/// A module has stopped answering, or answers again.
struct ModuleUnresponsive {
    ModuleIndex module;
    bool silent;
};

/// A reply had the communication-error bit: the command was not carried out, and is retried or given up.
struct CommandRefused {
    ModuleIndex module;
    std::uint8_t attempt;  ///< 1, 2, 3
};

/// The adapter returns what is sent to it. The echo is ignored, and the chain works. Emitted once.
struct EchoNoticed {};

/// Every module is silent.
struct LinkLost {};

/// How far the link can be trusted (link.md 2.5).
enum class LinkHealth : std::uint8_t { Good, Marginal, Lost };

/// For the whole bus, or for one module. When Lost, the motors concerned were stopped (not by a read-only
/// connection), and are only queried for their presence until they are well again (wellagain.h).
struct HealthChanged {
    LinkHealth health;
    unsigned wrong = 0;  ///< of the last `of` exchanges
    unsigned of = 0;
    std::optional<ModuleIndex> module;  ///< if set, only the link to this module
};

/// A module that stopped answering has restarted: it answers without an address (faults.md F-15, F-16). Its
/// position, gains and limits are lost and its motor is off; it is left alone until it is given its address
/// back, or the network is restarted.
struct ModuleRestarted {
    ModuleIndex module;
    /// The bus runs at another rate than the restarted module, which receives the traffic as noise: motors
    /// were stopped (not by a read-only connection) and polling ended.
    bool quiet = false;
};

/// A module that restarted has its address again: it is off, at position 0 and without gains; the others are
/// unchanged. ModuleUnresponsive follows.
struct Readdressed {
    ModuleInfo module;
};

/// A module has another address; nothing else about it has changed.
struct AddressChanged {
    ModuleIndex module;
    BusAddress address;
};

/// The module was not given its address.
struct ReaddressFailed {
    enum class Reason : std::uint8_t {
        NotNow,  ///< something moves or is in progress; the module has not restarted; read-only
        NoAnswer,
        Taken,         ///< another module has that address, or it is outside 1..127
        GroupUnknown,  ///< the group would be changed with the address
        Unaddressed,   ///< another module without an address would take the address
    };
    ModuleIndex module;
    Reason reason = Reason::NotNow;
};

/// A motion is not as commanded; its module was sent a stop.
struct MotionSuspect {
    enum class Reason : std::uint8_t {
        WrongWay,  ///< away from its goal, or against its direction
        Overshot,  ///< past its goal by more than a plausible overshoot
        Frozen,    ///< reports motion, but repeatedly the same position
    };
    ModuleIndex module;
    Reason reason = Reason::WrongWay;
    std::int32_t position = 0;
};

/// A motion without an end was about to leave its travel limits (travelwatch.h); its module was sent a stop.
struct StoppedBeforeLimit {
    ModuleIndex module;
};

/// Modules answer another host, which is on the line (strayframes.h). Requests from here are cancelled, and a
/// hold has ended. Emitted once, until nothing has been heard of that host for ten seconds.
struct ForeignTraffic {
    std::vector<ModuleIndex> commandedToStop;  ///< motors that were set in motion from here
};

/// A module moves, but not because of this connection (ownmotion.h); nothing is done about it. Emitted once
/// for each motion.
struct ForeignMotion {
    ModuleIndex module;
    std::int32_t position = 0;
};

/// The program that the line is lent to (lending.h) has made the chain consist of these modules, or has
/// changed its rate. One whose type was not reported has kUnheardModule.
struct ModulesSeen {
    std::vector<ModuleInfo> modules;
    std::uint32_t baud = 0;
};

/// That program has sent a command that was not answered: it is unknown whether it was carried out.
struct CommandUnanswered {
    ModuleIndex module;
    ModuleCommand command;
};

/// Held motion ended without being released by the user.
struct HoldExpired {
    enum class Reason : std::uint8_t {
        Expired,      ///< the evidence stopped coming
        NoAnswer,     ///< no valid answer, or three times that the command was garbled
        NotPossible,  ///< the module's state does not permit it, or it is at its goal
        GoalChanged,  ///< another travel limit, or none any more
    };
    ModuleIndex module;
    Reason reason = Reason::Expired;
    bool started = true;      ///< or perhaps started, or loaded: its module is sent a stop
    std::uint32_t press = 0;  ///< see HoldToMove: it is over
};

/// Events that only show in the state of the modules and the link.
using StateEvent = std::variant<Sample, CommandExecuted, ConnectProgress, GroupChanged, PathProgress,
                                ModulesSeen, CommandUnanswered>;
/// Events that a user or a task under way may also have to hear about.
using NewsEvent = std::variant<ChainFound, ConnectFailed, OperationFinished, StopFinished, ModuleUnresponsive,
                               CommandRefused, LinkLost, HoldExpired, HealthChanged, ModuleRestarted,
                               MotionSuspect, GroupFinished, RateChanged, RateChangeFailed, OwedStopConfirmed,
                               Readdressed, ReaddressFailed, EchoNoticed, ForeignTraffic, ForeignMotion,
                               AddressChanged, StoppedBeforeLimit>;
using Event = Join<StateEvent, NewsEvent>;

/// The engine's requests to the transport, to be carried out in order.
struct SetHostBaud {
    std::uint32_t baud;
};
struct DiscardInput {};
struct Send {
    std::vector<std::uint8_t> bytes;
};
using Output = std::variant<SetHostBaud, DiscardInput, Send>;

/// Counted since the chain was found: the silence after its last module is not an error. An exchange is a
/// command that was sent and expects an answer.
struct LinkStatistics {
    std::uint64_t exchanges = 0;
    std::uint64_t answered = 0;  ///< accepted replies
    std::uint64_t retries = 0;
    std::uint64_t timeouts = 0;
    std::uint64_t refused = 0;  ///< communication-error bit
    std::uint64_t badChecksum = 0;
    std::uint64_t surplusBytes = 0;  ///< unexpected bytes
    std::uint64_t staleBytes = 0;    ///< those of them that arrived outside an exchange
    std::uint64_t rejected = 0;      ///< implausible replies with a right sum
    RejectionCounts rejections{};    ///< the number of implausible replies, by rule
    std::uint64_t resyncs = 0;
    Duration roundTripSum{};
    Duration roundTripMax{};
    Duration wireTime{};  ///< duration of the answered exchanges on an undisturbed line, including the wait
                          ///< for the tick

    [[nodiscard]] std::uint64_t errors() const { return timeouts + refused + badChecksum + rejected; }
};

}  // namespace nmc::bus
