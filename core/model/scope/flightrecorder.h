// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "model/scope/history.h"

namespace nmc {

/// Keeps what all modules said around a fault or a stop, so that it can still be looked at when the history
/// has gone on, or the connection has ended. Pure; one thread.
class FlightRecorder {
public:
    static constexpr Duration kBefore = std::chrono::seconds(5);
    static constexpr Duration kAfter = std::chrono::seconds(2);
    /// Incidents; the oldest make room.
    static constexpr std::size_t kKept = 20;

    struct Incident {
        std::string key;  ///< of the message that tells of it
        std::optional<ModuleIndex> module;
        TimePoint at;
        History history{};
        bool whole = false;  ///< nothing more will come
    };

    /// Something happened; `at` as in a sample. The same key again takes the place of the incident before.
    void note(std::string key, std::optional<ModuleIndex> module, TimePoint at);
    /// Takes what belongs to each incident whose time is over. Cheap when there is none; at least once a
    /// second.
    void keep(const History& history, TimePoint now);
    /// The history ends here.
    void keepAll(const History& history);
    /// With what there is so far; null if it is not known, or has made room.
    [[nodiscard]] const Incident* find(const std::string& key, const History& history);

private:
    static void take(Incident& incident, const History& history);

    std::deque<Incident> m_incidents;
};

}  // namespace nmc
