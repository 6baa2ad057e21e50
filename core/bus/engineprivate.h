// SPDX-License-Identifier: MIT
#pragma once

// The inside of Engine; for core/bus/engine*.cpp only.

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/commandlane.h"
#include "bus/discovery.h"
#include "bus/engine.h"
#include "bus/gate.h"
#include "bus/grouprun.h"
#include "bus/health.h"
#include "bus/holdlane.h"
#include "bus/line.h"
#include "bus/motionwatch.h"
#include "bus/plausibility.h"
#include "bus/pollschedule.h"
#include "bus/ratechange.h"
#include "bus/silence.h"
#include "bus/stoprun.h"
#include "bus/trust.h"
#include "bus/verification.h"

namespace nmc::bus {

/// Puts the pure parts together: asks each lane in its order what it wants next, puts that on the line, and
/// hands back what came of it.
class Engine::Private {
public:
    explicit Private(EngineConfig config);

    // engine.cpp: from outside
    void begin(Discovery::Start start, TimePoint now);
    void submit(Operation operation, TimePoint now);
    void submit(const GroupOperation& operation, TimePoint now);  // enginegroup.cpp
    void changeRate(std::uint32_t baud, TimePoint now);           // enginerate.cpp
    void hold(const HoldToMove& hold, TimePoint now);
    void release(TimePoint now);
    void stopAll(TimePoint now);
    void distrust(TimePoint now);
    void watch(const std::vector<ModuleIndex>& modules);
    void focus(std::optional<ModuleIndex> module, TimePoint now);
    void onBytes(ByteSpan bytes, TimePoint now);
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] std::size_t stopReach() const;
    [[nodiscard]] bool anythingMoves() const;
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const;
    [[nodiscard]] std::uint32_t stopBurstBaud() const { return m_baud; }
    [[nodiscard]] bool stopBurstChanged();
    void setRecording(bool on);

    EngineConfig config;
    Line line;
    std::vector<Event> events;
    std::vector<ExchangeRecord> records;

private:
    enum class Phase : std::uint8_t {
        Off,
        Discovering,
        Running,
        Quiet,  ///< connected, but nothing is asked any more: only stops go out
    };
    enum class Lane : std::uint8_t {
        Discovery,
        Stop,
        Guard,  ///< the stop of a motion that is not as commanded
        HoldStop,
        HoldCheck,
        Hold,
        Operation,
        Group,      ///< to a group that has a leader
        GroupLook,  ///< what became of it at a member?
        Check,
        Rate,
        Challenge,
        Restarted,  ///< is there a module without an address?
        Poll
    };

    /// One thing to ask of one module, with its repeats.
    struct Work {
        Lane lane = Lane::Poll;
        std::optional<ModuleIndex> module;  ///< none during discovery
        Request request;
        std::optional<ModuleCommand> command;  ///< what to believe when it is carried out
        std::uint8_t silentRepeats = 0;        ///< left
        bool repeatAtOnce = false;
        Discovery::Quarantine quarantine = Discovery::Quarantine::Full;
        std::uint8_t refusedAttempts = 3;  ///< in total
        std::uint8_t refusals = 0;
        std::optional<Belief> before{};  ///< to put back when it is refused
        std::optional<HoldToMove> toldBefore{};
        TimePoint sent{};
    };
    /// Everything about one module.
    struct Module {
        explicit Module(const ModuleInfo& info)
            : belief(info), plausibility(info.identity), trust(info.identity.type) {}
        Belief belief;
        Plausibility plausibility;
        Trust trust;
        MotionWatch watch;
        Health health;
    };
    /// A module whose last answer was wrong or missing: two right ones, of different length, end that.
    struct Doubt {
        ModuleIndex module;
        bool wasSilent = false;
        unsigned passed = 0;
        unsigned failures = 0;
        unsigned silences = 0;  ///< of them
        bool bySilence = false;
        bool witnessDue = false;  ///< first somebody else is asked whether the bus is there at all
        bool witness = false;     ///< that is the question under way
    };
    enum class Look : std::uint8_t { None, GoSlow, Ask, Back };
    struct GroupVerdict {
        Verdict verdict;
        std::optional<ModuleIndex> module;  ///< that it hangs on
    };

