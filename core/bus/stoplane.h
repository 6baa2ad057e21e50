// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// Sends the stops that are owed to modules (Chain::Module::owed), each for its own cause, before anything
/// else. A stop is repeated while the module continues to move, blindly and indefinitely while it does not
/// answer, and at once when it is heard again. Only a confirmation ends it, or a start that the user requests
/// after the end of a hold.
///
/// A stop of all modules owes one to each of them, and does not pause: first all stops that are needed,
/// beginning with moving motors, then two queries of each module. It ends in exactly one StopFinished, when
/// each module is confirmed or given up; what is not confirmed remains owed.
class StopLane : public Task {
public:
    /// For the whole stop of all modules.
    static constexpr Duration kLimit = std::chrono::seconds(2);

    StopLane(const Shared& shared, Recovery& recovery) : Task(shared), m_recovery(recovery) {}

    // ---- stops of all modules, at the chain's known rate ----

    /// Stops the chain; if a stop is in progress, every module starts over, within the same time limit.
    void stopAll(TimePoint now);
    /// No module is known yet: the stop begins when the search is over.
    void stopAllAfterSearch(TimePoint now);
    /// The stop requested last was not requested by the user.
    void noteUnasked() { m_unasked = true; }

    [[nodiscard]] bool stopping() const { return m_run || m_waiting; }
    [[nodiscard]] bool running() const { return m_run.has_value(); }
    [[nodiscard]] bool waits() const { return m_waiting; }
    /// Each module has been sent its stop; what remains is to see them at rest.
    [[nodiscard]] bool allSent() const;

    /// The stops to be sent blindly, of all modules or else those of single ones that have not been sent, for
    /// a caller that sends them itself and then calls onBlindSent().
    [[nodiscard]] std::vector<Order> blindStops() const;
    void onBlindSent();

    // ---- stops of single modules ----

    /// These modules are owed their stops in the same tick: one packet to their group is sent first, if it is
    /// the same for all. After that, each is sent its stop and queried by itself.
    void sendTogether(std::vector<ModuleIndex> modules) { m_together = std::move(modules); }
    /// A stop is due that has not been sent yet to a module that answers.
    [[nodiscard]] bool anyUnsent(TimePoint now) const;

    /// The chain is being searched for: queries would interfere, so the stops of single modules are sent
    /// blindly.
    void onSearchBegun() {
        m_searching = true;
        onRenumbering();
    }
    /// The modules are about to get other numbers.
    void onRenumbering() {
        noteBlindStops();
        m_together.clear();
    }
    /// The chain is what the search has found, or what it was.
    void onSearchOver(TimePoint now);

    // ---- Task ----
    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    void onAnswer(const Ask& ask, const ReplyEnd& end) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override;

private:
    /// A module in a stop of all modules.
    struct Member {
        ModuleIndex module;
        bool wasUnresponsive = false;
        bool moving = false;
        bool givenUp = false;
        unsigned asks = 0;
    };
    /// A stop of all modules in progress.
    struct Run {
        TimePoint began;
        std::vector<Member> members{};
        std::vector<ModuleIndex> wereOff{};  ///< when it began
    };

    [[nodiscard]] StopTarget& target(const Member& member) { return m_chain.at(member.module).owed->target; }
    [[nodiscard]] const StopTarget& target(const Member& member) const {
        return m_chain.at(member.module).owed->target;
    }
    void begin(TimePoint now);
    [[nodiscard]] Next nextOfAll(TimePoint now);
    void onEndOfAll(ModuleIndex module, TimePoint now);
    void finish(TimePoint now);

    [[nodiscard]] bool open(const Member& member) const;
    [[nodiscard]] bool blindly(ModuleIndex module) const;
    [[nodiscard]] Next nextOwed(TimePoint now);
    [[nodiscard]] Next blindScript(TimePoint now);
    [[nodiscard]] Line::Script groupScript();
    void giveWay(TimePoint now);

    [[nodiscard]] Line::Script scriptFor(const std::vector<Order>& stops, bool nulls,
                                         Duration underWay = {}) const;
    void noteBlindStops();

    Recovery& m_recovery;

    std::optional<Run> m_run;
    TimePoint m_pressed;      ///< time of the first request that the stop of all modules answers
    bool m_waiting = false;   ///< a stop of all modules waits for the search
    bool m_unasked = false;   ///< StopFinished::unasked
    bool m_blindDue = false;  ///< the stop of all modules begins with a script; set once per stopAll()

    bool m_searching = false;
    std::vector<ModuleIndex> m_together;
    /// Sent in the last script, whose latch times are not noted yet.
    std::vector<Order> m_sentBlind;
    bool m_blindHeard = false;  ///< the link was not in doubt when they were sent
};

}  // namespace nmc::bus
