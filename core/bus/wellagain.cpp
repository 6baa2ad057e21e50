// SPDX-License-Identifier: MIT
#include "bus/wellagain.h"

namespace nmc::bus {

void WellAgain::begin(bool whole, TimePoint now) {
    m_whole = whole;
    m_due = now + kBetween;
    m_since.reset();
    m_well = false;
}

bool WellAgain::asks(const Chain::Module& module) const {
    const ModuleIndex index = module.belief.info().index;
    return !module.belief.restarted() && (m_whole || m_chain.schedule().retired(index));
}

Next WellAgain::next(TimePoint /*now*/) {
    const auto& modules = m_chain.modules();
    for (std::size_t i = 0; i < modules.size(); ++i) {
        m_at = (m_at + 1) % modules.size();
        if (!asks(modules[m_at]))
            continue;
        Ask ask = m_chain.status(Purpose::Challenge, modules[m_at].belief.info().index, kIdentityItems);
        ask.handlesFailure = true;
        ask.believed = false;
        return ask;
    }
    m_due.reset();
    return Idle{};
}

Line::Script WellAgain::onEnd(const Ask& /*ask*/, const ReplyEnd& end, TimePoint now) {
    if (!m_due)
        return {};
    m_due = now + kBetween;
    if (end.result != ReplyResult::Accepted) {
        m_since.reset();
        return {Line::Lag{}, DiscardInput{}, Line::Nulls{}, Line::Lag{kAfterNulls}, DiscardInput{}};
    }
    m_since = m_since.value_or(now);
    m_well = now - *m_since >= kWell;
    if (m_well)
        m_due.reset();
    return {};
}

}  // namespace nmc::bus