    // enginedispatch.cpp: what is next
    void proceed(TimePoint now);
    [[nodiscard]] bool mayPipeline() const;
    [[nodiscard]] bool dispatch(TimePoint now);
    [[nodiscard]] bool dispatchUrgent(TimePoint now);
    [[nodiscard]] bool strayed() const;
    [[nodiscard]] bool stopDue(TimePoint now) const;
    void dispatchGuard(TimePoint now);
    void dispatchDiscovery(TimePoint now);
    void dispatchStop(TimePoint now);
    [[nodiscard]] bool dispatchHold(TimePoint now);
    [[nodiscard]] bool dispatchOperation(TimePoint now);
    [[nodiscard]] bool dispatchVerification(TimePoint now);
    [[nodiscard]] bool dispatchPoll(TimePoint now);
    void check(ModuleIndex module, Lane lane, TimePoint now);
    [[nodiscard]] Work commandWork(Lane lane, const Step& step) const;
    [[nodiscard]] Work statusWork(Lane lane, ModuleIndex module, std::optional<StatusItems> items) const;
    [[nodiscard]] ReplyLayout layoutOf(const Belief& belief, const Payload& payload) const;
    void begin(Work work, TimePoint now);
    void tell(ModuleIndex module, const ModuleCommand& command, TimePoint latched);

