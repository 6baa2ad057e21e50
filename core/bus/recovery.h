// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/silence.h"
#include "bus/task.h"

namespace nmc::bus {

/// How far the line is trusted, and the way back after a doubt (link.md 2.2): a quarantine longer than the
/// latest late reply, nulls, and a challenge of two questions to the module in doubt. A module that fails it
/// is lost and asked rarely; when nobody answers, the line is. Keeps the health of the link, too
/// (link.md 2.5).
///
/// Its task is the way back; a stop goes before it, and takes the nulls alone (flush()).
class Recovery : public Task {
public:
    Recovery(Chain& chain, Line& line, std::vector<Event>& events)
        : m_chain(chain), m_line(line), m_events(events) {}

    /// Another chain, or another look for it: nothing is known against the line.
    void reset();

    // ---- what speaks against the line ----

    /// An exchange ended without a right answer. What is to follow at once, if anything.
    [[nodiscard]] Line::Script onUnanswered(const Ask& ask, const ReplyEnd& end);
    /// A silent module answered a poll: it has to show who it is.
    void onHeardAgain(ModuleIndex module) { m_doubt = Doubt{module, true}; }
    /// Something happened to this machine: everything is in doubt.
    void distrust();
    /// A byte came in.
    void onByte() { m_silence.heard(); }
    /// Somebody else was talking, or nobody has for long: nulls before anything that must be heard.
    void doubtLine() { m_state = LineState::Suspect; }
    /// Nulls went out with something else; the quarantine is still due.
    void flushed() { m_state = LineState::NullsSent; }

    [[nodiscard]] bool resyncing() const { return m_state == LineState::Resyncing; }
    /// A resync is due or under way, or something is in doubt.
    [[nodiscard]] bool suspect() const { return m_state != LineState::Trusted || m_lost || m_doubt; }
    /// Nobody answers.
    [[nodiscard]] bool lost() const { return m_lost; }
    /// For what does not wait: nulls that empty half-filled command buffers, where they are needed. Late
    /// answers are waited for afterwards.
    [[nodiscard]] std::optional<Line::Script> flush();
    /// Whatever ran is over: the line is free.
    void onFree() {
        if (resyncing())
            m_state = LineState::Trusted;
    }

    // ---- health ----

    struct GivenUp {
        std::optional<ModuleIndex> module;  ///< the whole link, if none
    };
    /// An exchange went right or wrong. What has to be given up because of it.
    [[nodiscard]] std::vector<GivenUp> note(ModuleIndex module, bool right);
    /// The module is not asked any more.
    void dropDoubt(ModuleIndex module);
    void dropDoubt() { m_doubt.reset(); }
    /// It does not answer, as somebody else has found out: it is silent from now on, and told of as that.
    void lose(ModuleIndex module, TimePoint now);

    // ---- what the way back has shown, for the engine ----

    struct Findings {
        std::optional<ModuleIndex> lost;  ///< it failed a challenge
        bool allLost = false;             ///< nobody answers any more
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
        NullsSent,  ///< something went ahead of the resync with nulls only: the quarantine is still due
        Resyncing,
    };
    /// A module whose last answer was wrong or missing: two right ones, of different length, end that.
    struct Doubt {
        ModuleIndex module;
        bool wasUnresponsive = false;
        unsigned passed = 0;
        unsigned failures = 0;
        unsigned silences = 0;  ///< of them
        bool bySilence = false;
        bool witnessDue = false;  ///< first somebody else is asked whether the bus is there at all
        bool witness = false;     ///< that is the question under way
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

    Chain& m_chain;
    Line& m_line;  ///< its timing, and its statistics
    std::vector<Event>& m_events;
    LineState m_state = LineState::Trusted;
    Duration m_quarantine = kMinQuarantine;
    std::optional<Doubt> m_doubt;
    Silence m_silence;
    bool m_lost = false;     ///< all are silent, since loseAll(); until one passes its challenge
    bool m_givenUp = false;  ///< until reset(): LinkLost is not told any more
    Health m_health;         ///< of the whole link
    Findings m_findings;
};

}  // namespace nmc::bus
