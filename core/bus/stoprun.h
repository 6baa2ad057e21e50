// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/stoptarget.h"
#include "bus/types.h"

namespace nmc::bus {

/// A stop of all motors: first all stops that are needed, beginning with moving motors, then two queries of
/// each module. Ends when each module is confirmed or given up. Pure; StopTask sends.
class StopRun {
public:
    /// For the whole run.
    static constexpr Duration kLimit = std::chrono::seconds(2);
    /// A module that answered until now is given up after this long and kSilences consecutive timeouts.
    static constexpr Duration kSilentFor = std::chrono::milliseconds(500);
    static constexpr unsigned kSilences = 3;

    StopRun(const Chain& chain, TimePoint now);
    /// The stop was requested again: every module starts over, within the same time limit.
    void restart(const Chain& chain);

    /// Stops to send without waiting for answers, because a reply is in progress or the link is in doubt.
    [[nodiscard]] std::vector<Order> blindStops(const Chain& chain) const;

    /// The next module to query; null when the run is over.
    [[nodiscard]] StopTarget* next(TimePoint now);
    /// True if no module remains that must, or might have to, be sent a stop.
    [[nodiscard]] bool allSent() const;
    /// The result of the last query.
    void onReply(StopTarget& asked, const ReplyEnd& end, const Belief& belief, TimePoint now);
    /// Returns null for a module that is not part of the run: one that restarted is off and has no address,
    /// and one of unknown type has no stop command.
    [[nodiscard]] StopTarget* find(ModuleIndex module);

    [[nodiscard]] StopFinished finished() const;

private:
    struct Target {
        StopTarget stop;
        bool wasUnresponsive = false;
        bool moving = false;
        bool givenUp = false;
        unsigned asks = 0;
        [[nodiscard]] bool open() const { return !givenUp && !stop.stopped(); }
    };

    TimePoint m_began;
    std::vector<Target> m_targets;
    std::vector<ModuleIndex> m_wereOff;  ///< when the run began
    std::vector<ModuleIndex> m_restarted;
    std::vector<ModuleIndex> m_noStopKnown;
};

}  // namespace nmc::bus
