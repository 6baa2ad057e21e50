// SPDX-License-Identifier: MIT
#include "bus/chainlook.h"

#include <algorithm>
#include <utility>

namespace nmc::bus {

namespace {

constexpr unsigned kUnaddressed = 0;
constexpr unsigned kFirstAddress = 1;
constexpr unsigned kUsualAddresses = 2;  ///< probed at every rate first
/// A search that skips a number, because nobody was heard to take it, goes beyond 32.
constexpr unsigned kLastAddress = 34;

}  // namespace

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
    if (m_zerosHeard || m_asksIdentity)
        return Request{probe.address, ReadStatus{kIdentityItems}.encode(), {{}, kIdentityItems}};
    // The answer's length hangs on what the host before defined.
    return Request{probe.address, Nop{}.encode(), {}, Framing::Open};
}

/// The probes of the next stage.
void ChainLook::refill() {
    m_probes.clear();
    m_at = 0;
    if (!std::exchange(m_begun, true)) {
        add(kPowerUpBaud, kUnaddressed, kUnaddressed);
        for (const std::uint32_t rate : kRates)
            add(rate, kFirstAddress, kUsualAddresses);
        return;
    }
    switch (m_stage) {
        case Stage::First:
            if (m_rate) {
                m_stage = Stage::Rest;
                add(*m_rate, kUsualAddresses + 1, kLastAddress);
            } else if (m_unaddressed) {
                m_stage = Stage::Over;
            } else {
                m_stage = Stage::Everywhere;
                for (const std::uint32_t rate : kRates)
                    add(rate, kUsualAddresses + 1, kLastAddress);
            }
            return;
        case Stage::Rest:
        case Stage::Everywhere:
        case Stage::Over:
            m_stage = Stage::Over;
            return;
    }
}

void ChainLook::add(std::uint32_t rate, unsigned from, unsigned to) {
    for (unsigned address = from; address <= to; ++address)
        m_probes.push_back({rate, BusAddress(static_cast<std::uint8_t>(address))});
}

void ChainLook::onReply(const ReplyEnd& end) {
    const Probe& probe = m_probes[m_at];
    if (std::exchange(m_asksIdentity, false)) {
        m_unaddressedIdentity = end.report.identity;
        ++m_at;
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
    const bool unaddressed = probe.address.value() == kUnaddressed;
    if (uniform({end.bytes.data(), end.bytes.size()})) {
        // A PIC-STEP at rest without motor power says so with zeros; its type is another number (DS-S 5.2).
        m_zerosHeard = right && !zerosHeard;
        m_zeros += m_zerosHeard ? 0U : 1U;
        return !m_zerosHeard;
    }
    if (!right) {
        m_again = !again;  // noise passes, and an echo is known the next time
        if (m_again)
            return false;
        // Twice where the chain is: two modules answer at once.
        if (m_rate == probe.rate || !unaddressed)
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
    m_found.push_back(probe.address);
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
