// SPDX-License-Identifier: MIT
#include "bus/chainlook.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

namespace {

constexpr unsigned kFirstAddress = 1;
constexpr unsigned kUsualAddresses = 2;  ///< probed at every rate first
/// Two answers that are lost in a row hide nobody.
constexpr unsigned kRounds = 3;
/// At rates where nobody else answers, addresses that hardly a host gives: three rounds of all of them would
/// take ten seconds of everyone whose chain has no power.
constexpr unsigned kUnusualRounds = 2;
/// A search that skips a number, because nobody was heard to take it, goes beyond 32.
constexpr unsigned kLastAddress = 34;

template <typename T>
void addNew(std::vector<T>& list, const T& value) {
    if (std::find(list.begin(), list.end(), value) == list.end())
        list.push_back(value);
}

}  // namespace

ChainLook::ChainLook(const std::vector<std::uint32_t>& rates, std::vector<BusAddress> addresses)
    : m_rates(kRates.begin(), kRates.end()), m_known(std::move(addresses)) {
    for (const std::uint32_t rate : rates)
        addNew(m_rates, rate);
    for (unsigned address = kFirstAddress; address <= kLastAddress; ++address)
        (m_first.size() < kUsualAddresses ? m_first : m_rest)
            .emplace_back(static_cast<std::uint8_t>(address));
    const std::size_t usual = std::min<std::size_t>(m_known.size(), kUsualAddresses);
    for (std::size_t i = 0; i < m_known.size(); ++i)
        addNew(i < usual ? m_first : m_rest, m_known[i]);
    const auto asked = [this](BusAddress address) {
        return std::find(m_first.begin(), m_first.end(), address) != m_first.end();
    };
    std::erase_if(m_rest, asked);
    std::sort(m_rest.begin(), m_rest.end());
}

ChainLook::Next ChainLook::next() {
    while (m_at == m_probes.size()) {
        if (m_stage == Stage::Over)
            return {};
        refill();
    }
    const Probe& probe = m_probes[m_at];
    if (m_hostRate != probe.rate) {
        m_hostRate = probe.rate;
        return Line::toRate(probe.rate);
    }
    if (std::exchange(m_waits, false))  // the rest of a reply that came in pieces
        return Line::Script{Line::Pause{kLongestReplyGap}, DiscardInput{}};
    if (m_zerosHeard || m_asksIdentity)
        return Request{probe.address, encode(ReadStatus{kIdentityItems}), {{}, kIdentityItems}};
    // The answer's length hangs on what the host before defined.
    return Request{probe.address, encode(Nop{}), {}, Framing::Open};
}

/// The probes of the next round.
void ChainLook::refill() {
    m_probes.clear();
    m_at = 0;
    switch (m_stage) {
        case Stage::First:
            if (!m_rate && m_round < kRounds)
                return refillFirst();
            if (!m_rate && m_unaddressed)
                break;
            enter(m_rate ? Stage::Rest : Stage::Everywhere);
            return refill();
        case Stage::Everywhere:
            if (trouble() == ConnectFailure::NobodyAnswers && m_round++ < kUnusualRounds) {
                for (const std::uint32_t rate : m_rates)
                    add(rate, m_rest);
                return;
            }
            if (trouble())
                break;
            enter(Stage::Missing);
            return refill();
        case Stage::Rest:
            if (m_round++ == 0)
                return add(*m_rate, m_rest);
            if (trouble())
                break;
            enter(Stage::Missing);
            return refill();
        case Stage::Missing:
            if (m_round < kRounds - 1)
                return refillMissing();
            break;
        case Stage::Over:
            break;
    }
    m_stage = Stage::Over;
}

/// Beside a module without an address there may be a chain all the same.
void ChainLook::refillFirst() {
    ++m_round;
    addUnaddressed();
    for (const std::uint32_t rate : m_rates)
        add(rate, m_unaddressed ? missing() : m_first);
}

