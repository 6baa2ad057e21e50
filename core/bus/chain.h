// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bus/belief.h"
#include "bus/health.h"
#include "bus/line.h"
#include "bus/motionwatch.h"
#include "bus/ownmotion.h"
#include "bus/plausibility.h"
#include "bus/pollschedule.h"
#include "bus/stoptarget.h"
#include "bus/task.h"
#include "bus/travelwatch.h"
#include "bus/trialwatch.h"
#include "bus/trust.h"

namespace nmc::bus {

/// A stop that somebody owes to one module (the end of a hold, a motion that strays, a stop of all that was
/// not confirmed): repeated while the port is open, ended by a confirmation only. OwedStops sends.
struct OwedStop {
    StopTarget target;
    StopCause cause;
    TimePoint due{};     ///< of the next question; at once at first
    unsigned looks = 0;  ///< at a motor that went on moving
};

/// Gains that are being tried on one module. TrialTask sees to them.
struct Trial {
    enum class Phase : std::uint8_t { Sending, Watching, Returning };

    Trial(OperationId operation, const servo::SetGain& gains, const GainTrial& what)
        : id(operation), tried(gains), net(what), watch(gains, what) {}

    OperationId id;
    servo::SetGain tried;
    GainTrial net;
    TrialWatch watch;
    Phase phase = Phase::Sending;
    TimePoint due{};  ///< of the next thing to do; at once at first
    std::optional<TrialEnd> end{};
    Outcome outcome = Outcome::Cancelled;  ///< once it is over
    bool told = false;                     ///< once true, stays so: its OperationFinished came
};

/// The chain that was found last: its modules, and all that is believed of each. Kept while another one is
/// looked for, since a stop must reach somebody. The one owner of that state; tasks read it and tell it what
/// they send. Pure.
class Chain {
public:
    /// All that follows from what a module was told. A command that was refused was certainly not carried
    /// out: then this is as it was before.
    struct Memory {
        explicit Memory(const ModuleInfo& info)
            : belief(info), plausibility(info.identity), ownMotion(info.identity.type) {}
        Belief belief;
        ServoRegisters sent;  ///< as if all that was sent had been carried out
        Plausibility plausibility;
        MotionWatch watch;
        OwnMotion ownMotion;
        TravelWatch travel;
    };
    struct Module : Memory {
        explicit Module(const ModuleInfo& info) : Memory(info), trust(info.identity) {}
        /// The same module, of which nothing is known any more but what a stop is to take low.
        explicit Module(const Belief& before) : Module(before.info()) {
            belief.forgetOutputs(before.outputs().stopOutputs());
        }
        Trust trust;
        Health health;
        std::optional<OwedStop> owed{};
        std::optional<Trial> trial{};
        /// Since then there is a command that nobody has answered, and it may have been carried out.
        std::optional<TimePoint> unanswered{};
    };

    Chain() = default;
    /// `readOnly`: as EngineConfig::readOnly. What replies have in them is for others to define, and no stop
    /// is owed or lies ready but that somebody asked for.
    Chain(const std::vector<ModuleInfo>& modules, std::uint32_t rate, bool readOnly);

    void noteUnanswered(ModuleIndex module, TimePoint latched) {
        auto& since = at(module).unanswered;
        since = since.value_or(latched);
    }
    /// It is answered, or nobody will find out any more. How much earlier than `latched` it may have been
    /// carried out.
    Duration takeUnanswered(ModuleIndex module, TimePoint latched) {
        const auto since = std::exchange(at(module).unanswered, std::nullopt);
        return since && *since < latched ? latched - *since : Duration{};
    }

