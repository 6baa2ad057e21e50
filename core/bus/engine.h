// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "base/time.h"
#include "bus/chain.h"
#include "bus/engineconfig.h"
#include "bus/exchangerecorder.h"
#include "bus/holdtask.h"
#include "bus/lending.h"
#include "bus/line.h"
#include "bus/operationtask.h"
#include "bus/pathtask.h"
#include "bus/polltask.h"
#include "bus/ratetask.h"
#include "bus/readdresstask.h"
#include "bus/recovery.h"
#include "bus/restartsearch.h"
#include "bus/searchtask.h"
#include "bus/stoplane.h"
#include "bus/trialtask.h"
#include "bus/types.h"
#include "bus/wellagain.h"

namespace nmc::bus {

/// The bus master: one exchange in flight; stops take precedence over commands, and commands over polls.
///
/// Sans-I/O: takes bytes and time points, and returns output, samples and events. It owns no thread, port or
/// clock. After every call, the caller carries out takeOutput() in order and sets a timer for nextDeadline().
/// Used by a single thread (the bus thread, or a test).
///
/// With EngineConfig::readOnly the engine never changes a module. It sends only No Operation, Read Status and
/// nulls, whatever happens; from stopAll() until each module has confirmed, it also sends what stops a
/// module. Submit, changeRate, readdress and hold end at once as refused (Forbidden, NotNow). It stops no
/// motor on its own initiative and suspects no motion, because other hosts are responsible for all of them.
class Engine {
public:
    explicit Engine(EngineConfig config);
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Finds the chain: one that has addresses, at any rate, is left as it is (ChainFound::attached; nulls
    /// and No Operation only, until it is found); a fresh one is assigned addresses and the configured rate,
    /// or with EngineConfig::readOnly results in ConnectFailure::Unaddressed. Polling follows. Ends in
    /// ChainFound or ConnectFailed.
    void connect(TimePoint now);
    /// Restarts the network (Hard Reset at every rate at which a chain may have been left) and assigns
    /// addresses. The modules lose positions and gains. A read-only connection only searches for the chain
    /// again, like connect(), with the same results: ChainFound::attached and ::readOnly show that nothing
    /// was reset.
    void restart(TimePoint now);

    /// Queues an operation. It ends in exactly one OperationFinished. A stop that would have to wait goes as
    /// that of a group does (below): the operation is Done at once, and the stop is owed.
    void submit(Operation operation, TimePoint now);

    /// Keeps the gains being tried on that module (Operation::trial), unless the trial has already ended.
    void keepTrial(ModuleIndex module, TimePoint now);

    /// Queues a group operation; it ends in exactly one GroupFinished. A command to a group is sent once, and
    /// its outcome is determined from the status of each member; this requires that all groups are known.
    /// A stop of a group overtakes everything that is waiting: operations for its members are cancelled, a
    /// hold of one of them ends, and they are owed the stop until each has confirmed (OwedStopConfirmed).
    void submit(const GroupOperation& operation, TimePoint now);

    /// Switches the chain to another rate that the chips support (findBrd); positions, gains and loads are
    /// kept. Refused while anything moves; if a module does not follow, all modules are switched back. Ends
    /// in RateChanged or RateChangeFailed.
    void changeRate(std::uint32_t baud, TimePoint now);

    /// Gives a module that restarted its address back (readdresstask.h). Ends in Readdressed or
    /// ReaddressFailed.
    void readdress(ModuleIndex module, TimePoint now);
    /// Gives a module that answers another address, 1..127; its group is kept. Ends in AddressChanged or
    /// ReaddressFailed.
    void moveTo(ModuleIndex module, BusAddress address, TimePoint now);
    /// Resets one module and gives it its address back; the others are unaffected. ModuleRestarted precedes
    /// the end. `configuration`: what an SC stores or erases during the reset.
    void resetModule(ModuleIndex module, TimePoint now,
                     const std::optional<servo::HardReset>& configuration = {});

    /// Starts or renews held motion: velocity mode, which can be changed during motion. The engine stops the
    /// motor smoothly (abruptly if the acceleration is 0) at release(), or config.holdTimeout after the last
    /// hold(). After a hold has ended in any way, or was not possible, only a press with a higher number
    /// moves the motor again.
    void hold(const HoldToMove& hold, TimePoint now);
    void release(TimePoint now);

    /// Stops every motor, overtaking all queues; queued operations are cancelled and a hold ends. A servo
    /// that is on is stopped abruptly and continues to hold; one that is off stays off (link.md 2.6). The
    /// stop is repeated until each module has confirmed twice or does not answer; it ends in exactly one
    /// StopFinished, even if called again.
    void stopAll(TimePoint now);
    /// Stops every motor without a user's request: no user is left to make one, or the computer is suspended.
    /// Returns false on a read-only connection, which stops nothing without a request. A requested stop in
    /// progress continues.
    bool stopUnasked(TimePoint now);
    /// True while a stop of all modules is in progress.
    [[nodiscard]] bool stopping() const { return m_stops.stopping() || m_lending.cutBy(); }

    // ---- the line lent to a program (docs/lending.md) ----

    /// From now on, nothing is sent except what the program sends, until a stop of all modules holds the
    /// program off, and every other request is refused. Returns false, and does nothing, while anything moves
    /// or is in progress, and on a read-only connection.
    [[nodiscard]] bool lend();
    /// The program has sent bytes, or set its rate.
    void onProgram(ByteSpan bytes, TimePoint now);
    void onProgramRate(std::uint32_t baud);
    /// The program has the line again after a stop. Ignored during the stop.
    void letThrough(TimePoint now);
    /// The line is no longer lent. The engine believes what it has seen; connect() searches for the modules
    /// again.
    void takeBack(TimePoint now);
    [[nodiscard]] bool lent() const { return m_lending.active(); }
    /// What the program sends is passed on; otherwise, while the line is lent, it is held off.
    [[nodiscard]] bool passes() const { return m_lending.passes(); }
    /// What the modules send now is for the program, and not the rest of a reply to the panel.
    [[nodiscard]] bool hearsForProgram() const;

    /// Call after an event such as a suspend of the computer: the link is checked before anything is
    /// believed.
    void distrust(TimePoint now);

    /// Sets the modules on display: they are polled as often as the line allows, the others about five times
    /// a second. If empty, all are polled equally.
    void watch(const std::vector<ModuleIndex>& modules);

    /// Sets, by module, which outputs of PIC-I/O modules a stop of all modules takes low; none for modules
    /// not listed. Also applies to every chain found later.
    void setStopOutputs(const std::vector<StopOutputs>& outputs);

    /// Sets the travel limits of each axis, by module: a motion without an end of its own is stopped before
    /// them (StoppedBeforeLimit). Must be set again after the counter of a module was set, or a chain was
    /// found.
    void setTravelLimits(const std::vector<TravelLimits>& limits);

    /// Polls one module, with its position in every reply, as fast as the line allows for at most 5 s; the
    /// others are polled once a second, silent ones not at all. Without a module, it ends. Any kind of stop
    /// ends it, and so does another connect(). Calling it again restarts the time.
    void focus(std::optional<ModuleIndex> module, TimePoint now);

    /// `bytes` arrived; `now` is when they were read.
    void onBytes(ByteSpan bytes, TimePoint now);
    /// nextDeadline() has passed.
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;

    [[nodiscard]] std::vector<Output> takeOutput() { return m_line.takeOutput(); }
    [[nodiscard]] std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    [[nodiscard]] const LinkStatistics& statistics() const { return m_line.statistics(); }
    /// Number of modules that a stop would reach now: those that answer.
    [[nodiscard]] std::size_t stopReach() const { return m_chain.schedule().answering(); }
    /// A stop is waiting for a search that has seen modules, which it may still reach.
    [[nodiscard]] bool stopMayStillReach() const { return m_stops.waits() && m_search.seen() > 0; }
    /// A motor moves, or may move.
    [[nodiscard]] bool anythingMoves() const { return m_chain.anythingMoves() || m_operations.swings(); }
    /// A motor moves, or may move, that stopUnasked() would stop.
    [[nodiscard]] bool answersForMotion() const { return !m_config.readOnly && anythingMoves(); }
    /// The whole stop as bytes that need no answer, nulls first, for a process that is about to die (link.md
    /// 2.6); empty if nothing is on, and on a read-only connection. Changes only with a command or a status.
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const { return m_chain.stopBurst(); }
    /// The rate at which the chain receives the burst; the port may be at another one, for example during a
    /// search.
    [[nodiscard]] std::uint32_t stopBurstBaud() const { return m_chain.rate(); }
    /// For the next connection to this port: the stops that are owed now, and those of EngineConfig that no
    /// chain was found for.
    [[nodiscard]] std::vector<UnconfirmedStop> unconfirmedStops() const;

    /// Records every exchange from now on, for the packet monitor; initially off, at no cost.
    void setRecording(bool on) { m_recorder.set(on); }
    [[nodiscard]] std::vector<ExchangeRecord> takeRecords() { return m_recorder.take(); }

private:
    /// An exchange in progress, or about to be repeated.
    struct Work {
        Ask ask;
        Task* task = nullptr;  ///< null when nothing waits for its end any more
        std::uint8_t refusals = 0;
        std::optional<Chain::Memory> before{};  ///< restored if the command is refused
        TimePoint sent{};
    };

    void begin(Discovery::Start start, TimePoint now);
    /// Calls `set` for each module.
    template <typename Set>
    void setForAll(Set set);
    [[nodiscard]] GroupFinished stopGroup(const GroupOperation& operation, const GroupCommand& command);
    [[nodiscard]] std::vector<ModuleIndex> membersOf(std::uint8_t group) const;
    void beginPath(const Operation& operation, TimePoint now);
    [[nodiscard]] bool takesStopsOnly() const;
    [[nodiscard]] bool oweStops(const Operation& operation);
    [[nodiscard]] bool isAsOwed(const Order& order) const;
    [[nodiscard]] bool haltAtOnce(const Operation& operation, TimePoint now);
    void beginTrial(const Operation& operation, TimePoint now);
    /// These modules are sent a stop: a path with one of them ends.
    void leavePath(const std::vector<ModuleIndex>& stopped);
    /// Owes a stop to the modules of a path that has ended early.
    void stopPath();
    [[nodiscard]] bool settled() const { return m_connected && !m_search.active() && !m_stops.stopping(); }
    /// Something is in progress that a change of the chain must not interrupt.
    [[nodiscard]] bool busy() const;
    /// Operations that change a module are accepted now.
    [[nodiscard]] bool accepting() const { return settled() && !m_config.readOnly; }
    /// The outcome of an operation that is not accepted.
    [[nodiscard]] Outcome refusal() const {
        return m_config.readOnly || lent() ? Outcome::Forbidden
               : settled()                 ? Outcome::QueueFull
                                           : Outcome::Cancelled;
    }

    // ---- dispatch ----
    void proceed(TimePoint now);
    [[nodiscard]] bool dispatch(TimePoint now);
    enum class Turn : std::uint8_t {
        Free,   ///< no task has needed the line so far
        Waits,  ///< a task needs it, once it is completely free
        Taken
    };
    [[nodiscard]] Turn take(Task& task, TimePoint now);
    [[nodiscard]] Turn repeat(bool atOnce, TimePoint now);
    void send(Work work, TimePoint now);
    void followProgram(TimePoint by, TimePoint now);

    // ---- end of an exchange ----
    void takeEnds(TimePoint now);
    void onEnd(ReplyEnd end, TimePoint now);
    void conclude(Work& work, ReplyEnd& end, TimePoint now);
    void examine(const Ask& ask, ReplyEnd& end);
    void count(const ReplyEnd& end);
    void noteHealth(const Ask& ask, const ReplyEnd& end, TimePoint now);
    [[nodiscard]] bool repeats(Work& work, const ReplyEnd& end);
    void deliver(const Work& work, const ReplyEnd& end, TimePoint now);
    void learn(const Work& work, const ReplyEnd& end);
    void publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted);

