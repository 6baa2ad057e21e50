// SPDX-License-Identifier: MIT
#pragma once

// The inside of Engine; for core/bus/engine*.cpp only.

#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/commandlane.h"
#include "bus/discovery.h"
#include "bus/engine.h"
#include "bus/holdlane.h"
#include "bus/line.h"
#include "bus/pollschedule.h"
#include "bus/stoprun.h"

namespace nmc::bus {

/// Puts the pure parts together: asks each lane in its order what it wants next, puts that on the line, and
/// hands back what came of it.
class Engine::Private {
public:
    explicit Private(EngineConfig config);

    // engine.cpp: from outside
    void connect(TimePoint now);
    void submit(Operation operation, TimePoint now);
    void hold(const HoldToMove& hold, TimePoint now);
    void release(TimePoint now);
    void stopAll(TimePoint now);
    void onBytes(ByteSpan bytes, TimePoint now);
    void onDeadline(TimePoint now);
    [[nodiscard]] std::optional<TimePoint> nextDeadline() const;
    [[nodiscard]] std::size_t stopReach() const;
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const;

    EngineConfig config;
    Line line;
    std::vector<Event> events;
    bool recording = false;
    std::vector<ExchangeRecord> records;

private:
    enum class Phase : std::uint8_t { Off, Discovering, Running };
    enum class Lane : std::uint8_t { Discovery, Stop, HoldStop, HoldCheck, Hold, Operation, Check, Poll };

    /// One thing to ask of one module, with its repeats.
    struct Work {
        Lane lane = Lane::Poll;
        std::optional<ModuleIndex> module;  ///< none during discovery
        Request request;
        std::optional<ModuleCommand> command;  ///< what to believe when it is carried out
        std::uint8_t silentRepeats = 0;        ///< left
        bool repeatAtOnce = false;
        std::uint8_t refusedAttempts = 3;  ///< in total
        std::uint8_t refusals = 0;
        std::optional<Belief> before{};  ///< to put back when it is refused
        std::optional<HoldToMove> toldBefore{};
    };

    // enginedispatch.cpp: what is next
    void proceed(TimePoint now);
    [[nodiscard]] bool dispatch(TimePoint now);
    void dispatchDiscovery(TimePoint now);
    void dispatchStop(TimePoint now);
    [[nodiscard]] bool dispatchHold(TimePoint now);
    [[nodiscard]] bool dispatchOperation(TimePoint now);
    [[nodiscard]] bool dispatchPoll(TimePoint now);
    void resync(TimePoint now);
    void flushBuffers(TimePoint now);
    void check(ModuleIndex module, Lane lane, TimePoint now);
    [[nodiscard]] Work commandWork(Lane lane, const Step& step) const;
    [[nodiscard]] Work statusWork(Lane lane, ModuleIndex module, std::optional<StatusItems> items) const;
    [[nodiscard]] ReplyLayout layoutOf(const Belief& belief, const Payload& payload) const;
    void begin(Work work, TimePoint now);

    // engineoutcome.cpp: what came of it
    void ended(const ReplyEnd& end, TimePoint now);
    [[nodiscard]] bool repeats(Work& work, const ReplyEnd& end);
    void learn(const Work& work, const ReplyEnd& end, TimePoint now);
    void tellBlindStop(ModuleIndex module);
    [[nodiscard]] static bool reported(const Work& work);
    void deliver(const Work& work, const ReplyEnd& end, TimePoint now);
    void deliverOperation(const ReplyEnd& end);
    void deliverHold(const Work& work, const ReplyEnd& end);
    void deliverHoldStop(const ReplyEnd& end);
    void noteAnswer(ModuleIndex module, TimePoint now);
    void noteTimeout(ModuleIndex module, TimePoint now);
    void chainFound(ChainFound found);

    // stop all
    void interrupt();
    void sendBlindStops(TimePoint now);
    void noteBlindStops();
    void stopForHold(TimePoint now);
    void finishStop(TimePoint now);

    void expireHold(TimePoint now);
    void hurryHoldStop();
    void cancelOperations();
    [[nodiscard]] Belief& belief(ModuleIndex module) { return m_beliefs[module.value()]; }
    [[nodiscard]] const Belief& belief(ModuleIndex module) const { return m_beliefs[module.value()]; }

    Phase m_phase = Phase::Off;
    std::optional<Work> m_work;   ///< in flight
    std::optional<Work> m_again;  ///< to be repeated
    bool m_suspect = false;       ///< a resync is due
    bool m_resyncing = false;     ///< or under way
    bool m_hurried = false;       ///< a stop went ahead of it with nulls only; the quarantine is still owed
    Duration m_quarantine = kMinQuarantine;
    bool m_lost = false;

    std::optional<Discovery> m_discovery;
    std::vector<Belief> m_beliefs;
    PollSchedule m_schedule;
    CommandLane m_commands;
    HoldLane m_hold;
    std::optional<StopRun> m_stop;
    bool m_blindStopsDue = false;
    std::vector<Step> m_blindStops;  ///< under way
    bool m_blindStopsHeard = false;  ///< the link was not in doubt when they went out
    unsigned m_holdFailures = 0;     ///< refused starts, or stops that were not answered, in a row
    std::optional<TimePoint> m_stopDuringDiscovery;
};

}  // namespace nmc::bus
