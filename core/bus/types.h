// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "bus/path.h"
#include "bus/rejection.h"
#include "module/modulecommand.h"

/// What goes into the bus engine and what comes out of it. All values; any thread may hold copies.
namespace nmc::bus {

/// How far an axis may go, as its chip counts now; nothing: no limit on that side.
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

/// A command position that swings about one place by Stop Here, to see how a servo follows it (DS-V 5.2).
struct Sine {
    double amplitude = 0.0;  ///< counts
    double frequency = 0.0;  ///< Hz
    Duration lasts{};
};

/// A command position that a module was told, or a position that it told.
struct SinePoint {
    TimePoint time;  ///< when the module latched it, +-half a tick
    std::int32_t counts = 0;
};
/// What came of a sine, in the order of time.
struct SineRecord {
    std::vector<SinePoint> commands;
    std::vector<SinePoint> answers;  ///< positions in the answers to the commands, latched when these were
    std::vector<SinePoint> polls;    ///< positions from between the commands
};

/// Where a servo holds still while gains are tried on it, and what it goes back to (trialtask.h).
struct GainTrial {
    servo::SetGain back;     ///< those from before
    std::int32_t stood = 0;  ///< counts
    double reach = 0.0;      ///< counts that it may go away from there
    Duration lasts{};
};

/// What became of gains that were tried: all but Kept were taken back.
enum class TrialEnd : std::uint8_t { Kept, TimeOver, Swings, Saturates, TooFar, WentOff };

/// What one click asks for: orders that run in order, each after the one before was answered without the
/// communication-error bit. The first failure ends it, so "load, check, start" never starts on a doubt.
struct Operation {
    OperationId id;
    std::vector<Order> orders;
    /// The only order is a Stop Here, and the centre of this: sent again and again, up to 200 times a second,
    /// with polls between. What else is asked for ends it, as Cancelled; a chip that lets go, as Forbidden.
    std::optional<Sine> sine{};
    /// The orders are Add Path Points without points, one to each of its axes: the engine lays the points,
    /// starts the path and keeps the buffers filled beside whatever else it does (pathtask.h). A stop of any
    /// of its axes ends it for all, as Cancelled. One path at a time.
    std::shared_ptr<const PathPlan> path{};
    /// The only order is a Set Gain, to be tried.
    std::optional<GainTrial> trial{};
};

/// The group that a module listens to besides its own address (DS-V 4.1). The leader answers for all.
struct GroupPlace {
    std::uint8_t group = 0xFF;  ///< 0x80..0xFF; FF is everybody's after a reset, and never has a leader here
    bool leader = false;
    bool operator==(const GroupPlace&) const = default;
};

/// Puts a module into a group; its address stays. Another leader of that group becomes an ordinary member
/// first.
struct GroupChange {
    ModuleIndex module;
    GroupPlace place;
    bool operator==(const GroupChange&) const = default;
};

/// One command to all members of a group, carried out in the same tick.
struct GroupCommand {
    enum class Action : std::uint8_t {
        StartMotion,      ///< withheld unless each member has confirmed its load; PIC-I/O: Synch Output
        SaveAsHome,       ///< PIC-I/O: Synch Input
        ResetPosition,    ///< withheld while any member moves
        ClearStickyBits,  ///< PIC-SERVO only
        StopSmoothly,     ///< stops: past all that waits, and never withheld from a member that is known;
        StopAbruptly,     ///< who is off stays off. Done: each member is owed its stop, and
        MotorOff,         ///< OwedStopConfirmed follows for each
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
    Forbidden,  ///< the command gate: the chip does not allow it in its present state; or the connection is
                ///< read-only. Nothing was sent
    Cancelled,  ///< a stop went before it, or the connection ended; whatever moved was stopped
    QueueFull,  ///< too many requests wait already. Nothing was sent
};

/// Where a module is and what it says it is.
struct ModuleInfo {
    ModuleIndex index;
    BusAddress address;
    ModuleIdentity identity;
    /// Nothing: it was left there by another host, or a change was not answered.
    std::optional<GroupPlace> group{};
    bool operator==(const ModuleInfo&) const = default;
};

/// How fast a PIC-STEP goes in velocity profile mode (DS-S 4.2).
struct StepperPace {
    std::uint8_t speed = 1;             ///< 1..250
    std::uint8_t accelerationTime = 1;  ///< 1..255
    bool operator==(const StepperPace&) const = default;
};

/// Motion while it is held (interface.md, "Moving"): a velocity that must be asked for again and again. One
/// that has ended, whoever ended it, is over until the button was up: nothing but a higher press moves again.
struct HoldToMove {
    ModuleIndex module;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool reverse = false;
    std::optional<StepperPace> pace{};  ///< of a PIC-STEP, instead of velocity and acceleration
    std::uint32_t press = 0;            ///< which press of a button it is; each is a higher number
    /// A limit that it goes towards: it is a move there, from standstill, which the chip ends by itself.
    /// Empty: it goes on for as long as it is held.
    std::optional<std::int32_t> goal{};
    bool operator==(const HoldToMove&) const = default;
};

// ---- out of the engine ----

/// A reply that is no later than this after the reckoned time is prompt: threads are scheduled so.
inline constexpr Duration kPromptWithin = kServoTick / 2;

/// One accepted status reply.
struct Sample {
    ModuleIndex module;
    /// When the module latched the status: end of its command on the wire plus half a tick, +-half a tick.
    TimePoint time;
    StatusReport report;
    /// Its reply came so much later than wire, tick, the adapter's known latency and kPromptWithin explain.
    /// Whether the command or the reply was held up cannot be known: it was latched up to so much later than
    /// half a tick and kPromptWithin behind `time`. Negative: it came before that, and so was it latched.
    Duration late{};
    /// The status byte as it came; `report` withholds what permits until another reply confirms it.
    std::optional<std::uint8_t> heard{};
    /// Its position does not follow from the one before, and was confirmed: somebody else has set the
    /// counter.
    bool jumped = false;
    /// The answer to a command that came before was lost, and whether that was carried out is being found
    /// out, or it is about to be repeated.
    bool unsettled = false;
};

/// A command was answered as carried out; `time` and `late` as in Sample. Polls are not reported.
struct CommandExecuted {
    ModuleIndex module;
    TimePoint time;
    ModuleCommand command;
    Duration late{};
    /// It had been sent before without an answer: so much earlier it may have been carried out already.
    Duration early{};
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

/// Discovery ended well; polling has begun.
struct ChainFound {
    std::vector<ModuleInfo> modules;
    std::uint32_t baud = 0;
    /// The chain had its addresses already and was left as it was: positions, gains and motions are what they
    /// were, and what cannot be read back is unknown. Otherwise it has just been given addresses.
    bool attached = false;
    /// With `attached`: a module without an address answers too, so one has restarted or is new.
    bool unaddressed = false;
    /// Of `modules`: those of the chain known before that do not answer at their address. ModuleUnresponsive
    /// follows for each, or ModuleRestarted.
    std::vector<ModuleIndex> absent{};
    /// As EngineConfig::readOnly.
    bool readOnly = false;
    /// The longest pause within a reply that the line was seen to make, and is reckoned with; 0: none.
    Duration replyGap{};
};

enum class ConnectFailure : std::uint8_t {
    NobodyAnswers,
    RateChange,   ///< some module did not answer at the new rate
    Garbled,      ///< answers came but could not be read
    Collision,    ///< two modules answer at one address
    HeldLow,      ///< nothing but zero bytes: the line is held low
    Echo,         ///< the adapter returns what is sent, and nobody answers behind that
    Disturbed,    ///< modules that had answered fell silent while addresses were given
    Unaddressed,  ///< modules without addresses, and a read-only connection gives none
};

struct ConnectFailed {
    ConnectFailure reason;
    std::vector<ModuleIndex> modules;  ///< those it failed for, where that is known
    std::uint32_t baud = 0;            ///< the rate that was tried
};

struct OperationFinished {
    OperationId id;
    Outcome outcome;
    ModuleIndex module;               ///< of the order that ended it
    std::uint8_t commandByte = 0;     ///< of that order
    SineRecord sine{};                ///< of Operation::sine
    std::optional<TrialEnd> trial{};  ///< of Operation::trial, with Done
};

enum class MemberOutcome : std::uint8_t {
    Done,
    NotDone,   ///< certainly not: it stands where it stood, or refused
    Unknown,   ///< it answers, and that does not tell
    NoAnswer,  ///< it may have been carried out
    Withheld,  ///< because of this module nothing was sent
};

struct GroupMember {
    ModuleIndex module;
    MemberOutcome outcome;
    bool operator==(const GroupMember&) const = default;
};

/// The end of a GroupOperation, exactly one for each. Done: for all members. NoAnswer: see `members`.
struct GroupFinished {
    OperationId id;
    Outcome outcome;
    std::variant<GroupChange, GroupCommand> what;
    std::vector<GroupMember> members;
    bool stopped = false;  ///< only some started, so all of them have been told to stop
};

/// Where a module belongs has changed, or is not known any more.
struct GroupChanged {
    ModuleIndex module;
    std::optional<GroupPlace> place;
};

/// The whole chain is at another rate, and each module has answered there. Nothing else has changed.
struct RateChanged {
    std::uint32_t baud = 0;
};

/// The chain is at the rate it was at, but for modules that are lost.
struct RateChangeFailed {
    enum class Reason : std::uint8_t {
        NoSuchRate,
        PortCannot,     ///< the host's port does not make it to within 2 %
        NotNow,         ///< something moves, or is about to; not connected; read-only
        Missing,        ///< `modules` do not answer, and would be left behind
        GroupsUnknown,  ///< `modules` may be in groups that are not known here, and would not hear it
        Leader,         ///< `modules` lead a group: their answers would come at once and at the new rate
        NotHeard,       ///< `modules` did not answer at the new rate
        Interrupted,    ///< by a stop
    };
    Reason reason = Reason::NotNow;
    std::uint32_t wanted = 0;
    std::uint32_t baud = 0;  ///< as before
    std::vector<ModuleIndex> modules;
    std::vector<ModuleIndex> lost;  ///< do not answer at the old rate either
};

/// A stop of all motors has run its course. Each module of the chain that was known is in one list.
struct StopFinished {
    std::vector<ModuleIndex> stopped;      ///< seen at rest, twice
    std::vector<ModuleIndex> unreached;    ///< did not answer: use the hardware stop
    std::vector<ModuleIndex> unconfirmed;  ///< was told, but was not seen at rest: use the hardware stop
    std::vector<ModuleIndex> noStopKnown;  ///< !hasStop(): was not told, use the hardware stop
    Duration took{};
    std::vector<ModuleIndex> wereOff{};  ///< when it began: they had to be told nothing
    bool unasked = false;                ///< not the operator's, but before a port is closed, for example