    // engineoutcome.cpp: what came of it
    void takeEnds(TimePoint now);
    void ended(ReplyEnd end, TimePoint now);
    [[nodiscard]] std::optional<Rejection> examine(const Work& work, ReplyEnd& end);
    void count(const ReplyEnd& end, std::optional<Rejection> rejection);
    void distrustAfter(const Work& work, const ReplyEnd& end, TimePoint now);
    [[nodiscard]] static bool isStart(const Work& work);
    [[nodiscard]] bool repeats(Work& work, const ReplyEnd& end);
    void learn(const Work& work, const ReplyEnd& end);
    void tellBlindStop(ModuleIndex module);
    [[nodiscard]] static bool reported(const Work& work);
    void deliver(const Work& work, const ReplyEnd& end, TimePoint now);
    void deliverOperation(const Work& work, const ReplyEnd& end);
    void failOperation(const ReplyEnd& end);
    void tellGroupUnknown();
    void deliverHold(const Work& work, const ReplyEnd& end);
    void deliverHoldStop(const ReplyEnd& end);
    void deliverGuard(const ReplyEnd& end);
    void publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted);
    void guard(ModuleIndex module, MotionSuspect::Reason reason, std::int32_t position);
    void chainFound(ChainFound found, TimePoint now);

    // enginerecovery.cpp: getting back to trusting the link, or giving it up
    void resync(TimePoint now);
    void flushBuffers(TimePoint now);
    void dispatchChallenge(TimePoint now);
    [[nodiscard]] std::optional<ModuleIndex> witness() const;
    void deliverChallenge(const Work& work, const ReplyEnd& end, TimePoint now);
    void passed(ModuleIndex module, TimePoint now);
    void deliverProbe(const Work& work, const ReplyEnd& end, TimePoint now);
    void lose(ModuleIndex module, TimePoint now);
    void loseAll(TimePoint now);
    void giveUpRepeat(TimePoint now);
    void dispatchLook(TimePoint now);
    void goBack(TimePoint now);
    void deliverLook(const ReplyEnd& end, TimePoint now);
    void noteHealth(const Work& work, const ReplyEnd& end, TimePoint now);
    void noteExchange(ModuleIndex module, bool right, TimePoint now);
    void giveUp(ModuleIndex module, TimePoint now);
    void giveUp(TimePoint now);
    void dispatchLostBurst(TimePoint now);
    [[nodiscard]] bool lostBurstDue(TimePoint now) const;

    // enginegroup.cpp: groups and their commands
    [[nodiscard]] bool dispatchGroup(TimePoint now);
    [[nodiscard]] std::optional<ModuleIndex> planChange(const GroupChange& change);
    [[nodiscard]] bool reachable(ModuleIndex module) const;
    [[nodiscard]] GroupVerdict judgeGroup(const GroupCommand& command) const;
    void tryGroupCommand(const GroupCommand& command, TimePoint now);
    void sendToGroup(const GroupCommand& command, TimePoint now);
    void lookAtMembers(TimePoint now);
    void noteGroupLook(ModuleIndex module, const ReplyEnd& end);
    void finishGroupCommand();
    void stopMembers(const std::vector<GroupMember>& members);

    // enginerate.cpp: another rate for a chain that runs
    [[nodiscard]] std::optional<RateChangeFailed::Reason> rateObstacle(
        std::uint32_t baud, std::vector<ModuleIndex>& modules) const;
    void dispatchRateChange(TimePoint now);
    void finishRateChange(const RateChange::Ended& ended);
    void abandonRateChange();
    [[nodiscard]] bool dispatchWayBack(TimePoint now);

    // enginestop.cpp: stop all
    void interrupt(TimePoint now);
    void sendBlindStops(TimePoint now);
    [[nodiscard]] Line::Script stopScript(const std::vector<Step>& stops) const;
    void noteBlindStops();
    [[nodiscard]] std::vector<Step> stopsOwed() const;
    void stopForHold(TimePoint now);
    void finishStop(TimePoint now);

    // enginerecord.cpp: for the packet monitor
    void record(const Work& work, const ReplyEnd& end, std::optional<Rejection> rejection);
    void recordAs(const Work& work, const ReplyEnd& end, ExchangeEnd how, std::optional<Rejection> rejection);
    void recordUnanswered();
    void recordAbandoned(TimePoint now);
    [[nodiscard]] static Purpose purposeOf(Lane lane);

    void expireHold(TimePoint now);
    void hurryHoldStop(TimePoint now);
    void cancelOperations();
    [[nodiscard]] Module& at(ModuleIndex module) { return m_modules[module.value()]; }
    [[nodiscard]] Belief& belief(ModuleIndex module) { return at(module).belief; }
    [[nodiscard]] const Belief& belief(ModuleIndex module) const { return m_modules[module.value()].belief; }
    [[nodiscard]] std::vector<Belief> beliefs() const;

    Phase m_phase = Phase::Off;
    std::deque<Work> m_works;     ///< in flight, oldest first: at most one, and one that only settles
    std::optional<Work> m_again;  ///< to be repeated
    bool m_suspect = false;       ///< a resync is due
    bool m_resyncing = false;     ///< or under way
    bool m_hurried = false;       ///< a stop went ahead of it with nulls only; the quarantine is still owed
    Duration m_quarantine = kMinQuarantine;
    std::optional<Doubt> m_doubt;
    Silence m_silence;
    bool m_lost = false;
    Look m_look = Look::None;
    std::optional<ModuleIndex> m_lookedAt;
    unsigned m_probes = 0;
    Health m_health;
    unsigned m_lostBursts = 0;  ///< stops that still go out on a dead line
    TimePoint m_nextLostBurst;

    std::optional<Discovery> m_discovery;
    std::uint32_t m_baud = kPowerUpBaud;
    std::vector<Module> m_modules;
    PollSchedule m_schedule;
    std::vector<ModuleIndex> m_watched;
    CommandLane m_commands;
    std::optional<Verification> m_verification;
    unsigned m_attempts = 0;                 ///< of the present step, after looks
    std::optional<GroupRun> m_groupRun;      ///< a command to a group is out
    std::optional<RateChange> m_rateChange;  ///< under way
    std::optional<RateChange> m_abandoned;   ///< all go back to the old rate
    bool m_goingBack = false;                ///< they are being told to
    HoldLane m_hold;
    std::deque<Step> m_guards;  ///< stops that are owed
    unsigned m_guardFailures = 0;
    std::optional<StopRun> m_stop;
    bool m_blindStopsDue = false;
    std::vector<Step> m_blindStops;  ///< under way
    bool m_blindStopsHeard = false;  ///< the link was not in doubt when they went out
    unsigned m_holdFailures = 0;     ///< refused starts, or stops that were not answered, in a row
    std::optional<TimePoint> m_stopDuringDiscovery;
    std::vector<std::optional<ModuleCommand>> m_burstStops;  ///< of each module, when somebody asked last
    std::uint32_t m_burstBaud = 0;                           ///< the same

    bool m_recording = false;
    std::uint64_t m_recorded = 0;
};

}  // namespace nmc::bus
