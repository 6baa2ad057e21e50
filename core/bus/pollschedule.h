// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"

namespace nmc::bus {

/// Who is asked next, and for what. Modules take turns; one that is silent is asked ever more rarely, so that
/// its time-outs cost the others little. Pure.
class PollSchedule {
public:
    /// Time-outs in a row that make a module silent.
    static constexpr unsigned kSilentAfter = 3;
    /// A full status instead of the short one, for velocity, home and identity.
    static constexpr unsigned kFullEvery = 8;
    /// First and longest time between two questions to a silent module.
    static constexpr Duration kFirstProbe = std::chrono::seconds(1);
    static constexpr Duration kSlowestProbe = std::chrono::seconds(4);
    /// Between questions to any of them: a time-out takes 30 to 55 ms, which leaves 90 % to those that
    /// answer.
    static constexpr Duration kProbeSpacing = std::chrono::milliseconds(600);

    struct Turn {
        ModuleIndex module;
        bool full = false;
    };

    explicit PollSchedule(std::size_t modules = 0) : m_modules(modules) {}

    /// Whose turn it is; nothing when only silent modules are left and none is due.
    [[nodiscard]] std::optional<Turn> next(TimePoint now);
    /// When next() will have something, if it has nothing before.
    [[nodiscard]] std::optional<TimePoint> nextDue() const;

    /// Returns true when this changed the module's silence.
    bool onAnswer(ModuleIndex module, TimePoint now);
    bool onTimeout(ModuleIndex module, TimePoint now);

    [[nodiscard]] bool silent(ModuleIndex module) const { return m_modules[module.value()].silent; }
    [[nodiscard]] std::size_t answering() const;
    [[nodiscard]] bool allSilent() const { return !m_modules.empty() && answering() == 0; }

private:
    struct Module {
        unsigned turns = 0;
        unsigned timeouts = 0;  ///< in a row
        bool silent = false;
        Duration interval{};
        TimePoint due;
    };

    [[nodiscard]] TimePoint dueTime(const Module& module) const;

    std::vector<Module> m_modules;
    std::size_t m_next = 0;
    std::optional<TimePoint> m_lastProbe;
};

}  // namespace nmc::bus