    [[nodiscard]] bool reachedNobody() const {
        return stopped.empty() && unreached.empty() && unconfirmed.empty() && noStopKnown.empty();
    }
};

/// Why the engine told one module to stop without a stop of all.
enum class StopCause : std::uint8_t {
    HoldReleased,
    HoldExpired,
    MotionSuspect,
    GroupHalfStarted,
    LinkGivenUp,  ///< the link, or that to this module: nobody sees what it does any more
    StopAll,      ///< a stop of all did not see it at rest
    ForeignTraffic,
    GroupStop,  ///< the operator stopped its group, or itself while its chain was looked for
    PathEnded,  ///< a path ended before its last point
    TravelLimit,
};

/// The operator wanted the motion to end, or it was on its way out of its limits: he may want another one
/// before it has.
[[nodiscard]] constexpr bool ofOperator(StopCause cause) {
    return cause == StopCause::HoldReleased || cause == StopCause::HoldExpired ||
           cause == StopCause::GroupStop || cause == StopCause::TravelLimit;
}

/// A stop that the engine owed to one module is confirmed: the module was seen at rest, twice. Until then it
/// has been told to stop, and no more than that is known.
struct OwedStopConfirmed {
    ModuleIndex module;
    StopCause cause = StopCause::HoldReleased;
};

/// A module stopped answering or answers again.
struct ModuleUnresponsive {
    ModuleIndex module;
    bool silent;
};

/// A reply had the communication-error bit; the command was not carried out and is sent again, or given up.
struct CommandRefused {
    ModuleIndex module;
    std::uint8_t attempt;  ///< 1, 2, 3
};

/// The adapter returns what is sent to it. That is ignored, and the chain works. Once.
struct EchoNoticed {};

/// Every module is silent.
struct LinkLost {};

/// How far the link is to be trusted (link.md 2.5).
enum class LinkHealth : std::uint8_t { Good, Doubtful, Lost };

/// Of the whole bus, or of one module. Lost is final: the motors concerned were stopped (not by a read-only
/// connection) and are not asked any more; another connect() is needed.
struct HealthChanged {
    LinkHealth health;
    unsigned wrong = 0;  ///< of the last `of` exchanges
    unsigned of = 0;
    std::optional<ModuleIndex> module;  ///< it is the link to this one only
};

/// A module that stopped answering has restarted: it answers without an address (faults.md F-15, F-16). Its
/// position, gains and limits are lost and its motor is off; it is left alone until the network is restarted.
struct ModuleRestarted {
    ModuleIndex module;
    /// The bus runs at another rate than the restarted module, to which its traffic is noise: motors were
    /// stopped (not by a read-only connection) and polling ended.
    bool quiet = false;
};

/// A module that restarted has its address again: it is off, at position 0 and without gains; the others are
/// as they were. ModuleUnresponsive follows.
struct Readdressed {
    ModuleInfo module;
};

/// A module has another address; nothing else about it has changed.
struct AddressChanged {
    ModuleIndex module;
    BusAddress address;
};

/// The module has not been given its address.
struct ReaddressFailed {
    enum class Reason : std::uint8_t {
        NotNow,  ///< something moves, or is under way; the module has not restarted; read-only
        NoAnswer,
        Taken,         ///< another module has that address, or no module may have it: 1..127
        GroupUnknown,  ///< and it would be changed with the address
    };
    ModuleIndex module;
    Reason reason = Reason::NotNow;
};

/// Something about a motion is not as commanded; its module has been told to stop.
struct MotionSuspect {
    enum class Reason : std::uint8_t {
        WrongWay,  ///< away from its goal, or against its direction
        Overshot,  ///< past its goal by more than an overshoot can be
        Frozen,    ///< says that it moves, and reports the same position again and again
    };
    ModuleIndex module;
    Reason reason = Reason::WrongWay;
    std::int32_t position = 0;
};

/// A motion without an end was about to leave its limits of travel (travelwatch.h); its module has been told
/// to stop.
struct StoppedBeforeLimit {
    ModuleIndex module;
};

/// Modules answer somebody else: another host is on the line (strayframes.h). What was asked for here is
/// cancelled, and a hold has ended. Once, until nothing has been heard of him for ten seconds.
struct ForeignTraffic {
    std::vector<ModuleIndex> toldToStop;  ///< motors that were set in motion from here
};

/// A module moves, and not because of this connection (ownmotion.h); nothing is done about it. Once for each
/// motion.
struct ForeignMotion {
    ModuleIndex module;
    std::int32_t position = 0;
};

/// Held motion ended without the operator's release: the evidence stopped coming.
struct HoldExpired {
    ModuleIndex module;
};

using Event =
    std::variant<Sample, CommandExecuted, ConnectProgress, ChainFound, ConnectFailed, OperationFinished,
                 StopFinished, ModuleUnresponsive, CommandRefused, LinkLost, HoldExpired, HealthChanged,
                 ModuleRestarted, MotionSuspect, GroupFinished, GroupChanged, RateChanged, RateChangeFailed,
                 OwedStopConfirmed, Readdressed, ReaddressFailed, EchoNoticed, ForeignTraffic, ForeignMotion,
                 AddressChanged, PathProgress, StoppedBeforeLimit>;

/// What the engine wants of the transport, to be done in order.
struct SetHostBaud {
    std::uint32_t baud;
};
struct DiscardInput {};
struct Send {
    std::vector<std::uint8_t> bytes;
};
using Output = std::variant<SetHostBaud, DiscardInput, Send>;

/// Counted since the chain was found: the silence behind its last module is no error. An exchange is a
/// command that was sent and asked for an answer.
struct LinkStatistics {
    std::uint64_t exchanges = 0;
    std::uint64_t answered = 0;  ///< accepted replies
    std::uint64_t retries = 0;
    std::uint64_t timeouts = 0;
    std::uint64_t refused = 0;  ///< communication-error bit
    std::uint64_t badChecksum = 0;
    std::uint64_t surplusBytes = 0;  ///< bytes nobody asked for
    std::uint64_t staleBytes = 0;    ///< of them: discarded while waiting for a quarantine to pass
    std::uint64_t rejected = 0;      ///< replies with a right sum that were not believed
    RejectionCounts rejections{};    ///< the same by rule
    std::uint64_t resyncs = 0;
    Duration roundTripSum{};
    Duration roundTripMax{};
    Duration wireTime{};  ///< what the answered exchanges take on a perfect line, tick wait included

    [[nodiscard]] std::uint64_t errors() const { return timeouts + refused + badChecksum + rejected; }
};

}  // namespace nmc::bus
