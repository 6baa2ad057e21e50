// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>

#include "model/scope/history.h"

namespace nmc {

/// Keeps the samples of all modules around a fault or a stop, so that they can still be examined after the
/// history has moved on, or the connection has ended. Pure; one thread.
class FlightRecorder {
public:
    static constexpr Duration kBefore = std::chrono::seconds(5);
    static constexpr Duration kAfter = std::chrono::seconds(2);
    /// Number of incidents kept; the oldest are discarded.
    static constexpr std::size_t kKept = 20;

    struct Incident {
        unsigned number;
        std::optional<ModuleIndex> module;
        TimePoint at;
        History history{};
        bool whole = false;  ///< complete, no more samples will be added
    };

    /// Notes an incident; `at` is a sample time. Returns its number, from 1 on. Takes what has led to it at
    /// once: within two seconds, a search may find another chain, whose history starts from the beginning.
    unsigned note(std::optional<ModuleIndex> module, TimePoint at, const History& history);
    /// Takes the samples of each incident whose time is over. Cheap when there is none; call at least once a
    /// second.
    void keep(const History& history, TimePoint now);
    /// Called when the history ends.
    void keepAll(const History& history);
    /// Returns an incident with the samples available so far; null if it is unknown or has been discarded.
    [[nodiscard]] const Incident* find(unsigned number, const History& history);

private:
    /// Leaves the incident as it is if the history is that of another chain.
    static void take(Incident& incident, const History& history);

    std::deque<Incident> m_incidents;
    unsigned m_noted = 0;
};

}  // namespace nmc
