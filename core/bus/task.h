// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "bus/exchange.h"
#include "bus/exchangerecord.h"
#include "bus/line.h"
#include "bus/types.h"

namespace nmc::bus {

/// How long late answers are waited for when nobody answered.
enum class Quarantine : std::uint8_t {
    None,   ///< silence is what is expected
    Brief,  ///< a late answer does no harm
    Full,
};

/// One exchange that a task wants, with the repeats it grants.
struct Ask {
    Purpose purpose = Purpose::Poll;
    std::optional<ModuleIndex> module{};  ///< none while the chain is being looked for
    Request request{};
    std::optional<ModuleCommand> command{};  ///< what to believe when it is carried out
    std::uint8_t silentRepeats = 0;
    bool repeatAtOnce = false;                 ///< after nulls only: a stop does not wait for late answers
    std::uint8_t refusedAttempts = 3;          ///< in total
    std::uint8_t refusedBefore = 0;            ///< in earlier asks for the same
    Quarantine quarantine = Quarantine::Full;  ///< after silence
    bool retry = false;                        ///< the same has been asked before in vain
    bool reported = false;                     ///< the model follows it when it is carried out
    bool believed = true;                      ///< what is answered is taken for the state of the module
    bool handlesFailure =
        false;  ///< the task sees to silence and wrong answers by itself: no repeat, no recovery
};

/// What a task wants of the line.
struct Idle {};
struct Again {};  ///< it did something that needs no line: everybody is asked anew
using Next = std::variant<Idle, Again, Line::Script, Ask>;

/// Something that every task may have to give way to.
struct Change {
    enum class Kind : std::uint8_t {
        StopAll,      ///< every motor is stopped, whatever it was set in motion by
        Search,       ///< the chain is searched for again
        GivenUp,      ///< the link is given up: only stops are sent from now on
        Cancelled,    ///< nothing that was requested so far goes on
        Taken,        ///< `modules` are stopped
        Interrupted,  ///< what was on the line was dropped, and its answer never comes
    };
    Kind kind;
    std::vector<ModuleIndex> modules{};  ///< of Taken

    /// Whatever was requested, of any module, is over.
    [[nodiscard]] bool cancelsAll() const {
        return kind == Kind::StopAll || kind == Kind::Search || kind == Kind::GivenUp ||
               kind == Kind::Cancelled;
    }
};

/// One thing that the engine is about: a stop, a search, an operation, polls. The engine asks its tasks in a
/// fixed order (engine.cpp) what they want of the line, puts that on it, and brings back what came of it. A
/// task never touches the line by itself. Pure.
class Task {
public:
    Task() = default;
    virtual ~Task() = default;
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    /// It has something to do now, before those behind it. Changes nothing.
    [[nodiscard]] virtual bool wants(TimePoint now) const = 0;
    /// What it may ask while the reply before may still turn out to have surplus bytes.
    [[nodiscard]] virtual bool pipelines() const { return false; }
    /// The line is free, and nobody before it wants it.
    [[nodiscard]] virtual Next next(TimePoint now) = 0;
    /// Its exchange was answered, before what the answer says is shown.
    virtual void onAnswer(const Ask&, const ReplyEnd&) {}
    /// Its exchange has ended, after the repeats. What is to follow at once, if anything.
    virtual Line::Script onEnd(const Ask&, const ReplyEnd&, TimePoint /*now*/) { return {}; }
    /// True: the end of its exchange under way is not for it any more.
    virtual bool onChange(const Change&) { return false; }
    /// When wants() may become true by time alone.
    [[nodiscard]] virtual std::optional<TimePoint> due() const { return std::nullopt; }
};

}  // namespace nmc::bus
