// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus/types.h"
#include "tests/sessions/wire.h"

namespace nmc::test {

class Rig;

/// What must be true of every stop of all motors, whatever precedes it and whatever accompanies it.
///
///  ends      exactly one StopFinished for each run of a stop, within kStopBound after the last request if a
///            chain is known, otherwise within the length of a search (issue 13, item 1)
///  lists     each module of the last known chain is in exactly one of the three lists (item 2)
///  rest      a module reported as stopped is at rest, and remains so; a module that hears is at rest within
///            kStopBound (item 2, "Tests")
///  answered  a module reported as stopped has answered twice since the stop was requested (item 4)
///  told      each module that is on and hears is sent a stop at once, at the known rate of the chain,
///            and after nulls if the link was not well (item 1)
///  heard     on a line that is well, a module that hears and has not just been reset is confirmed
///  N1        nothing that moves, enables, tunes or renames is sent after a stop (faults.md N1, N2)
class StopOath {
public:
    /// Counted from the last stopAll(), if a chain is known.
    static constexpr Duration kStopBound = std::chrono::milliseconds(2'500);
    /// The longest search, with an adapter of 16 ms: 34 addresses at four rates, twice, of 46 ms each (12.5
    /// s); then, if a module without an address answers, up to eight known addresses at four rates, three
    /// times, and the last time 50 ms longer (6 s); usual places again, and owed stops all the while, which
    /// take a sixth of the time.
    static constexpr Duration kSearchBound = std::chrono::seconds(27);
    /// How long a module that was reported as stopped is watched.
    static constexpr Duration kWatched = std::chrono::seconds(2);

    explicit StopOath(Rig& rig) : m_rig(&rig) {}

    void asked();
    void onTime();
    void onSent(const WireItem& item);
    void onFinished(const bus::StopFinished& event);
    void onChainFound();
    /// The engine has a reason of its own to stop everything: one more StopFinished is in order.
    void stopsByItself();
    /// The operator moves a motor again, or something else does: what was reported before no longer applies.
    void forget();
    /// Another engine takes over.
    void reset() { *this = StopOath(*m_rig); }

    [[nodiscard]] bool running() const { return m_run.has_value(); }

private:
    struct Module {
        std::uint8_t place = 0;
        std::uint8_t address = 0;
        bool on = false;
        bool hears = false;
    };
    struct Run {
        TimePoint began;
        TimePoint asked;
        TimePoint inFlight;  ///< until then, the packet before it is on its way
        std::size_t wireFrom = 0;
        bool chainKnown = false;
        bool well = false;       ///< the link is well, as far as the engine can know
        bool calm = false;       ///< nothing has been wrong with the line for a while
        bool reset = false;      ///< the network is being restarted: modules forget what they did
        bool judgeWire = false;  ///< the rate of the chain is certain, and no other stop is under way
        std::uint32_t baud = 0;
        std::uint32_t hostBaud = 0;
        std::vector<Module> modules;
        std::vector<std::uint64_t> replies;  ///< by place
    };
    struct Watched {
        std::uint8_t place;
        double shaft;
        TimePoint until;
    };

    [[nodiscard]] bool restarting() const;
    void checkEnd(const Run& run);
    void checkLists(const bus::StopFinished& event);
    void checkStopped(const bus::StopFinished& event, const std::optional<Run>& run);
    void checkTold(const Run& run);
    void checkRest(const Run& run);
    void checkWatched();
    [[nodiscard]] TimePoint firstDue(const Run& run) const;
    [[nodiscard]] const WireItem* stopTo(const Run& run, const Module& module) const;
    [[nodiscard]] bool nullsBefore(const Run& run, const WireItem& stop) const;

    Rig* m_rig;
    std::optional<Run> m_run;
    std::optional<Run> m_resting;  ///< the modules of this run have to be at rest soon
    TimePoint m_restDue{};
    bool m_overdue = false;
    bool m_forbidden = false;  ///< N1 holds: nothing has been requested since the stop
    bool m_rateWasChanging = false;
    unsigned m_ownStops = 0;
    std::vector<Watched> m_watched;
    TimePoint m_nextLook{};
};

}  // namespace nmc::test
