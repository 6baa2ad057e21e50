// SPDX-License-Identifier: MIT
#include "bus/chainlook.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

namespace {

constexpr unsigned kFirstAddress = 1;
constexpr unsigned kUsualAddresses = 2;  ///< probed first at each rate
/// Two lost answers in a row do not hide a module.
constexpr unsigned kRounds = 3;
/// For unusual addresses at rates where nothing else answers: three rounds of all of them would cost ten
/// seconds whenever a chain has no power.
constexpr unsigned kUnusualRounds = 2;
/// A search that skips a number, because no module was heard to take it, goes beyond 32.
constexpr unsigned kLastAddress = 34;

template <typename T>
void addNew(std::vector<T>& list, const T& value) {
    if (std::ranges::find(list, value) == list.end())
        list.push_back(value);
}

}  // namespace

ChainLook::ChainLook(std::vector<std::uint32_t> rates, std::vector<BusAddress> addresses)
    : m_rates(std::move(rates)), m_known(std::move(addresses)) {
    for (unsigned address = kFirstAddress; address <= kLastAddress; ++address)
        (m_first.size() < kUsualAddresses ? m_first : m_rest)
            .emplace_back(static_cast<std::uint8_t>(address));
    const std::size_t usual = std::min<std::size_t>(m_known.size(), kUsualAddresses);
    for (std::size_t i = 0; i < m_known.size(); ++i)
        addNew(i < usual ? m_first : m_rest, m_known[i]);
    const auto asked = [this](BusAddress address) {
        return std::ranges::find(m_first, address) != m_first.end();
    };
    std::erase_if(m_rest, asked);
    std::ranges::sort(m_rest);
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
    if (std::exchange(m_waits, false))  // discards the rest of a reply that came in pieces
        return Line::Script{Line::Pause{kLongestReplyGap}, DiscardInput{}};
    if (m_zerosHeard || m_asksIdentity)
        return Request{probe.address, encode(ReadStatus{kIdentityItems}), {{}, kIdentityItems}};
    // The length of the reply depends on what the previous host defined.
    return Request{probe.address, encode(Nop{}), {}, Framing::Open};
}

/// Fills the probes of the next round, or enters the next stage.
void ChainLook::refill() {
    m_probes.clear();
    m_at = 0;
    switch (m_stage) {
        case Stage::First:
            if (!m_rate && m_round < kRounds)
                return refillUsual();
            if (!m_rate && m_unaddressed)
                break;
            return enter(m_rate ? Stage::Rest : Stage::Everywhere);
        case Stage::Everywhere:
            if (trouble() == ConnectFailure::NobodyAnswers && m_round++ < kUnusualRounds) {
                for (const std::uint32_t rate : m_rates)
                    add(rate, m_rest);
                return;
            }
            m_patient = trouble() == ConnectFailure::NobodyAnswers;
            if (m_patient)
                return enter(Stage::Patiently);
            if (trouble())
                break;
            return enter(Stage::Missing);
        case Stage::Patiently:
            if (!m_rate && m_round < (m_unaddressed ? kRounds : 1))
                return refillUsual();
            if (!m_rate)
                break;
            return enter(Stage::Rest);
        case Stage::Rest:
            if (m_round++ == 0)
                return add(*m_rate, m_rest);
            if (trouble())
                break;
            return enter(Stage::Missing);
        case Stage::Missing:
            if (m_round < kRounds - 1 || (m_doubtful && m_round < kMostRounds))
                return refillMissing();
            break;
        case Stage::Over:
            break;
    }
    m_stage = Stage::Over;
}

/// There may be a chain in addition to a module without an address.
void ChainLook::refillUsual() {
    ++m_round;
    addUnaddressed();
    for (const std::uint32_t rate : m_rates)
        add(rate, m_unaddressed ? missing() : m_first);
}

/// All addresses have been probed once by now. The last round is patient, and is repeated if an answer was
/// late before its end or a module was found in it: where one was read too late, others may have been, too.
void ChainLook::refillMissing() {
    ++m_round;
    m_patient = m_patient || m_round == kRounds - 1;
    if (m_round >= kRounds)
        m_doubtful = false;
    add(*m_rate, missing());
    addUnaddressed();
}

/// The usual first addresses if no module was found; otherwise up to two after the last one, because one of
/// these may belong to a module that has restarted.
std::vector<BusAddress> ChainLook::missing() const {
    std::vector<BusAddress> addresses;
    const unsigned last = (m_found.empty() ? 0U : m_found.back().value()) + kUsualAddresses;
    for (unsigned address = kFirstAddress; address <= std::min(last, kLastAddress); ++address)
        addresses.emplace_back(static_cast<std::uint8_t>(address));
    for (const BusAddress address : m_known)
        addNew(addresses, address);
    return addresses;
}

/// Adds those that have not answered yet.
void ChainLook::add(std::uint32_t rate, const std::vector<BusAddress>& addresses) {
    for (const BusAddress address : addresses)
        if (std::ranges::find(m_found, address) == m_found.end())
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

/// Handles an answer. Returns false if the same query must be repeated.
bool ChainLook::heard(const Probe& probe, const ReplyEnd& end, bool again, bool zerosHeard) {
    const bool right = !unanswered(end.result);
    const bool unaddressed = probe.address == kUnaddressed;
    if (uniform({end.bytes.data(), end.bytes.size()})) {
        // A PIC-STEP at rest without motor power answers with zeros; its type is another number (DS-S 5.2).
        m_zerosHeard = right && !zerosHeard;
        m_zeros += m_zerosHeard ? 0U : 1U;
        return !m_zerosHeard;
    }
    if (!right) {
        // Noise passes, and an echo, or the pause of an adapter, is known at the next attempt.
        m_again = m_waits = !again;
        if (m_again)
            return false;
        // Garbled twice at an address of the chain: two modules answer at once.
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
        // The modules of a chain share one rate: if one answered, the others are here as well.
        m_rate = probe.rate;
        const auto rest = m_probes.begin() + static_cast<std::ptrdiff_t>(m_at) + 1;
        m_probes.erase(
            std::remove_if(rest, m_probes.end(), [&](const Probe& p) { return p.rate != probe.rate; }),
            m_probes.end());
    }
    m_doubtful = m_doubtful || m_stage == Stage::Missing;
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
