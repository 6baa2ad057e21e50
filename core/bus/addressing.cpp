// SPDX-License-Identifier: MIT
#include "bus/addressing.h"

#include <algorithm>

#include "protocol/commands.h"

namespace nmc::bus {

namespace {

/// Beyond this number, a search that continues is out of control.
constexpr std::uint8_t kLastNumber = 100;
/// This many consecutive addresses without an answer mean the end of the chain, provided that its last module
/// keeps answering.
constexpr unsigned kSetAttempts = 2;
/// This many wrong answers in a row at a number that was just assigned are not the line's fault.
constexpr unsigned kWrongAttempts = 3;

}  // namespace

Addressing::Next Addressing::next() {
    switch (m_phase) {
        case Phase::Set:
            return setAddress();
        case Phase::Probe:
            return probe(BusAddress(m_number), m_unheardInRow + 1 < kSetAttempts ? 1 : 0);
        case Phase::Alive:
            return stillThere();
        case Phase::Recheck:
            return m_recheck.next() ? probe(*m_recheck.next(), 0) : stillThere();
        case Phase::Done:
            return Done{};
        case Phase::Failed:
            break;
    }
    return m_failure;
}

void Addressing::onReply(const ReplyEnd& end) {
    switch (m_phase) {
        case Phase::Set:
            return onAddress(end);
        case Phase::Probe:
            return onProbe(end);
        case Phase::Alive:
            return onAlive(end);
        case Phase::Recheck:
            return m_recheck.next() ? onRecheck(end) : onAlive(end);
        case Phase::Done:
        case Phase::Failed:
            return;
    }
}

/// The last number sent may have been received, unless that has already been determined.
void Addressing::resume() {
    const BusAddress last(m_number);
    if (m_phase == Phase::Set && begun() && std::ranges::find(m_addresses, last) == m_addresses.end() &&
        !m_recheck.contains(last))
        m_phase = Phase::Probe;
}

/// Always sends the next number: if the previous one was received and its answers were lost, the next module
/// would take it as well.
Ask Addressing::setAddress() {
    const SetAddress set{BusAddress(++m_number), kEverybody, false};
    Ask ask = Ask::toConnect({kUnaddressed, encode(set), {}}, 0, Quarantine::Brief);
    ask.refusedAttempts = 1;
    return ask;
}

/// The reply differs in length from the answer to Set Address, which may still be on its way.
Ask Addressing::probe(BusAddress address, std::uint8_t repeats) {
    return Ask::toConnect({address, encode(ReadStatus{kIdentityItems}), {{}, kIdentityItems}}, repeats,
                          Quarantine::Brief);
}

/// The reply has the same length as the answers to Set Address, which are valid even when late.
Ask Addressing::stillThere() const {
    const BusAddress address = m_addresses.empty() ? kUnaddressed : m_addresses.back();
    return Ask::toConnect({address, encode(Nop{}), {}}, 0, Quarantine::Full);
}

void Addressing::onAddress(const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted)
        return found(BusAddress(m_number));
    m_heardNoise = m_heardNoise || !end.bytes.empty();
    // Either it was carried out and the answer was lost, or it was not: the new address is queried before
    // anything else (link.md 2.3). At what seems to be the end of the chain, this is the first query of the
    // recheck.
    if (end.bytes.empty() && m_unheardInRow + 1 == kSetAttempts) {
        m_recheck.add(BusAddress(m_number));
        return endOfNumbers();
    }
    m_phase = Phase::Probe;
}

void Addressing::onProbe(const ReplyEnd& end) {
    if (!unanswered(end.result))
        return found(BusAddress(m_number));
    if (end.result != ReplyResult::Unresponsive) {
        if (++m_wrongInRow < kWrongAttempts)
            return;
        return fail(end.rejection == Rejection::Surplus ? ConnectFailure::Collision : ConnectFailure::Garbled,
                    m_addresses.size());
    }
    m_recheck.add(BusAddress(m_number));
    m_aliveInVain = 0;
    m_wrongInRow = 0;
    if (m_addresses.empty() && !m_expected)
        return onNumberUnheard();
    m_phase = Phase::Alive;
}

/// Silence means the end of the chain only if a module is heard right after it. Otherwise the number may have
/// been taken, and the search waits for the line. Of a chain none of whose modules is known yet, the one
/// without an address is queried; if it stays silent, it has perhaps taken the number.
void Addressing::onAlive(const ReplyEnd& end) {
    const bool heard = !unanswered(end.result);
    if (!heard && ++m_aliveInVain < kAliveAttempts)
        return;
    if (!heard && !m_addresses.empty())
        return failDisturbed();
    if (!heard) {
        m_expected = false;
        return endOfNumbers();
    }
    if (m_phase == Phase::Recheck)
        return onRechecked();
    if (m_aliveInVain > 0)
        return nextNumber();
    onNumberUnheard();
}

void Addressing::onNumberUnheard() {
    if (++m_unheardInRow >= kSetAttempts)
        return endOfNumbers();
    m_phase = Phase::Set;
}

void Addressing::onRecheck(const ReplyEnd& end) {
    const BusAddress address = *m_recheck.next();
    if (m_recheck.onReply(end))
        m_addresses.insert(std::ranges::upper_bound(m_addresses, address), address);
    else
        m_heardNoise = m_heardNoise || !end.bytes.empty();
    if (m_recheck.next())
        return;
    if (m_recheck.found()) {
        m_unheardInRow = 0;
        return nextNumber();
    }
    if (m_addresses.empty() && !m_expected)
        endOfChain();
}

/// The last module that is known has answered after a recheck. If it did not do so at once, or any answer was
/// late, the silence of the others shows nothing, and neither does that after the last Set Address.
void Addressing::onRechecked() {
    if (m_aliveInVain == 0 && !m_recheck.doubtful())
        return endOfChain();
    m_recheck.noteInVain();
    if (m_recheck.exhausted())
        return m_addresses.empty() ? endOfChain() : failDisturbed();
    m_unheardInRow = kSetAttempts - 1;
    nextNumber();
}

void Addressing::nextNumber() {
    if (m_number == kLastNumber)
        return fail(ConnectFailure::Disturbed);
    m_phase = Phase::Set;
}

void Addressing::found(BusAddress address) {
    m_addresses.push_back(address);
    m_unheardInRow = 0;
    m_wrongInRow = 0;
    m_phase = Phase::Set;
    if (m_addresses.size() == kMaxModules)
        endOfNumbers();
}

void Addressing::endOfNumbers() {
    if (m_recheck.empty())
        return endOfChain();
    m_aliveInVain = 0;
    m_recheck.begin();
    m_phase = Phase::Recheck;
}

void Addressing::endOfChain() {
    if (m_addresses.empty())
        return fail(m_heardNoise ? ConnectFailure::Garbled : ConnectFailure::NobodyAnswers);
    m_phase = Phase::Done;
}

/// A module that answered before no longer does.
void Addressing::failDisturbed() {
    fail(ConnectFailure::Disturbed, m_addresses.size() - 1);
}

void Addressing::fail(ConnectFailure reason, std::optional<std::size_t> module) {
    m_failure = {reason, module};
    m_phase = Phase::Failed;
}

}  // namespace nmc::bus
