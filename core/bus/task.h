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

/// How long to wait for late answers after a silence.
enum class Quarantine : std::uint8_t {
    None,   ///< silence is expected
    Brief,  ///< a late answer is harmless
    Full,
};

/// An exchange that a task requests, with the retries it allows.
struct Ask {
    Purpose purpose = Purpose::Poll;
    std::optional<ModuleIndex> module{};  ///< empty while the chain is being searched for
    Request request{};
    std::optional<ModuleCommand> command{};  ///< believed to have taken effect when it is carried out
    std::uint8_t silentRepeats = 0;
    bool repeatAtOnce = false;         ///< preceded only by nulls: a stop does not wait for late answers
    std::uint8_t refusedAttempts = 3;  ///< in total
    std::uint8_t refusedBefore = 0;    ///< in earlier requests of the same command
    Quarantine quarantine = Quarantine::Full;  ///< after silence
    bool retry = false;                        ///< the same was requested before without success
    bool reported = false;                     ///< a CommandExecuted is emitted when it is carried out
    bool believed = true;                      ///< the reply is taken for the state of the module
    bool handlesFailure =
        false;  ///< the task handles silence and wrong answers itself: no retry, no recovery
    /// As another host has sent it (lending.h); its sum may be wrong.
    std::optional<PacketBytes> asSent{};

    /// A query while the chain is being found or rearranged.
    [[nodiscard]] static Ask toConnect(const Request& request, std::uint8_t silentRepeats,
                                       Quarantine quarantine = Quarantine::Full) {
        Ask ask;
        ask.purpose = Purpose::Connect;
        ask.request = request;
        ask.silentRepeats = silentRepeats;
        ask.quarantine = quarantine;
        return ask;
    }
};

/// The possible requests of a task for the line.
struct Idle {};
struct Again {};  ///< it did something that does not need the line: restarts dispatch
using Next = std::variant<Idle, Again, Line::Script, Ask>;

/// What every task may have to give way to.
struct Change {
    enum class Kind : std::uint8_t {
        StopAll,      ///< every motor is stopped, whatever set it in motion
        Search,       ///< the chain is searched for again
        GivenUp,      ///< the link is given up: only stops are sent from now on
        Cancelled,    ///< nothing that was requested so far continues
        Stopped,      ///< `modules` are stopped for a cause of their own
        Interrupted,  ///< what was on the line was dropped, and its reply never comes
    };
    Kind kind;
    std::vector<ModuleIndex> modules{};  ///< of Stopped

    /// Everything that was requested, of any module, is over.
    [[nodiscard]] bool cancelsAll() const {
        return kind == Kind::StopAll || kind == Kind::Search || kind == Kind::GivenUp ||
               kind == Kind::Cancelled;
    }
};

class Chain;

/// What the tasks of an engine share.
struct Shared {
    Chain& chain;
    const Line& line;
    std::vector<Event>& events;
};

/// One concern of the engine: a stop, a search, an operation, polls. The engine asks its tasks in a fixed
/// order (engine.cpp) for their requests, carries these out on the line, and returns the results. A task
/// never uses the line itself. Pure.
class Task {
public:
    explicit Task(const Shared& shared)
        : m_chain(shared.chain), m_line(shared.line), m_events(shared.events) {}
    virtual ~Task() = default;
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

    /// True if it has something to do now, before lower priorities. Changes nothing.
    [[nodiscard]] virtual bool wants(TimePoint now) const = 0;
    /// True if its exchanges may begin while the previous reply may still turn out to have surplus bytes.
    [[nodiscard]] virtual bool pipelines() const { return false; }
    /// Called when the line is free and no higher priority needs it.
    [[nodiscard]] virtual Next next(TimePoint now) = 0;
    /// Its exchange was answered; called before the content is published.
    virtual void onAnswer(const Ask&, const ReplyEnd&) {}
    /// Its exchange has ended, after its retries. Returns what must follow at once, if anything.
    virtual Line::Script onEnd(const Ask&, const ReplyEnd&, TimePoint /*now*/) { return {}; }
    /// Gives way to the change. Returns true when the task no longer waits for the end of its exchange.
    virtual bool onChange(const Change&) { return false; }
    /// When wants() may become true by the passage of time alone.
    [[nodiscard]] virtual std::optional<TimePoint> due() const { return std::nullopt; }

protected:
    Chain& m_chain;
    const Line& m_line;
    std::vector<Event>& m_events;
};

}  // namespace nmc::bus
