// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/stoprun.h"
#include "bus/task.h"

namespace nmc::bus {

/// The stop of all motors, at the chain's known rate: first stops that need no answer, then queries until
/// each module is confirmed or given up. If no module is known yet, it waits for the search. Ends in exactly
/// one StopFinished; what is not confirmed is owed from then on.
class StopTask : public Task {
public:
    StopTask(Chain& chain, Recovery& recovery, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_recovery(recovery), m_line(line), m_events(events) {}

    /// Stops the chain; if a stop is in progress, every module starts over.
    void begin(TimePoint now);
    /// No module is known yet: the stop begins when the search is over.
    void beginAfterSearch(TimePoint now);
    /// The stop begun last was not requested by the user.
    void noteUnasked() { m_unasked = true; }
    /// The search is over; the chain is what it has found, or what it was.
    void onSearchOver(TimePoint now);

    [[nodiscard]] bool active() const { return m_run || m_waiting; }
    [[nodiscard]] bool running() const { return m_run.has_value(); }
    [[nodiscard]] bool waits() const { return m_waiting; }
    /// Each module has been sent its stop; what remains is to see them at rest.
    [[nodiscard]] bool allSent() const;

    /// The stops to be sent blindly, for a caller that sends them itself and then calls onBlindSent().
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
    TimePoint m_pressed;         ///< time of the first request that this stop answers
    bool m_waiting = false;      ///< for the search
    bool m_unasked = false;      ///< StopFinished::unasked
    bool m_blindDue = false;     ///< blindScript() must be sent first; set once per begin()
    std::vector<Order> m_blind;  ///< in progress
    bool m_blindHeard = false;   ///< the link was not in doubt when they were sent
    StopTarget* m_asked = nullptr;
};

}  // namespace nmc::bus
