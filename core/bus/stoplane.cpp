// SPDX-License-Identifier: MIT
#include "bus/stoplane.h"

#include <algorithm>
#include <tuple>

namespace nmc::bus {

namespace {

/// In a stop of all modules, one that answered until now is given up after this long and this many
/// consecutive timeouts.
constexpr Duration kSilentFor = std::chrono::milliseconds(500);
constexpr unsigned kSilences = 3;

/// For a module that answers, stops are repeated at once this often; after that, and while no module answers,
/// in this interval. Commands may get through even if no answer does (faults.md F-11, F-19). But the line
/// also needs its way back, which may find that the module has restarted, and takes 0.3 s at 19 200 Bd.
constexpr unsigned kAtOnce = 3;
constexpr Duration kAfterSilence = std::chrono::milliseconds(500);
/// Time between two queries of a motor that is decelerating; kBetweenLateLooks applies later, to one that
/// does not stop.
constexpr Duration kBetweenLooks = std::chrono::milliseconds(20);
constexpr Duration kBetweenLateLooks = std::chrono::milliseconds(250);
constexpr unsigned kEarlyLooks = 100;
/// After such a query, the others wait for at least this long, so that something else is sent in between:
/// three motors that slow down would otherwise occupy a slow line, and a module that is about to leave its
/// travel limits would not be polled.
constexpr Duration kGiveWay = std::chrono::milliseconds(5);

}  // namespace

bool StopLane::wants(TimePoint now) const {
    const auto first = due();
    return m_run || !m_sentBlind.empty() || (first && *first <= now);
}

std::optional<TimePoint> StopLane::due() const {
    std::optional<TimePoint> first;
    for (const Chain::Module& module : m_chain.modules())
        if (module.owed)
            first = earliest({first, module.owed->due});
    return first;
}

Next StopLane::next(TimePoint now) {
    return m_run ? nextOfAll(now) : nextOwed(now);
}

/// Handles the first answer after a blind stop, before its content is published: otherwise the calculated
/// command position would continue until the stop is acknowledged, and be some 20 ms of travel off.
void StopLane::onAnswer(const Ask& ask, const ReplyEnd& /*end*/) {
    auto& owed = m_chain.at(*ask.module).owed;
    if (auto executed = owed ? m_chain.takeBlindStop(owed->target) : std::nullopt)
        m_events.emplace_back(std::move(*executed));
}

Line::Script StopLane::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    auto& owed = m_chain.at(*ask.module).owed;
    const bool inVain = ask.handlesFailure && unanswered(end.result);
    const Line::Script after = inVain ? Line::Script{Line::Lag{}, DiscardInput{}} : Line::Script{};
    if (!owed)
        return after;  // superseded while its query was in progress
    owed->target.onReply(end, m_chain.belief(*ask.module), now);
    if (m_run) {
        onEndOfAll(*ask.module, now);
        return after;
    }
    if (owed->target.stopped()) {
        m_events.emplace_back(OwedStopConfirmed{*ask.module, owed->cause});
        owed.reset();
        return after;
    }
    const bool looked = !ask.reported && end.result == ReplyResult::Accepted;
    const bool moves = looked && owed->target.slowsDown();
    owed->looks += moves ? 1U : 0U;
    owed->due = inVain || owed->target.silences() > kAtOnce ? now + kAfterSilence
                : moves ? now + (owed->looks < kEarlyLooks ? kBetweenLooks : kBetweenLateLooks)
                        : now;
    if (moves)
        giveWay(now);
    return after;
}

/// No stop waits for this: only queries of motors that were seen to slow down.
void StopLane::giveWay(TimePoint now) {
    for (Chain::Module& module : m_chain.modules()) {
        auto& owed = module.owed;
        if (owed && owed->looks > 0 && owed->target.slowsDown())
            owed->due = std::max(owed->due, now + kGiveWay);
    }
}

// ---- stops of all modules ----

void StopLane::stopAll(TimePoint now) {
    if (!stopping())
        m_pressed = now;
    m_waiting = false;
    m_unasked = false;
    begin(now);
    // A single packet to all modules is faster than one to each, even on a free line.
    m_blindDue =
        m_recovery.suspect() || m_line.busy() || m_chain.size() > 1 || m_line.baud() != m_chain.rate();
}

void StopLane::stopAllAfterSearch(TimePoint now) {
    if (!stopping())
        m_pressed = now;
    m_unasked = false;
    m_waiting = true;
}

