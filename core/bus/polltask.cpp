// SPDX-License-Identifier: MIT
#include "bus/polltask.h"

namespace nmc::bus {

Next PollTask::next(TimePoint now) {
    const auto turn = m_chain.schedule().next(now);
    if (!turn)
        return Idle{};
    std::optional<StatusItems> items;  // empty: No Operation, whose reply has the defined items
    const ModuleIdentity identity = m_chain.belief(turn->module).info().identity;
    if (!isKnown(identity))
        items = kIdentityItems;
    else if (turn->full)
        items = fullItems(identity);
    else if (turn->brief)
        items = briefItems(identity);
    if (m_chain.belief(turn->module).onPath())
        items = items.value_or(standingItems(identity)) | StatusItems(StatusItems::PathPoints);
    Ask ask = m_chain.status(Purpose::Poll, turn->module, items);
    ask.silentRepeats = 0;  // its turn comes again
    ask.request.framing = Framing::Pipelined;
    // A module that was silent must first prove its identity.
    ask.handlesFailure = !m_chain.answers(turn->module);
    ask.believed = !ask.handlesFailure;
    return ask;
}

Line::Script PollTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    if (!ask.handlesFailure)
        return {};
    if (end.result == ReplyResult::Accepted) {
        m_recovery.onHeardAgain(*ask.module);
        m_chain.hurryOwedStop(*ask.module, now);
        return {};
    }
    m_chain.schedule().onTimeout(*ask.module, now);
    m_search.onProbeFailed();
    // It will not answer late: a short discard is enough, so that the others do not wait for it.
    return {Line::Lag{}, DiscardInput{}};
}

}  // namespace nmc::bus
