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
#include "bus/line.h"
#include "bus/operationtask.h"
#include "bus/owedstops.h"
#include "bus/pathtask.h"
#include "bus/polltask.h"
#include "bus/ratetask.h"
#include "bus/readdresstask.h"
#include "bus/recovery.h"
#include "bus/restartsearch.h"
#include "bus/searchtask.h"
#include "bus/stoptask.h"
#include "bus/trialtask.h"
#include "bus/types.h"
#include "bus/wellagain.h"

namespace nmc::bus {

/// The master of the bus: one exchange in flight; stops before commands before polls.
///
/// Sans-I/O: bytes and time points in; output, samples and events out. It owns no thread, port or clock.
/// After every call the caller does what takeOutput() says, in order, and arms a timer for nextDeadline().
/// One thread (the bus thread, or a test).
///
/// With EngineConfig::readOnly it looks and changes nothing, for as long as it lives. No Operation, Read
/// Status and nulls are all that goes out, whatever happens, and what stops a module once stopAll() was
/// called and until each module has confirmed. Submit, changeRate, readdress and hold end at once as refused
/// (Forbidden, NotNow). It stops nobody of its own accord and suspects no motion, since each is somebody
/// else's.
class Engine {
public:
    explicit Engine(EngineConfig config);
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;

    /// Finds the chain: one that has its addresses, at any rate, is left as it is (ChainFound::attached;
    /// nulls and No Operation only, until it is found); a fresh one is given addresses and the configured
    /// rate, or with EngineConfig::readOnly is ConnectFailure::Unaddressed. Then polls. Ends in ChainFound or
    /// ConnectFailed.
    void connect(TimePoint now);
    /// Restarts the network (Hard Reset at every rate a chain may have been left at) and gives addresses.
    /// Positions and gains of the modules are lost. A read-only connection only looks for the chain anew, as
    /// connect() does, and ends so: ChainFound::attached and ::readOnly say that nothing was reset.
    void restart(TimePoint now);

    /// Queues an operation behind those before it. It ends in exactly one OperationFinished.
    void submit(Operation operation, TimePoint now);

    /// Gains that are being tried on that module (Operation::trial) stay; too late they do not.
    void keepTrial(ModuleIndex module, TimePoint now);

    /// The same for groups; ends in exactly one GroupFinished. A command to a group is sent once, and what
    /// came of it is what each member shows; only if all groups are known.
    /// A stop of a group goes past all that waits: what was asked for of its members is cancelled, a hold of
    /// one of them ends, and they are owed the stop until each has confirmed (OwedStopConfirmed).
    void submit(const GroupOperation& operation, TimePoint now);

    /// Takes the chain to another rate that the chips can make (findBrd); positions, gains and loads stay.
    /// Refused while anything moves; when a module does not follow, all go back. Ends in RateChanged or
    /// RateChangeFailed.
    void changeRate(std::uint32_t baud, TimePoint now);

    /// Gives a module that restarted its address back (readdresstask.h). Ends in Readdressed or
    /// ReaddressFailed.
    void readdress(ModuleIndex module, TimePoint now);
    /// Gives a module that answers another address, 1..127; its group stays. Ends in AddressChanged or
    /// ReaddressFailed.
    void moveTo(ModuleIndex module, BusAddress address, TimePoint now);
    /// Resets one module, and does the same; the others keep what they have. ModuleRestarted comes before the
    /// end. `configuration`: what an SC is to save or to erase by it.
    void resetModule(ModuleIndex module, TimePoint now,
                     const std::optional<servo::HardReset>& configuration = {});

    /// Starts or re-arms held motion: velocity mode, changed on the fly. The engine stops the motor smoothly
    /// (abruptly when the acceleration is 0) at release() or config.holdTimeout after the last hold(). Ended
    /// so or otherwise, or not possible now: only a press of a higher number moves again.
    void hold(const HoldToMove& hold, TimePoint now);
    void release(TimePoint now);

    /// Stops every motor, past all queues; queued operations are cancelled and a hold ends. A servo that is
    /// on is stopped abruptly and keeps holding; one that is off stays off (link.md 2.6). Repeated until each
    /// module confirmed twice or does not answer; ends in exactly one StopFinished, also when called again.
    void stopAll(TimePoint now);
    /// The same where nobody has asked for it: nobody is there any more who could, or the machine sleeps.
    /// False: a read-only connection stops nobody unasked. A stop that was asked for goes on.
    bool stopUnasked(TimePoint now);
    /// A stop of all has not run its course yet.
    [[nodiscard]] bool stopping() const { return m_stop.active(); }