void StopLane::onSearchOver(TimePoint now) {
    m_searching = false;
    if (!std::exchange(m_waiting, false))
        return;
    begin(now);
    m_blindDue = false;
}

void StopLane::begin(TimePoint now) {
    const bool again = running();
    if (!again)
        m_run = Run{now};
    m_together.clear();
    m_run->members.clear();
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        m_chain.owe(index, StopCause::StopAll);
        if (!module.owed)
            continue;
        m_run->members.push_back({index, !m_chain.answers(index), module.belief.moving()});
        if (!again && !module.owed->target.needsStop() && !module.owed->target.unknown())
            m_run->wereOff.push_back(index);
    }
    std::ranges::stable_sort(m_run->members, {}, [](const Member& member) {
        return std::tuple(member.wasUnresponsive, !member.moving);
    });
}

bool StopLane::open(const Member& member) const {
    return m_chain.at(member.module).owed && !member.givenUp && !target(member).stopped();
}

bool StopLane::allSent() const {
    return m_run && !m_blindDue && std::ranges::none_of(m_run->members, [&](const Member& member) {
               return open(member) && (target(member).needsStop() || target(member).unknown());
           });
}

std::vector<Order> StopLane::blindStops() const {
    std::vector<Order> stops;
    const auto add = [&](const Chain::Module& module) {
        if (const auto stop = module.owed->target.stop(module.belief))
            stops.push_back({module.belief.info().index, *stop});
    };
    if (!m_run) {
        for (const Chain::Module& module : m_chain.modules())
            if (module.owed && module.owed->target.needsStop())
                add(module);
        return stops;
    }
    for (const Member& member : m_run->members)
        if (open(member))
            add(m_chain.at(member.module));
    return stops;
}

void StopLane::onBlindSent() {
    m_sentBlind = blindStops();
    m_blindDue = m_blindHeard = false;
}

Next StopLane::nextOfAll(TimePoint now) {
    const bool strayed = m_line.baud() != m_chain.rate();
    if (std::exchange(m_blindDue, false)) {
        // Answers are not awaited: a reply may still be arriving, and could be taken for the answer to the
        // stop.
        m_blindHeard = !m_recovery.suspect() && !strayed;
        if (!m_blindHeard)
            m_recovery.flushed();
        m_sentBlind = blindStops();
        return scriptFor(m_sentBlind, !m_blindHeard,
                         byteTimeAtBaud(m_chain.rate()) * static_cast<Duration::rep>(m_chain.longestReply()));
    }
    if (strayed)
        return Line::toRate(m_chain.rate());
    noteBlindStops();
    if (auto nulls = m_recovery.flush())
        return std::move(*nulls);
    Member* first = nullptr;
    const auto rank = [&](const Member& m) {
        return std::tuple(target(m).silences(), !target(m).unknown(), !target(m).needsStop(), m.asks);
    };
    for (Member& member : m_run->members)
        if (open(member) && (first == nullptr || rank(member) < rank(*first)))
            first = &member;
    if (first == nullptr || now - m_run->began >= kLimit) {
        finish(now);
        return Again{};
    }
    ++first->asks;
    return m_chain.next(target(*first));
}

void StopLane::onEndOfAll(ModuleIndex module, TimePoint now) {
    for (Member& member : m_run->members)
        if (member.module == module)
            member.givenUp = target(member).silences() >= kSilences &&
                             (member.wasUnresponsive || now - m_run->began >= kSilentFor);
}

void StopLane::finish(TimePoint now) {
    const Run run = *std::exchange(m_run, std::nullopt);
    StopFinished event;
    event.took = now - m_pressed;
    event.unasked = std::exchange(m_unasked, false);
    event.wereOff = run.wereOff;
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (module.belief.restarted()) {
            event.unreached.push_back(index);
        } else if (!module.owed) {
            event.noStopKnown.push_back(index);
        } else if (module.owed->target.stopped()) {
            event.stopped.push_back(index);
            if (module.owed->standsAlone())
                m_events.emplace_back(OwedStopConfirmed{index, module.owed->cause});
            module.owed.reset();
        } else {
            const bool givenUp = std::ranges::any_of(
                run.members, [&](const Member& m) { return m.module == index && m.givenUp; });
            const bool heard = module.owed->target.heard() && !givenUp;
            (heard ? event.unconfirmed : event.unreached).push_back(index);
            module.owed->outstanding = true;
            module.owed->due = now;
        }
    }
    for (const ModuleIndex module : event.unreached)
        m_recovery.lose(module, now);
    m_events.emplace_back(std::move(event));
}

// ---- stops of single modules ----

