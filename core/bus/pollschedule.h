// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"

namespace nmc::bus {

/// Decides which module is polled next, and in which layout. Watched modules get every other turn; the others
/// share the rest, each at least five times a second if the line allows it. A silent module is polled ever
/// more rarely, so that its timeouts cost the others little. For a few seconds, one module can have nearly
/// every turn. Pure.
class PollSchedule {
public:
    /// A module that is not watched is polled at least this often, if the line allows it.
    static constexpr Duration kBackground = std::chrono::milliseconds(180);
    /// First and longest time between two queries of a silent module.
    static constexpr Duration kFirstProbe = std::chrono::seconds(1);
    static constexpr Duration kSlowestProbe = std::chrono::seconds(4);
    /// Time between queries of any silent modules: a timeout takes 30 to 70 ms, which leaves 90 % to those
    /// that answer.
    static constexpr Duration kProbeSpacing = std::chrono::milliseconds(1000);

    /// While a module is in focus, each of the others is polled once in this time, if the line allows it.
    static constexpr Duration kInSight = std::chrono::milliseconds(900);
    /// A focus ends after this time at the latest.
    static constexpr Duration kFocus = std::chrono::seconds(5);

    struct Turn {
        ModuleIndex module;
        /// Every second poll is a full one: layouts of different length alternate (link.md 2.2).
        bool full = false;
        /// In focus, instead of a full poll: with the position only.
        bool brief = false;
    };

    explicit PollSchedule(std::size_t modules = 0) : m_modules(modules) {}

    /// The modules on display; the others only need occasional polls. Empty: all are treated equally.
    void watch(const std::vector<ModuleIndex>& modules);

    /// From `now` on, this module gets every turn, except for the occasional polls of the others, no matter
    /// how often this is called; silent modules are not polled. Ends after kFocus, or when the module falls
    /// silent.
    void focus(ModuleIndex module, TimePoint now);
    void unfocus() { m_focus.reset(); }

    /// The next turn; empty if only silent modules are left and none is due.
    [[nodiscard]] std::optional<Turn> next(TimePoint now);
    /// When next() will return a turn, if it returns none before.
    [[nodiscard]] std::optional<TimePoint> nextDue() const;

    /// The module does not answer, and is polled rarely from now on.
    void lose(ModuleIndex module, TimePoint now);
    /// A silent module did not answer again.
    void onTimeout(ModuleIndex module, TimePoint now);
    /// A silent module is queried as soon as kProbeSpacing allows.
    void hurry(ModuleIndex module, TimePoint now) { at(module).due = std::min(at(module).due, now); }
    /// A silent module answers again.
    void recover(ModuleIndex module, TimePoint now);
    /// No module without an address answered, so none of those that are silent now has restarted.
    void noteSought() {
        for (Module& module : m_modules)
            module.sought = module.silent;
    }
    /// The same was found of this one before.
    void noteSought(ModuleIndex module) { at(module).sought = true; }
    /// It had not restarted when it was looked for, and has been silent since.
    [[nodiscard]] bool sought(ModuleIndex module) const { return m_modules[module.value()].sought; }
    /// The module is not polled any more, until it recovers. It has answered until now, or is known to have
    /// restarted.
    void retire(ModuleIndex module) { at(module).retired = at(module).sought = true; }

    [[nodiscard]] bool silent(ModuleIndex module) const { return m_modules[module.value()].silent; }
    [[nodiscard]] bool retired(ModuleIndex module) const { return m_modules[module.value()].retired; }
    [[nodiscard]] std::size_t answering() const;
    [[nodiscard]] bool allUnresponsive() const { return !m_modules.empty() && answering() == 0; }

private:
    struct Module {
        bool full = false;
        bool watched = false;
        bool silent = false;
        bool sought = false;
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
    bool m_backgroundLast = false;  ///< the last turn was a background one, so the next one is not
    std::uint64_t m_turns = 0;
};

}  // namespace nmc::bus