/// Everybody has been asked once by now.
void ChainLook::refillMissing() {
    ++m_round;
    add(*m_rate, missing());
    addUnaddressed();
}

/// The usual first ones if nobody was found; two behind the last otherwise, because one of them may be that
/// of a module that has restarted.
std::vector<BusAddress> ChainLook::missing() const {
    std::vector<BusAddress> addresses;
    const unsigned last = (m_found.empty() ? 0U : m_found.back().value()) + kUsualAddresses;
    for (unsigned address = kFirstAddress; address <= std::min(last, kLastAddress); ++address)
        addresses.emplace_back(static_cast<std::uint8_t>(address));
    for (const BusAddress address : m_known)
        addNew(addresses, address);
    return addresses;
}

/// But for those that have answered.
void ChainLook::add(std::uint32_t rate, const std::vector<BusAddress>& addresses) {
    for (const BusAddress address : addresses)
        if (std::find(m_found.begin(), m_found.end(), address) == m_found.end())
            m_probes.push_back({rate, address});
}

void ChainLook::addUnaddressed() {
    if (!m_unaddressed)
        add(kPowerUpBaud, {kUnaddressed});
}

void ChainLook::onReply(const ReplyEnd& end) {
    const Probe& probe = m_probes[m_at];
    if (m_asksIdentity) {
        m_unaddressedIdentity = end.report.identity;
        m_asksIdentity = !m_unaddressedIdentity && ++m_identityAsks < kRounds;
        m_at += m_asksIdentity ? 0 : 1;
        return;
    }
    const bool again = std::exchange(m_again, false);
    const bool zerosHeard = std::exchange(m_zerosHeard, false);
    if (!end.bytes.empty() && !heard(probe, end, again, zerosHeard))
        return;
    ++m_at;
}

/// Somebody answers. False when the same has to be asked again.
bool ChainLook::heard(const Probe& probe, const ReplyEnd& end, bool again, bool zerosHeard) {
    const bool right = end.result == ReplyResult::Accepted || end.result == ReplyResult::Refused;
    const bool unaddressed = probe.address == kUnaddressed;
    if (uniform({end.bytes.data(), end.bytes.size()})) {
        // A PIC-STEP at rest without motor power says so with zeros; its type is another number (DS-S 5.2).
        m_zerosHeard = right && !zerosHeard;
        m_zeros += m_zerosHeard ? 0U : 1U;
        return !m_zerosHeard;
    }
    if (!right) {
        // Noise passes, an echo is known the next time, and so is how long an adapter pauses.
        m_again = m_waits = !again;
        if (m_again)
            return false;
        // Twice at an address of the chain: two modules answer at once.
        if (!unaddressed)
            m_collided.push_back(m_found.size() + m_collided.size());
        else
            ++m_noise;
    } else if (unaddressed) {
        m_unaddressed = m_asksIdentity = true;
        return false;
    } else {
        found(probe);
    }
    return true;
}

void ChainLook::found(const Probe& probe) {
    if (!m_rate) {
        // All of one chain: whatever answered, the rest of it is here.
        m_rate = probe.rate;
        const auto rest = m_probes.begin() + static_cast<std::ptrdiff_t>(m_at) + 1;
        m_probes.erase(
            std::remove_if(rest, m_probes.end(), [&](const Probe& p) { return p.rate != probe.rate; }),
            m_probes.end());
    }
    m_found.insert(std::upper_bound(m_found.begin(), m_found.end(), probe.address), probe.address);
}

std::optional<ConnectFailure> ChainLook::trouble() const {
    if (!m_collided.empty())
        return ConnectFailure::Collision;
    if (m_zeros > 0)
        return ConnectFailure::HeldLow;
    if (!m_rate && !m_unaddressed)
        return m_noise > 0 ? ConnectFailure::Garbled : ConnectFailure::NobodyAnswers;
    return std::nullopt;
}

}  // namespace nmc::bus
