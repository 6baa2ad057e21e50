// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/stoptarget.h"
#include "bus/types.h"

namespace nmc::bus {

/// One stop of all motors: every stop that is needed first, those that move before the others, then two looks
/// at each module. Ends when each is confirmed or given up. Pure; StopTask sends.
class StopRun {
public:
    /// For the whole run.
    static constexpr Duration kLimit = std::chrono::seconds(2);
    /// A module that answered until now is given up after this long and kSilences time-outs in a row.
    static constexpr Duration kSilentFor = std::chrono::milliseconds(500);
    static constexpr unsigned kSilences = 3;

    StopRun(const Chain& chain, TimePoint now);
    /// Asked for again: look at everything anew; the time limit stays.
    void restart(const Chain& chain);

    /// Stops to send without waiting for answers, because an answer is under way or the link is in doubt.
    [[nodiscard]] std::vector<Order> blindStops(const Chain& chain) const;

    /// Whom to ask now; nothing when the run is over.
    [[nodiscard]] StopTarget* next(TimePoint now);
    /// Nobody is left who would have to be told, or might.
    [[nodiscard]] bool allSent() const;
    /// The module that was asked did not answer, or did.
    void onReply(StopTarget& asked, const ReplyEnd& end, const Belief& belief, TimePoint now);
    /// Nothing for a module that is not in it: one that restarted is off, and has no address; one of an
    /// unknown type can't be told.
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
    std::vector<ModuleIndex> m_wereOff;  ///< when it began
    std::vector<ModuleIndex> m_restarted;
    std::vector<ModuleIndex> m_noStopKnown;
};

}  // namespace nmc::bus
