// SPDX-License-Identifier: MIT
#include "bus/stoprun.h"

#include <algorithm>
#include <tuple>

namespace nmc::bus {

StopRun::StopRun(const Chain& chain, TimePoint now) : m_began(now) {
    restart(chain);
    for (const Target& target : m_targets)
        if (!target.stop.needsStop() && !target.stop.unknown())
            m_wereOff.push_back(target.stop.module());
}

void StopRun::restart(const Chain& chain) {
    m_targets.clear();
    m_restarted.clear();
    m_noStopKnown.clear();
    for (const Chain::Module& module : chain.modules()) {
        const Belief& belief = module.belief;
        if (belief.restarted())
            m_restarted.push_back(belief.info().index);
        else if (!hasStop(belief.info().identity.type))
            m_noStopKnown.push_back(belief.info().index);
        else
            m_targets.push_back({StopTarget(belief), !chain.answers(belief.info().index), belief.moving()});
    }
    std::stable_sort(m_targets.begin(), m_targets.end(), [](const Target& a, const Target& b) {
        return std::tuple(a.wasUnresponsive, !a.moving) < std::tuple(b.wasUnresponsive, !b.moving);
    });
}

std::vector<Order> StopRun::blindStops(const Chain& chain) const {
    std::vector<Order> orders;
    for (const Target& target : m_targets)
        if (const auto stop = target.stop.stop(chain.belief(target.stop.module())))
            orders.push_back({target.stop.module(), *stop});
    return orders;
}

StopTarget* StopRun::next(TimePoint now) {
    if (now - m_began >= kLimit)
        return nullptr;
    Target* first = nullptr;
    const auto rank = [](const Target& t) {
        return std::tuple(t.stop.silences(), !t.stop.unknown(), !t.stop.needsStop(), t.asks);
    };
    for (Target& target : m_targets)
        if (target.open() && (first == nullptr || rank(target) < rank(*first)))
            first = &target;
    if (first == nullptr)
        return nullptr;
    ++first->asks;
    return &first->stop;
}

bool StopRun::allSent() const {
    return std::none_of(m_targets.begin(), m_targets.end(), [](const Target& target) {
        return target.open() && (target.stop.needsStop() || target.stop.unknown());
    });
}

void StopRun::onReply(StopTarget& asked, const ReplyEnd& end, const Belief& belief, TimePoint now) {
    asked.onReply(end, belief, now);
    const auto target =
        std::find_if(m_targets.begin(), m_targets.end(), [&](const Target& t) { return &t.stop == &asked; });
    target->givenUp =
        asked.silences() >= kSilences && (target->wasUnresponsive || now - m_began >= kSilentFor);
}

StopTarget* StopRun::find(ModuleIndex module) {
    const auto found = std::find_if(m_targets.begin(), m_targets.end(),
                                    [&](const Target& t) { return t.stop.module() == module; });
    return found == m_targets.end() ? nullptr : &found->stop;
}

StopFinished StopRun::finished() const {
    StopFinished event;
    event.unreached = m_restarted;
    event.noStopKnown = m_noStopKnown;
    event.wereOff = m_wereOff;
    for (const Target& target : m_targets)
        (target.stop.stopped()                    ? event.stopped
         : target.stop.heard() && !target.givenUp ? event.unconfirmed
                                                  : event.unreached)
            .push_back(target.stop.module());
    for (auto* list : {&event.stopped, &event.unreached, &event.unconfirmed})
        std::sort(list->begin(), list->end());
    return event;
}

}  // namespace nmc::bus
