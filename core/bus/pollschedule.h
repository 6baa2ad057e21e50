// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"

namespace nmc::bus {

/// Who is asked next, and in which layout. Modules that somebody looks at take every other turn, the rest
/// share what is between, and each of these is asked at least five times a second as long as the wire allows.
/// A silent module is asked ever more rarely, so that its time-outs cost the others little. For a few seconds
/// one module can have nearly every turn. Pure.
class PollSchedule {
public:
    /// A module that nobody looks at is asked at least this often, as the wire allows.
    static constexpr Duration kBackground = std::chrono::milliseconds(180);
    /// First and longest time between two questions to a silent module.
    static constexpr Duration kFirstProbe = std::chrono::seconds(1);
    static constexpr Duration kSlowestProbe = std::chrono::seconds(4);
    /// Between questions to any of them: a time-out takes 30 to 70 ms, which leaves 90 % to those that
    /// answer.
    static constexpr Duration kProbeSpacing = std::chrono::milliseconds(1000);

    /// A module in focus leaves the others so much: each is asked once in that time, as the wire allows.
    static constexpr Duration kInSight = std::chrono::milliseconds(900);
    /// A focus that nobody ends is over by then.
    static constexpr Duration kFocus = std::chrono::seconds(5);

    struct Turn {
        ModuleIndex module;
        /// Every second time in full: layouts of different length take turns (link.md 2.2).
        bool full = false;
        /// In focus, instead of in full: with the position only.
        bool brief = false;
    };

    explicit PollSchedule(std::size_t modules = 0) : m_modules(modules) {}

    /// Those that somebody looks at; the others only need to be kept in sight. None: all alike.
    void watch(const std::vector<ModuleIndex>& modules);

    /// From `now` on this module takes every turn but those that keep the others in sight, however often that
    /// is asked for; silent ones are not asked. Ends after kFocus, or when the module falls silent.
    void focus(ModuleIndex module, TimePoint now);
    void unfocus() { m_focus.reset(); }

    /// Whose turn it is; nothing when only silent modules are left and none is due.
    [[nodiscard]] std::optional<Turn> next(TimePoint now);
    /// When next() will have something, if it has nothing before.
    [[nodiscard]] std::optional<TimePoint> nextDue() const;

    /// It does not answer, and is asked rarely from now on.
    void lose(ModuleIndex module, TimePoint now);
    /// A silent module did not answer again.
    void onTimeout(ModuleIndex module, TimePoint now);
    /// A silent module answers again.
    void recover(ModuleIndex module, TimePoint now);
    /// It is not asked any more, until it recovers.
    void retire(ModuleIndex module) { at(module).retired = true; }

    [[nodiscard]] bool silent(ModuleIndex module) const { return m_modules[module.value()].silent; }
    [[nodiscard]] bool retired(ModuleIndex module) const { return m_modules[module.value()].retired; }
    [[nodiscard]] std::size_t answering() const;
    [[nodiscard]] bool allUnresponsive() const { return !m_modules.empty() && answering() == 0; }

private:
    struct Module {
        bool full = false;
        bool watched = false;
        bool silent = false;
        bool retired = false;
        std::uint64_t order = 0;  ///< of its last turn
        std::optional<TimePoint> asked;
        Duration interval{};
        TimePoint due;
    };

    struct Focus {
        std::size_t module = 0;
        TimePoint until;
        TimePoint othersAsked;
    };

    [[nodiscard]] Module& at(ModuleIndex module) { return m_modules[module.value()]; }
    [[nodiscard]] Turn take(std::size_t index, TimePoint now);
    [[nodiscard]] Turn nextInFocus(TimePoint now);
    [[nodiscard]] TimePoint dueTime(const Module& module) const;
    [[nodiscard]] std::optional<std::size_t> silentTurn(TimePoint now) const;
    template <typename Wanted>
    [[nodiscard]] std::optional<std::size_t> longestAgo(Wanted wanted) const;

    std::vector<Module> m_modules;
    std::optional<TimePoint> m_lastProbe;
    std::optional<Focus> m_focus;
    bool m_backgroundLast = false;  ///< the last turn was theirs, so the next one is not
    std::uint64_t m_turns = 0;
};

}  // namespace nmc::bus
