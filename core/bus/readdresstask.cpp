// SPDX-License-Identifier: MIT
#include "bus/readdresstask.h"

#include <algorithm>
#include <utility>

#include "protocol/baud.h"

namespace nmc::bus {

namespace {

constexpr unsigned kLowestAddress = 1;
constexpr unsigned kHighestAddress = 0x7F;
constexpr unsigned kMoves = 3;  ///< to a module that provably still has its old address
constexpr unsigned kLooks = 3;  ///< a query is harmless, and its answer may be late or lost

}  // namespace

bool ReaddressTask::anythingMoves() const {
    const auto& modules = m_chain.modules();
    return std::ranges::any_of(modules, [&](const Chain::Module& m) {
        return !m.belief.restarted() && m_chain.answers(m.belief.info().index) && m.belief.seenMoving();
    });
}

void ReaddressTask::begin(ModuleIndex module, bool busy) {
    begin(module, {}, m_chain.has(module) && m_chain.belief(module).restarted(), busy);
}

void ReaddressTask::beginReset(ModuleIndex module, const Payload& reset, bool busy) {
    begin(module, reset, m_chain.has(module) && m_chain.answers(module), busy);
}

void ReaddressTask::begin(ModuleIndex module, const std::optional<Payload>& reset, bool fits, bool busy) {
    if (!fits || busy || anythingMoves()) {
        m_events.emplace_back(ReaddressFailed{module, ReaddressFailed::Reason::NotNow});
        return;
    }
    m_module = module;
    m_reset = reset;
    m_to.reset();
    m_looks = 0;
    m_stage = Stage::Alone;
    m_done = false;
    m_failure = ReaddressFailed::Reason::NoAnswer;
}

void ReaddressTask::beginMove(ModuleIndex module, BusAddress address, bool busy) {
    using Reason = ReaddressFailed::Reason;
    const bool taken = address.value() < kLowestAddress || address.value() > kHighestAddress ||
                       m_chain.find(address) != nullptr;
    const bool fits = m_chain.has(module) && m_chain.answers(module) && !m_chain.belief(module).restarted();
    if (!fits || busy || anythingMoves())
        m_events.emplace_back(ReaddressFailed{module, Reason::NotNow});
    else if (taken)
        m_events.emplace_back(ReaddressFailed{module, Reason::Taken});
    else if (!m_chain.belief(module).info().group)
        m_events.emplace_back(ReaddressFailed{module, Reason::GroupUnknown});
    else {
        m_module = module;
        m_to = address;
        m_moves = 0;
        m_looks = 0;
        m_stage = Stage::Free;
    }
}

bool ReaddressTask::onChange(const Change& change) {
    using enum Change::Kind;
    const bool waits = change.kind == StopAll || change.kind == Interrupted;
    if (!active() || (!waits && change.kind != Search && change.kind != GivenUp))
        return false;
    if (waits && m_to && m_moves > 0) {
        // Where a module is that may have moved is found out afterwards.
        m_moves = kMoves;
        m_stage = Stage::There;
    } else {
        // The module may have its address by now; the next search will find it.
        fail(ReaddressFailed::Reason::NotNow);
    }
    return false;
}

void ReaddressTask::fail(ReaddressFailed::Reason reason) {
    m_events.emplace_back(ReaddressFailed{*std::exchange(m_module, std::nullopt), reason});
    m_to.reset();
}

Next ReaddressTask::next(TimePoint now) {
    const ModuleInfo& info = m_chain.belief(*m_module).info();
    switch (m_stage) {
        case Stage::Alone:
            if (m_line.baud() != kPowerUpBaud)
                return Line::toRate(kPowerUpBaud);
            return question(BusAddress(0), encode(ReadStatus{kIdentityItems}), kIdentityItems);
        case Stage::Reset:
            if (m_line.baud() != m_chain.rate())
                return Line::toRate(m_chain.rate());
            m_stage = Stage::Forget;
            return Line::Script{Line::Gap{}, Line::Packet{toPacket({info.address, *m_reset})},
                                Line::Lag{m_config.resetWait}, DiscardInput{}};
        case Stage::Forget:
            m_stage = Stage::Address;
            m_restarts.setRestarted(*m_module, now);
            return Again{};
        case Stage::Address:
            if (m_line.baud() != kPowerUpBaud)
                return Line::toRate(kPowerUpBaud);
            return question(BusAddress(0), encode(SetAddress{info.address, kEverybody, false}), {});
        case Stage::Probe:
        case Stage::Identify:
        case Stage::Still:
            return question(info.address, encode(ReadStatus{kIdentityItems}), kIdentityItems);
        case Stage::Rate: {
            m_stage = m_done ? Stage::Identify : Stage::Over;
            if (m_chain.rate() == kPowerUpBaud)
                return Again{};
            // The others receive noise at their own rate; there is no reply, because group FF has no leader.
            Line::Script script{Line::Gap{}};
            const auto brd = findBrd(m_chain.rate());
            if (m_done && brd)
                script.emplace_back(Line::Packet{toPacket({kEverybody, encode(SetBaud{*brd})})});
            const Line::Script back = Line::toRate(m_chain.rate());
            script.insert(script.end(), back.begin(), back.end());
            return script;
        }
        case Stage::Free:
        case Stage::There:
            return question(*m_to, encode(ReadStatus{kIdentityItems}), kIdentityItems);
        case Stage::Move: {
            ++m_moves;
            const Payload set = encode(SetAddress{*m_to, BusAddress(info.group->group), info.group->leader});
            return question(info.address, set, m_chain.layoutOf(m_chain.belief(*m_module), set).items);
        }
        case Stage::Over:
            break;
    }
    end(m_done);
    return Again{};
}

Line::Script ReaddressTask::onEnd(const Ask& /*ask*/, const ReplyEnd& end, TimePoint now) {
    if (!active())
        return {};
    const bool right = end.result == ReplyResult::Accepted;
    switch (m_stage) {
        case Stage::Alone:
            onAlone(end);
            break;
        case Stage::Address:
            // Either it was carried out and the answer was lost, or it was not: the query at the address
            // decides (link.md 2.3).
            m_done = right;
            m_stage = right ? Stage::Rate : Stage::Probe;
            break;
        case Stage::Probe:
            if (!right && ++m_looks < kLooks)
                break;
            m_looks = 0;
            m_done = right;
            m_stage = Stage::Rate;
            break;
        case Stage::Identify:
            if (!right && ++m_looks < kLooks)
                break;
            m_done = right && end.report.identity == m_chain.belief(*m_module).info().identity;
            m_stage = Stage::Over;
            if (m_done)
                m_chain.welcome(*m_module, now);
            break;
        case Stage::Free:
            if (end.bytes.empty() && ++m_looks < kLooks)
                break;
            if (!end.bytes.empty())
                fail(ReaddressFailed::Reason::Taken);
            m_stage = Stage::Move;
            break;
        case Stage::Move:
            if (right)
                moved();
            m_stage = Stage::There;
            break;
        case Stage::There:
            if (right)
                moved();
            m_stage = Stage::Still;
            break;
        case Stage::Still:
            if (!right || m_moves >= kMoves)
                fail(right ? ReaddressFailed::Reason::NotNow : ReaddressFailed::Reason::NoAnswer);
            m_stage = Stage::Move;
            break;
        case Stage::Reset:
        case Stage::Forget:
        case Stage::Rate:
        case Stage::Over:
            break;
    }
    return right ? Line::Script{} : Line::Script{Line::Lag{}, DiscardInput{}};
}

/// A module that is still to be reset has its address, so nobody may answer without one; otherwise the module
/// itself must, and alone: the answers of two spoil each other.
void ReaddressTask::onAlone(const ReplyEnd& end) {
    const bool silent = end.bytes.empty();
    const bool alone = m_reset ? silent && m_looks + 1 == kLooks
                               : end.result == ReplyResult::Accepted &&
                                     end.report.identity == m_chain.belief(*m_module).info().identity;
    if (!alone && (!m_reset || silent) && ++m_looks < kLooks)
        return;
    m_looks = 0;
    m_failure = alone || silent ? ReaddressFailed::Reason::NoAnswer : ReaddressFailed::Reason::Unaddressed;
    m_stage = !alone ? Stage::Rate : m_reset ? Stage::Reset : Stage::Address;
}

void ReaddressTask::moved() {
    const ModuleIndex module = *std::exchange(m_module, std::nullopt);
    const BusAddress address = *std::exchange(m_to, std::nullopt);
    m_chain.at(module).belief.setAddress(address);
    m_events.emplace_back(AddressChanged{module, address});
}

Ask ReaddressTask::question(BusAddress address, const Payload& payload, StatusItems items) const {
    Ask ask = Ask::toConnect({address, payload, {m_chain.belief(*m_module).info().identity, items}}, 0);
    ask.handlesFailure = true;
    ask.believed = false;
    return ask;
}

void ReaddressTask::end(bool done) {
    if (!done)
        return fail(m_failure);
    const ModuleIndex module = *std::exchange(m_module, std::nullopt);
    m_events.emplace_back(Readdressed{m_chain.belief(module).info()});
    m_events.emplace_back(ModuleUnresponsive{module, false});
}

}  // namespace nmc::bus
