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

/// A stop that is owed to one module (the end of a hold, a motion that strays, a stop of all modules):
/// repeated while the port is open, and ended only by a confirmation. Sent by StopLane.
struct OwedStop {
    StopTarget target;
    StopCause cause;
    TimePoint due{};           ///< of the next query; initially at once
    unsigned looks = 0;        ///< at a motor that continued to move
    bool outstanding = false;  ///< a stop of all modules has ended without its confirmation

    /// It is owed for more than a stop of all modules that is still in progress.
    [[nodiscard]] bool standsAlone() const { return outstanding || cause != StopCause::StopAll; }
    /// Nothing may start the motor yet: a motor whose motion strayed must be seen at rest first, and any stop
    /// must have been sent.
    [[nodiscard]] bool forbidsStart() const { return !ofOperator(cause) || target.needsStop(); }
};

/// Gains that are being tried on one module, supervised by TrialTask.
struct Trial {
    enum class Phase : std::uint8_t { Sending, Watching, Returning };

    Trial(OperationId operation, const servo::SetGain& gains, const GainTrial& what)
        : id(operation), tried(gains), net(what), watch(gains, what) {}

    OperationId id;
    servo::SetGain tried;
    GainTrial net;
    TrialWatch watch;
    Phase phase = Phase::Sending;
    TimePoint due{};  ///< of the next action; initially at once
    std::optional<TrialEnd> end{};
    Outcome outcome = Outcome::Cancelled;  ///< set once it is over
    bool reported = false;                 ///< never cleared: its OperationFinished was emitted
};

/// The last chain found: its modules, and everything believed about them. It is kept while another one is
/// searched for, because a stop must reach some module. The only owner of this state; tasks read it and
/// report to it what they send. Pure.
class Chain {
public:
    /// Everything that follows from the commands sent to a module. A refused command was certainly not
    /// carried out, so this state is then restored.
    struct Memory {
        explicit Memory(const ModuleInfo& info)
            : belief(info), plausibility(info.identity), ownMotion(info.identity.type) {}
        /// The module was found as another host left it: its settings are unknown.
        void attach() {
            belief.attach();
            plausibility.attach();
        }
        Belief belief;
        ServoRegisters sent;  ///< as if everything sent had been carried out
        Plausibility plausibility;
        MotionWatch watch;
        OwnMotion ownMotion;
        TravelWatch travel;
    };
    struct Module : Memory {
        explicit Module(const ModuleInfo& info) : Memory(info), trust(info.identity) {}
        /// The same module, about which nothing is known any more except which outputs a stop takes low.
        explicit Module(const Belief& before) : Module(before.info()) {
            belief.forgetOutputs(before.outputs().stopOutputs());
        }
        Trust trust;
        Health health;
        std::optional<OwedStop> owed{};
        std::optional<Trial> trial{};
        /// Nothing may start its motor yet: a stop comes first, or the gains from before a trial do.
        [[nodiscard]] bool forbidsStart() const {
            return (owed && owed->forbidsStart()) || (trial && trial->phase == Trial::Phase::Returning);
        }
        /// Since when there is an unanswered command that may have been carried out.
        std::optional<TimePoint> unanswered{};
    };

    Chain() = default;
    /// `readOnly`: as EngineConfig::readOnly. Other hosts define what replies contain, and no stop is owed or
    /// prepared unless it was requested.
    Chain(const std::vector<ModuleInfo>& modules, std::uint32_t rate, bool readOnly);

    void noteUnanswered(ModuleIndex module, TimePoint latched) {
        auto& since = at(module).unanswered;
        since = since.value_or(latched);
    }
    /// The command was answered, or its outcome will remain unknown. Returns how much earlier than `latched`
    /// it may have been carried out.
    Duration takeUnanswered(ModuleIndex module, TimePoint latched) {
        const auto since = std::exchange(at(module).unanswered, std::nullopt);
        return since && *since < latched ? latched - *since : Duration{};
    }
    /// What to ask a module next on its way to a confirmed stop. It is not retried: the next request is made
    /// for the state that the module is in by then.
    [[nodiscard]] Ask next(StopTarget& target) const;
    /// The event for a stop that was sent blind, at the first answer after it.
    [[nodiscard]] std::optional<CommandExecuted> takeBlindStop(StopTarget& target);

