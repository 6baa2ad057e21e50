// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/stoprun.h"
#include "bus/task.h"

namespace nmc::bus {

/// The stop of all motors, at the rate at which the chain was known: first stops that need no answer, then
/// questions until each module is confirmed or given up. Where nobody is known yet it waits for the search.
/// Ends in exactly one StopFinished; what is not confirmed is owed from then on.
class StopTask : public Task {
public:
    StopTask(Chain& chain, Recovery& recovery, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_recovery(recovery), m_line(line), m_events(events) {}

    /// Stops the chain, or looks at everything anew when that is under way.
    void begin(TimePoint now);
    /// Nobody is known yet who could be told: as soon as the search is over.
    void beginAfterSearch(TimePoint now);
    /// The operator did not ask for the stop that was begun last.
    void noteUnasked() { m_unasked = true; }
    /// The search is over; the chain is what it has found, or what it was.
    void onSearchOver(TimePoint now);

    [[nodiscard]] bool active() const { return m_run || m_waiting; }
    [[nodiscard]] bool running() const { return m_run.has_value(); }
    [[nodiscard]] bool waits() const { return m_waiting; }
    /// Each module has been told; what is left is to see them at rest.
    [[nodiscard]] bool allSent() const;

    /// The stops to send blindly, for somebody who sends them himself, and that he did.
    [[nodiscard]] std::vector<Order> blindStops() const;
    void onBlindSent();

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return running(); }
    [[nodiscard]] Next next(TimePoint now) override;
    void onAnswer(const Ask& ask, const ReplyEnd& end) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    [[nodiscard]] Line::Script blindScript();
    void noteBlindStops();
    void finish(TimePoint now);

    Chain& m_chain;
    Recovery& m_recovery;
    const Line& m_line;
    std::vector<Event>& m_events;
    std::optional<StopRun> m_run;
    TimePoint m_pressed;         ///< the first of those that this stop answers
    bool m_waiting = false;      ///< for the search
    bool m_unasked = false;      ///< StopFinished::unasked
    bool m_blindDue = false;     ///< what next() does first, once a begin()
    std::vector<Order> m_blind;  ///< under way
    bool m_blindHeard = false;   ///< the link was not in doubt when they went out
    StopTarget* m_asked = nullptr;
};

}  // namespace nmc::bus
