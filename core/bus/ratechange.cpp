// SPDX-License-Identifier: MIT
#include "bus/ratechange.h"

#include <utility>

#include "protocol/baud.h"
#include "protocol/commands.h"

namespace nmc::bus {

namespace {

/// How often all modules are sent back.
constexpr unsigned kReturns = 2;

}  // namespace

RateChange::RateChange(std::vector<Target> chain, std::vector<BusAddress> groups, std::uint32_t from,
                       std::uint32_t to, WayBack wayBack)
    : m_chain(std::move(chain)), m_groups(std::move(groups)), m_from(from), m_to(to), m_wayBack(wayBack) {}

RateChange::Next RateChange::next() {
    switch (m_phase) {
        case Phase::Change: {
            enter(Phase::Verify);
            Line::Script script = sendToAll(m_to);
            script.insert(script.end(), {SetHostBaud{m_to}, DiscardInput{}});
            return script;
        }
        case Phase::LookBack:
            enter(Phase::Recheck);
            return Line::toRate(m_from);
        case Phase::Return:
            enter(Phase::Settle);
            ++m_returns;
            return goBack();
        case Phase::Verify:
        case Phase::Recheck:
        case Phase::Settle:
            return ask();
        case Phase::Ended:
            break;
    }
    return m_ended;
}

void RateChange::onReply(const ReplyEnd& end) {
    // A module that reports an error has received something at this rate, but not reliably.
    if (end.result != ReplyResult::Accepted)
        m_unheard.push_back(m_at);
    if (++m_at == m_chain.size())
        onAll();
}

/// Called when the last module of this phase has been queried.
void RateChange::onAll() {
    switch (m_phase) {
        case Phase::Verify:
            m_ended.deaf = m_unheard;
            m_ended.reached = m_unheard.empty();
            if (m_unheard.size() == m_chain.size() && !std::exchange(m_lookedBack, true))
                return enter(Phase::LookBack);
            return enter(m_ended.reached || m_wayBack == WayBack::None ? Phase::Ended : Phase::Return);
        case Phase::Recheck:
            // All modules are at the old rate: the change was lost. It is tried again, but only once.
            if (m_unheard.empty())
                return enter(Phase::Change);
            return enter(m_wayBack == WayBack::None ? Phase::Ended : Phase::Return);
        case Phase::Settle:
            m_ended.lost = m_unheard;
            return enter(m_unheard.empty() || m_returns == kReturns ? Phase::Ended : Phase::Return);
        case Phase::Change:
        case Phase::LookBack:
        case Phase::Return:
        case Phase::Ended:
            return;
    }
}

Line::Script RateChange::goBack() const {
    // Even if the port is already at that rate: a module may have received part of a command.
    Line::Script script = Line::toRate(m_to);
    for (const Line::Script& more : {sendToAll(m_from), Line::toRate(m_from)})
        script.insert(script.end(), more.begin(), more.end());
    return script;
}

void RateChange::interrupt() {
    m_ended = {};
    m_ended.interrupted = true;
    m_returns = 1;
    enter(Phase::Settle);
}

/// No module answers, because there is no leader.
Line::Script RateChange::sendToAll(std::uint32_t rate) const {
    const Payload payload = encode(SetBaud{findBrd(rate).value_or(kPowerUpBrd)});
    Line::Script script{Line::Gap{}};
    for (const BusAddress group : m_groups) {
        if (group != m_groups.front())
            script.emplace_back(Line::Spacer{});
        script.emplace_back(Line::Packet{toPacket({group, payload})});
    }
    // The port changes when its own buffer is empty, and what was sent has been read.
    script.emplace_back(Line::Lag{kTurnaround + patience()});
    return script;
}

Ask RateChange::ask() const {
    Ask ask = Ask::toConnect({m_chain[m_at].address, encode(Nop{}), m_chain[m_at].reply}, 2);
    ask.request.patience = patience();
    return ask;
}

Duration RateChange::patience() const {
    return m_lookedBack ? kSchedulingDelay : Duration{};
}

void RateChange::enter(Phase phase) {
    m_phase = phase;
    m_at = 0;
    m_unheard.clear();
}

}  // namespace nmc::bus