    // ---- consequences for all tasks ----
    void takeFindings(TimePoint now);
    void onSearchEnded(SearchTask::Ended ended, TimePoint now);
    [[nodiscard]] std::vector<ModuleInfo> knownModules() const;
    void adopt(ChainFound found, const Discovery& discovery, TimePoint now);
    void takeHeard(ModuleIndex module, const ReplyEnd& end);
    /// Stops these modules and cancels all other work for them.
    void haltAxes(const std::vector<ModuleIndex>& modules, StopCause cause, StopManner manner);
    /// A stop owed because of a fault, or in a stop of all modules, gives way only to a firmer one.
    [[nodiscard]] bool mayOwe(ModuleIndex module, StopManner manner) const;
    void onForeignTraffic();
    void onLinkLost();
    void giveUp(const Recovery::GivenUp& what, TimePoint now);
    void reinstate(TimePoint now);
    void goQuiet(TimePoint now);
    void notify(const Change& change);
    void cancelAll(Change::Kind why);
    void dropWorkOf(const Task& task);
    void interrupt(TimePoint now);

    EngineConfig m_config;
    std::vector<Event> m_events;
    Line m_line;
    ExchangeRecorder m_recorder{m_line};
    Chain m_chain;
    /// The chain that was found is in use. False before and during a search and after one that failed, and
    /// once the link has been given up: then only stops are sent.
    bool m_connected = false;
    bool m_stopAsked = false;     ///< since stopAll(), until no module owes a confirmation
    bool m_echoReported = false;  ///< never cleared: EchoNoticed is emitted once
    std::vector<ModuleIndex> m_watched;
    std::vector<StopOutputs> m_stopOutputs;
    std::deque<Work> m_works;  ///< oldest first: at most one, and one that only awaits surplus bytes