bool StopLane::anyUnsent(TimePoint now) const {
    return std::ranges::any_of(m_chain.modules(), [&](const Chain::Module& module) {
        return module.owed && module.owed->due <= now && module.owed->target.needsStop() &&
               !blindly(module.belief.info().index);
    });
}

bool StopLane::blindly(ModuleIndex module) const {
    // A module that was given up because of errors is still queried: only this can confirm its stop.
    const bool silent = !m_chain.answers(module) && !m_chain.schedule().retired(module);
    return m_searching || m_line.baud() != m_chain.rate() || silent;
}

Next StopLane::nextOwed(TimePoint now) {
    noteBlindStops();
    if (Line::Script script = groupScript(); !script.empty())
        return script;
    Chain::Module* asked = nullptr;
    for (Chain::Module& module : m_chain.modules()) {
        if (!module.owed || module.owed->due > now)
            continue;
        if (blindly(module.belief.info().index))
            return blindScript(now);
        if (asked == nullptr || module.owed->due < asked->owed->due)
            asked = &module;
    }
    if (asked == nullptr)
        return Idle{};
    if (auto nulls = m_recovery.flush())
        return std::move(*nulls);
    Ask ask = m_chain.next(asked->owed->target);
    ask.retry = asked->owed->target.silences() > 0;
    ask.handlesFailure = !m_chain.answers(asked->owed->target.module());
    return ask;
}

/// The leader's answer is dropped: each member answers for itself.
Line::Script StopLane::groupScript() {
    std::vector<Order> stops;
    for (const ModuleIndex module : std::exchange(m_together, {})) {
        const auto& owed = m_chain.at(module).owed;
        if (const auto stop = owed ? owed->target.stop(m_chain.belief(module)) : std::nullopt)
            stops.push_back({module, *stop});
    }
    const bool here = !m_searching && m_line.baud() == m_chain.rate() && !m_recovery.suspect();
    if (!here || !m_chain.groupOf(stops))
        return {};
    m_sentBlind = stops;
    m_blindHeard = true;
    return scriptFor(stops, false);
}

/// Sends all stops that are due, together, at the chain's rate; the port then returns to its previous rate.
Next StopLane::blindScript(TimePoint now) {
    std::vector<Order> stops;
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (!module.owed || !blindly(index) || module.owed->due > now)
            continue;
        module.owed->due = now + kAfterSilence;
        m_chain.schedule().hurry(index, now);  // only its answer can confirm the stop
        if (const auto stop = module.owed->target.stop(module.belief))
            stops.push_back({index, *stop});
    }
    if (stops.empty())
        return Again{};
    for (const Order& stop : stops)  // nothing is answered before the script ends
        m_chain.noteSent(stop.module, stop.command, m_line.latchTime(0, now));
    Line::Script script = scriptFor(stops, true);
    if (const std::uint32_t here = m_line.baud(); here != m_chain.rate()) {
        const Line::Script back = Line::toRate(here);
        script.insert(script.end(), back.begin(), back.end());
    }
    return script;
}

// ---- stops whose answers are not awaited ----

/// `underWay`: how long a reply that is still arriving may take.
Line::Script StopLane::scriptFor(const std::vector<Order>& stops, bool nulls, Duration underWay) const {
    Line::Script script{Line::Gap{}};
    if (m_line.baud() != m_chain.rate())
        script.emplace_back(SetHostBaud{m_chain.rate()});
    if (nulls)
        script.insert(script.end(), {Line::Nulls{}, Line::Pause{kAfterNulls}});
    const Line::Script packets = m_chain.stopScript(stops);
    script.insert(script.end(), packets.begin(), packets.end());
    script.insert(script.end(), {Line::Lag{underWay}, DiscardInput{}});
    return script;
}

/// The last script has been sent: the possible effect of its stops is believed from now on.
void StopLane::noteBlindStops() {
    const std::vector<Order> stops = std::exchange(m_sentBlind, {});
    const std::vector<TimePoint>& latches = m_line.scriptLatches();
    for (std::size_t i = 0; i < stops.size() && !latches.empty(); ++i) {
        const auto& [module, command] = stops[i];
        const TimePoint latched = latches[std::min(i, latches.size() - 1)];
        m_chain.noteSent(module, command, latched);
        m_chain.noteUnanswered(module, latched);
        if (auto& owed = m_chain.at(module).owed)
            owed->target.onBlindSent(m_blindHeard ? std::optional(StopTarget::Blind{command, latched})
                                                  : std::nullopt);
    }
}

}  // namespace nmc::bus