    [[nodiscard]] bool empty() const { return m_modules.empty(); }
    [[nodiscard]] std::size_t size() const { return m_modules.size(); }
    [[nodiscard]] bool has(ModuleIndex module) const { return module.value() < m_modules.size(); }
    [[nodiscard]] const std::vector<Module>& modules() const { return m_modules; }
    [[nodiscard]] std::vector<Module>& modules() { return m_modules; }
    [[nodiscard]] Module& at(ModuleIndex module) { return m_modules[module.value()]; }
    [[nodiscard]] const Module& at(ModuleIndex module) const { return m_modules[module.value()]; }
    [[nodiscard]] const Belief& belief(ModuleIndex module) const { return at(module).belief; }
    /// The module with this address; null if there is none.
    [[nodiscard]] const Module* find(BusAddress address) const;
    [[nodiscard]] std::vector<ModuleInfo> infos() const;

    /// Nominal rate to which its modules are set.
    [[nodiscard]] std::uint32_t rate() const { return m_rate; }
    void setRate(std::uint32_t rate) { m_rate = rate; }

    [[nodiscard]] PollSchedule& schedule() { return m_schedule; }
    [[nodiscard]] const PollSchedule& schedule() const { return m_schedule; }
    [[nodiscard]] bool answers(ModuleIndex module) const { return !m_schedule.silent(module); }
    [[nodiscard]] bool anythingMoves() const;
    [[nodiscard]] bool anyRestarted() const;
    /// The one of these silent modules, in the order of the chain, that has restarted if one of them has;
    /// empty if that is open.
    [[nodiscard]] std::optional<ModuleIndex> restartedOf(const std::vector<ModuleIndex>& silent) const;
    /// Call when the chain's addresses are assigned again: a module that answers may be unchanged, or may
    /// just have been reset and be off, in which case a stop would switch it on. Each module is therefore
    /// queried before it is sent anything; StopTarget::stop() defines what is sent to one that does not
    /// answer.
    void forgetStates();

    /// Builds a request to a module: a command with the retries that the retry table allows (link.md 2.3),
    /// Read Status with `items`, or No Operation. While the defined items are in doubt, the query is Define
    /// Status; on a read-only connection, the standing items are read each time.
    [[nodiscard]] Ask command(Purpose purpose, const Order& order) const;
    [[nodiscard]] Ask status(Purpose purpose, ModuleIndex module, std::optional<StatusItems> items) const;
    /// Builds a query for a status newer than anything sent, with a different length than the last one, so
    /// that two of them permit; or, if the length is unknown, one that makes it known first.
    [[nodiscard]] Ask look(Purpose purpose, ModuleIndex module) const;
    [[nodiscard]] ReplyLayout layoutOf(const Belief& belief, const Payload& payload) const;
    /// Length in bytes of the longest reply that any of the modules can give.
    [[nodiscard]] std::size_t longestReply() const;

    /// Call when the command is sent, with the time at which it will be latched: everything that monitors the
    /// module must allow for it.
    void noteSent(ModuleIndex module, const ModuleCommand& command, TimePoint latched);

    /// Makes a stop owed to the module from now on, unless it has no stop command, or is off because it
    /// restarted. If one is owed already for a cause of its own, that cause is kept, unless a fault is
    /// added to what the operator wanted, and so is its manner if that is firmer, unless the operator wanted
    /// the one and wants the other. On a read-only connection, only a stop of all modules can be owed.
    void owe(ModuleIndex module, StopCause cause, StopManner manner = StopManner::Abruptly);

    /// The module was heard again after a silence: the stop owed to it is due at once.
    void hurryOwedStop(ModuleIndex module, TimePoint now);

    /// The module has its address again after a restart: everything known about it is obsolete.
    void welcome(ModuleIndex module, TimePoint now);

    /// The commands needed to bring everything to rest.
    [[nodiscard]] std::vector<Order> stops() const;
    /// The packets among these stops that take outputs low.
    [[nodiscard]] std::vector<PacketBytes> outputStops() const;
    /// These stops as bytes that need no answer, nulls first, preceded by the previous gains where others are
    /// being tried, because their sender will not be able to restore them later; empty if nothing is on, or
    /// on a read-only connection.
    [[nodiscard]] std::vector<std::uint8_t> stopBurst() const;
    /// Packets for these stops, one for a whole group if it is the same for all members, with the pauses
    /// after them.
    [[nodiscard]] Line::Script stopScript(const std::vector<Order>& stops) const;
    /// The group to which a single packet has the effect of these stops; empty if other modules would obey
    /// it, or not all of these would.
    [[nodiscard]] std::optional<BusAddress> groupOf(const std::vector<Order>& stops) const;

private:
    void addStop(Line::Script& script, BusAddress address, const Payload& payload, std::size_t reply) const;

    std::vector<Module> m_modules;
    std::uint32_t m_rate = kPowerUpBaud;
    bool m_readOnly = false;  ///< never changes; if set, nothing is owed or prepared without a request
    PollSchedule m_schedule;
};

}  // namespace nmc::bus