    Shared m_shared{m_chain, m_line, m_events};
    Recovery m_recovery{m_shared, m_line.statistics()};
    StopLane m_stops{m_shared, m_recovery};
    RestartSearch m_restartSearch{m_shared, m_recovery};
    SearchTask m_search{m_shared};
    RateTask m_rate{m_shared, m_config};
    WayBack m_wayBack{m_shared, m_rate, m_stops, m_recovery};
    ReaddressTask m_readdress{m_shared, m_config, m_restartSearch};
    TrialTask m_trials{m_shared};
    HoldTask m_hold{m_shared, m_config};
    OperationTask m_operations{m_shared};
    PathTask m_path{m_shared};
    PollTask m_polls{m_shared, m_recovery, m_restartSearch};
    WellAgain m_wellAgain{m_shared};
    Lending m_lending{m_shared, m_recovery};
    std::array<Task*, 13> m_tasks{&m_trials,    &m_operations,    &m_path,   &m_hold,     &m_rate,
                                  &m_readdress, &m_restartSearch, &m_search, &m_recovery, &m_wayBack,
                                  &m_wellAgain, &m_stops,         &m_polls};
    std::optional<Work> m_again;  ///< waits to be repeated
    Work* m_ending = nullptr;     ///< in onEnd(), taken from m_works
};

}  // namespace nmc::bus
