// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/silence.h"
#include "bus/task.h"

namespace nmc::bus {

/// Tracks whether the line is trusted, and the way back after a doubt (link.md 2.2): a quarantine longer than
/// the latest late reply, nulls, and a challenge of two queries to the module in doubt. A module that fails
/// it is lost and polled rarely; if no module answers, the line is lost. Also keeps the health of the link
/// (link.md 2.5).
///
/// As a task, it runs the way back; a stop takes precedence, and uses only the nulls (flush()).
class Recovery : public Task {
public:
    Recovery(const Shared& shared, LinkStatistics& statistics) : Task(shared), m_statistics(statistics) {}

    /// Call for another chain, or another search for it: there is no evidence against the line.
    void reset();

    // ---- evidence against the line ----

    /// An exchange ended without a right answer. Returns what must follow at once, if anything.
    [[nodiscard]] Line::Script onUnanswered(const Ask& ask, const ReplyEnd& end);
    /// A silent module answered a poll: it must prove its identity.
    void onHeardAgain(ModuleIndex module) { m_doubt = Doubt{module, true}; }
    /// Call after an event such as a suspend of the computer: everything is in doubt.
    void distrust();
    /// A byte was received.
    void onByte() { m_silence.heard(); }
    /// Another host was sending, or nothing was sent for long: nulls must precede anything that must be
    /// received.
    void doubtLine() { m_state = LineState::Suspect; }
    /// Nulls were sent with something else; the quarantine must still follow.
    void flushed() { m_state = LineState::NullsSent; }

    [[nodiscard]] bool resyncing() const { return m_state == LineState::Resyncing; }
    /// Nulls alone were sent ahead of something urgent: a reply may still be a late one to an earlier query.
    [[nodiscard]] bool quarantineDue() const { return m_state == LineState::NullsSent; }
    /// A resync is due or in progress, or something is in doubt.
    [[nodiscard]] bool suspect() const { return m_state != LineState::Trusted || m_lost || m_doubt; }
    /// For tasks that do not wait: the nulls that empty partly filled command buffers, if needed. The wait
    /// for late answers follows afterwards.
    [[nodiscard]] std::optional<Line::Script> flush();
    /// Nothing is in progress any more: the line is free.
    void onFree() {
        if (resyncing())
            m_state = LineState::Trusted;
    }

    // ---- health ----

    struct GivenUp {
        std::optional<ModuleIndex> module;  ///< the whole link, if empty
    };
    /// An exchange went right or wrong. Returns what must be given up as a result.
    [[nodiscard]] std::vector<GivenUp> note(ModuleIndex module, bool right);
    /// The module is not queried any more.
    void dropDoubt(ModuleIndex module);
    void dropDoubt() { m_doubt.reset(); }
    /// The module that failed its challenge last had been answering until then.
    [[nodiscard]] bool lostAnswering() const { return m_lostAnswering; }
    /// The module was found elsewhere not to answer: it is silent from now on, and reported as such.
    void lose(ModuleIndex module, TimePoint now);

    // ---- results of the way back, for the engine ----

    struct Findings {
        std::optional<ModuleIndex> lost;  ///< it failed a challenge
        bool allLost = false;             ///< no module answers any more
        std::vector<GivenUp> givenUp;
    };
    [[nodiscard]] Findings takeFindings() { return std::exchange(m_findings, {}); }

    // ---- Task ----
    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    /// The chart of its transitions is in link.md 2.2.
    enum class LineState : std::uint8_t {
        Trusted,
        Suspect,    ///< a resync is due
        NullsSent,  ///< nulls alone were sent ahead of the resync: the quarantine must still follow
        Resyncing,
    };
    /// A module whose last answer was wrong or missing: two right ones, of different length, resolve the
    /// doubt.
    struct Doubt {
        ModuleIndex module;
        bool wasUnresponsive = false;
        unsigned passed = 0;
        unsigned failures = 0;
        unsigned silences = 0;  ///< of them
        bool bySilence = false;
        bool witnessDue = false;  ///< another module is queried first, to verify that the bus works at all
        bool witness = false;     ///< that query is in progress
    };

    [[nodiscard]] bool resyncDue() const {
        return m_state == LineState::Suspect || m_state == LineState::NullsSent;
    }
    [[nodiscard]] Line::Script resync();
    [[nodiscard]] Ask challenge();
    [[nodiscard]] std::optional<ModuleIndex> witness() const;
    void passed(ModuleIndex module, TimePoint now);
    void failed(ModuleIndex module, TimePoint now);
    void setUnresponsive(ModuleIndex module, TimePoint now);
    void loseAll(TimePoint now);

    LinkStatistics& m_statistics;
    LineState m_state = LineState::Trusted;
    Duration m_quarantine = kMinQuarantine;
    std::optional<Doubt> m_doubt;
    Silence m_silence;
    bool m_lost = false;  ///< all modules are silent, since loseAll(), until one passes its challenge
    bool m_lostAnswering = false;  ///< see lostAnswering()
    bool m_givenUp = false;        ///< until reset(): LinkLost is not reported any more
    Health m_health;               ///< of the whole link
    Findings m_findings;
};

}  // namespace nmc::bus