    /// Something happened to this machine, a suspend say: the link is checked before anything is believed.
    void distrust(TimePoint now);

    /// Modules that somebody looks at: they are polled as often as the wire carries, the others about five
    /// times a second. None: all alike.
    void watch(const std::vector<ModuleIndex>& modules);

    /// Which outputs of PIC-I/O modules a stop of all takes low, by module; none of those that are not there.
    /// Holds for every chain that is found from now on, too.
    void setStopOutputs(const std::vector<StopOutputs>& outputs);

    /// How far each axis may go, by module: what has no end of its own is stopped before that
    /// (StoppedBeforeLimit). Set again once the counter of a module was set, or a chain was found.
    void setTravelLimits(const std::vector<TravelLimits>& limits);

    /// One module as fast as the wire carries, its position every time, for 5 s at most: the others are asked
    /// once a second, silent ones not at all. Nothing: no longer. A stop of whatever kind ends it, and so
    /// does another connect(). Calling it again begins the time anew.
    void focus(std::optional<ModuleIndex> module, TimePoint now);

    /// `bytes` arrived; `now` is when they were read.
    void onBytes(ByteSpan bytes, TimePoint now);
    /// nextDeadline() has passed.
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;

    [[nodiscard]] std::vector<Output> takeOutput() { return m_line.takeOutput(); }
    [[nodiscard]] std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    [[nodiscard]] const LinkStatistics& statistics() const { return m_line.statistics(); }
    /// Modules a stop would reach now: those that answer.
    [[nodiscard]] std::size_t stopReach() const { return m_chain.schedule().answering(); }
    /// A stop waits for a search that has seen somebody: it may still reach him.
    [[nodiscard]] bool stopMayStillReach() const { return m_stop.waits() && m_search.seen() > 0; }
    /// Some motor moves, or may.
    [[nodiscard]] bool anythingMoves() const { return m_chain.anythingMoves() || m_operations.swings(); }
    /// The same, where stopUnasked() would stop it.
    [[nodiscard]] bool answersForMotion() const { return !m_config.readOnly && anythingMoves(); }
    /// The whole stop as bytes that need no answer, nulls first, for a process that is about to die (link.md
    /// 2.6); empty when nothing is on, and on a read-only connection. Changes only with a command or a
    /// status.
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const { return m_chain.stopBurst(); }
    /// The rate at which the chain hears that; the port may be at another one, in a search say.
    [[nodiscard]] std::uint32_t stopBurstBaud() const { return m_chain.rate(); }
    /// The burst when it, or its rate, has changed since this was asked for the last time; cheap otherwise.
    /// Empty at first.
    [[nodiscard]] std::optional<std::vector<std::uint8_t>> changedStopBurst();

    /// Records every exchange from now on, for the packet monitor; off at first, and then without cost.
    void setRecording(bool on) { m_recorder.set(on); }
    [[nodiscard]] std::vector<ExchangeRecord> takeRecords() { return m_recorder.take(); }

private:
    /// An exchange that is on the wire, or about to be repeated.
    struct Work {
        Ask ask;
        Task* task = nullptr;  ///< none when nobody waits for its end any more
        std::uint8_t refusals = 0;
        std::optional<Chain::Memory> before{};  ///< to put back when it is refused
        TimePoint sent{};
    };

    void begin(Discovery::Start start, TimePoint now);
    [[nodiscard]] GroupFinished stopGroup(const GroupOperation& operation, const GroupCommand& command);
    void beginPath(const Operation& operation, TimePoint now);
    [[nodiscard]] bool oweStops(const Operation& operation);
    void beginTrial(const Operation& operation, TimePoint now);
    /// These are told to stop: a path that one of them is on is over.
    void leavePath(const std::vector<ModuleIndex>& stopped);
    /// Whoever is on a path that has ended early is owed a stop.
    void stopPath();
    [[nodiscard]] bool settled() const { return m_connected && !m_search.active() && !m_stop.active(); }
    /// Something is under way that may not be interrupted by a change of the chain.
    [[nodiscard]] bool busy() const;
    /// What changes a module may be asked for now.
    [[nodiscard]] bool accepting() const { return settled() && !m_config.readOnly; }
    /// How a request ends that is not taken.
    [[nodiscard]] Outcome refusal() const {
        return m_config.readOnly ? Outcome::Forbidden : settled() ? Outcome::QueueFull : Outcome::Cancelled;
    }