    [[nodiscard]] bool empty() const { return m_modules.empty(); }
    [[nodiscard]] std::size_t size() const { return m_modules.size(); }
    [[nodiscard]] bool has(ModuleIndex module) const { return module.value() < m_modules.size(); }
    [[nodiscard]] const std::vector<Module>& modules() const { return m_modules; }
    [[nodiscard]] std::vector<Module>& modules() { return m_modules; }
    [[nodiscard]] Module& at(ModuleIndex module) { return m_modules[module.value()]; }
    [[nodiscard]] const Module& at(ModuleIndex module) const { return m_modules[module.value()]; }
    [[nodiscard]] const Belief& belief(ModuleIndex module) const { return at(module).belief; }

    /// Nominal rate at which its modules listen.
    [[nodiscard]] std::uint32_t rate() const { return m_rate; }
    void setRate(std::uint32_t rate) { m_rate = rate; }

    [[nodiscard]] PollSchedule& schedule() { return m_schedule; }
    [[nodiscard]] const PollSchedule& schedule() const { return m_schedule; }
    [[nodiscard]] bool answers(ModuleIndex module) const { return !m_schedule.silent(module); }
    [[nodiscard]] bool anythingMoves() const;
    [[nodiscard]] bool anyRestarted() const;
    /// Its addresses are given anew: whoever answers there may be what it was, or has just been reset and is
    /// off, and a stop would switch it on. So each is looked at before it is told anything;
    /// StopTarget::stop() says what is told to one that does not answer.
    void forgetStates();

    /// How to ask a module: a command with the repeats that the retry table grants (link.md 2.3), Read Status
    /// with `items`, or No Operation. While the defined items are in doubt, defining them is the question;
    /// a chain that is only looked at is asked for the standing ones each time.
    [[nodiscard]] Ask command(Purpose purpose, const Order& order) const;
    [[nodiscard]] Ask status(Purpose purpose, ModuleIndex module, std::optional<StatusItems> items) const;
    /// A status that is newer than whatever was sent, of another length than the last one, so that two of
    /// them permit; or first of all a known length.
    [[nodiscard]] Ask look(Purpose purpose, ModuleIndex module) const;
    [[nodiscard]] ReplyLayout layoutOf(const Belief& belief, const Payload& payload) const;
    /// Bytes of the longest answer that any of the modules can give.
    [[nodiscard]] std::size_t longestReply() const;

    /// The command goes out, and will be latched then: all that watch the module must reckon with it.
    void noteSent(ModuleIndex module, const ModuleCommand& command, TimePoint latched);

    /// Owes the module a stop, from now on. The cause of one that is owed already stays. On a read-only
    /// connection only what is left of a stop of all.
    void owe(ModuleIndex module, StopCause cause, StopManner manner = StopManner::Abruptly);

    /// The module was heard of after a silence: what is owed to it is due at once.
    void hurryOwedStop(ModuleIndex module, TimePoint now);

    /// The module has its address again after a restart: nothing that was known of it holds.
    void welcome(ModuleIndex module, TimePoint now);

    /// What would have to be told to whom for nothing to move any more.
    [[nodiscard]] std::vector<Order> stops() const;
    /// Those of them that take outputs low, as they go out.
    [[nodiscard]] std::vector<PacketBytes> outputStops() const;
    /// The same for somebody who will not be there any more to take gains back that are being tried.
    [[nodiscard]] std::vector<Order> lastOrders() const;
    /// These as bytes that need no answer, nulls first; empty when nothing is on, or it is read-only.
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const;
    /// Packets with these stops, one to a whole group where that is the same, and the pauses after them.
    [[nodiscard]] Line::Script stopScript(const std::vector<Order>& stops) const;
    /// The group to which one packet is the same as these stops; nothing where it would be heard by others,
    /// or not by all of them.
    [[nodiscard]] std::optional<BusAddress> groupOf(const std::vector<Order>& stops) const;

private:
    void addStop(Line::Script& script, BusAddress address, const Payload& payload, std::size_t reply) const;

    std::vector<Module> m_modules;
    std::uint32_t m_rate = kPowerUpBaud;
    bool m_readOnly = false;  ///< never changes; then nothing is owed or lies ready unasked
    PollSchedule m_schedule;
};

}  // namespace nmc::bus