    // ---- what is next ----
    void proceed(TimePoint now);
    [[nodiscard]] bool dispatch(TimePoint now);
    enum class Turn : std::uint8_t {
        Nobody,  ///< wants the line, so far
        Waits,   ///< somebody does, once it is quite free
        Taken
    };
    [[nodiscard]] Turn take(Task& task, TimePoint now);
    [[nodiscard]] Turn repeat(bool atOnce, TimePoint now);
    void send(Work work, TimePoint now);

    // ---- what came of it ----
    void takeEnds(TimePoint now);
    void onEnd(ReplyEnd end, TimePoint now);
    [[nodiscard]] std::optional<Rejection> examine(const Ask& ask, ReplyEnd& end);
    void count(const ReplyEnd& end, std::optional<Rejection> rejection);
    void noteHealth(const Ask& ask, const ReplyEnd& end, TimePoint now);
    [[nodiscard]] bool repeats(Work& work, const ReplyEnd& end);
    void deliver(const Work& work, const ReplyEnd& end, TimePoint now);
    void learn(const Work& work, const ReplyEnd& end);
    void publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted);

    // ---- what follows for all tasks ----
    void takeFindings(TimePoint now);
    void onSearchEnded(SearchTask::Ended ended, TimePoint now);
    [[nodiscard]] std::vector<ModuleInfo> knownModules() const;
    void adopt(ChainFound found, const Discovery& discovery, TimePoint now);
    void takeHeard(ModuleIndex module, const ReplyEnd& end);
    void halt(ModuleIndex module, StopCause cause, StopManner manner);
    /// These, and whatever else was asked for of them is cancelled. What is owed for a fault is not made
    /// weaker.
    void haltAxes(const std::vector<ModuleIndex>& modules, StopCause cause, StopManner manner);
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
    /// The chain that was found is asked and told. Not before a search, while it lasts, when it has failed;
    /// nor once the link has been given up: then only stops go out.
    bool m_connected = false;
    bool m_stopAsked = false;     ///< from stopAll() until no module owes a confirmation
    bool m_echoReported = false;  ///< once true, stays so: EchoNoticed comes once
    std::vector<ModuleIndex> m_watched;
    std::vector<StopOutputs> m_stopOutputs;
    std::deque<Work> m_works;  ///< on the wire, oldest first: at most one, and one that only settles

    Recovery m_recovery{m_chain, m_line, m_events};
    StopTask m_stop{m_chain, m_recovery, m_line, m_events};
    OwedStops m_owedStops{m_chain, m_recovery, m_line, m_events};
    RestartSearch m_restartSearch{m_chain, m_recovery, m_line, m_events};
    SearchTask m_search{m_events};
    RateTask m_rate{m_config, m_chain, m_events};
    WayBack m_wayBack{m_rate, m_chain, m_stop, m_recovery, m_line};
    ReaddressTask m_readdress{m_config, m_chain, m_restartSearch, m_line, m_events};
    TrialTask m_trials{m_chain, m_events};
    HoldTask m_hold{m_config, m_chain, m_events};
    OperationTask m_operations{m_chain, m_line, m_events};
    PathTask m_path{m_chain, m_line, m_events};
    PollTask m_polls{m_chain, m_recovery, m_restartSearch};
    WellAgain m_wellAgain{m_chain};
    std::array<Task*, 14> m_tasks{&m_trials,    &m_operations,    &m_path,      &m_hold,     &m_rate,
                                  &m_readdress, &m_restartSearch, &m_search,    &m_recovery, &m_wayBack,
                                  &m_wellAgain, &m_stop,          &m_owedStops, &m_polls};
    std::optional<Work> m_again;  ///< to be repeated
    /// Of each module, and where it went, when somebody asked last.
    std::vector<std::pair<BusAddress, std::optional<ModuleCommand>>> m_burstStops;
    std::uint32_t m_burstBaud = 0;  ///< the same
};

}  // namespace nmc::bus
