// SPDX-License-Identifier: MIT
#include "bus/discovery.h"

#include <array>
#include <utility>

namespace nmc::bus {

namespace {

constexpr BusAddress kEverybody{0xFF};
constexpr BusAddress kUnaddressed{0x00};

/// Where a chain may have been left; last the rate at which it then wakes up.
constexpr std::array<std::uint32_t, 4> kRestartRates{115'200, 57'600, 9'600, kPowerUpBaud};
static_assert(kRestartRates.size() == kBaudRows.size());

[[nodiscard]] BusAddress addressOf(std::size_t index) {
    return BusAddress(static_cast<std::uint8_t>(index + 1));
}

[[nodiscard]] ModuleIndex indexOf(std::size_t index) {
    return ModuleIndex(static_cast<std::uint8_t>(index));
}

}  // namespace

Discovery::Next Discovery::next() {
    switch (m_phase) {
        case Phase::Restart:
            enter(Phase::Set, ConnectStage::Addressing);
            return restartScript();
        case Phase::Set:
            return setAddress();
        case Phase::Probe:
            return Ask{{addressOf(m_modules.size()), Nop{}.encode(), {}},
                       static_cast<std::uint8_t>(m_setAttempts < 2 ? 1 : 0)};
        case Phase::Identify:
            return askModule(ReadStatus{StatusItems(StatusItems::Identity)}.encode(),
                             StatusItems(StatusItems::Identity), 2);
        case Phase::ChangeRate:
            enter(Phase::Verify);
            return rateScript();
        case Phase::Verify:
            return askModule(Nop{}.encode(), StatusItems{}, 1);
        case Phase::Define:
            return askModule(DefineStatus{kStandingItems}.encode(), kStandingItems, 2);
        case Phase::Done:
            return ChainFound{m_modules, m_config.baud};
        case Phase::Failed:
            break;
    }
    return m_failure;
}

void Discovery::onReply(const ReplyEnd& end) {
    const bool accepted = end.result == ReplyResult::Accepted;
    switch (m_phase) {
        case Phase::Set:
            return onAddress(end);
        case Phase::Probe:
            return onProbe(end);
        case Phase::Identify:
            if (!accepted || !end.report.identity)
                return fail(ConnectFailure::Garbled, {indexOf(m_at)});
            m_modules[m_at].identity = *end.report.identity;
            return nextModule(Phase::ChangeRate);
        case Phase::Verify:
            // A module that flags an error has heard something at this rate, but not well enough.
            if (!accepted)
                m_deaf.push_back(indexOf(m_at));
            return nextModule(Phase::Define);
        case Phase::Define:
            if (!accepted)
                return fail(ConnectFailure::Garbled, {indexOf(m_at)});
            return nextModule(Phase::Done);
        case Phase::Restart:
        case Phase::ChangeRate:
        case Phase::Done:
        case Phase::Failed:
            return;
    }
}

std::optional<ConnectProgress> Discovery::takeProgress() {
    return std::exchange(m_progress, std::nullopt);
}

Line::Script Discovery::restartScript() const {
    const PacketBytes reset = toPacket({kEverybody, HardReset{}.encode()});
    // The port's rate must not change before its own buffer has run empty; the adapter may lag.
    const Line::Pause leaves{kTurnaround + std::max(m_config.adapterLatency, kMinLatency)};
    Line::Script script{Line::Gap{}};
    for (const std::uint32_t rate : kRestartRates)
        script.insert(script.end(), {SetHostBaud{rate}, Line::Nulls{}, Line::Pause{kAfterNulls},
                                     Line::Packet{reset}, leaves});
    // Nulls behind a stray AA are a Reset Position to address 0: harmless now, everything was just reset.
    script.insert(script.end(), {Line::Pause{m_config.resetWait}, DiscardInput{}, Line::Nulls{},
                                 Line::Pause{kAfterNulls + std::max(m_config.adapterLatency, kMinLatency)},
                                 DiscardInput{}});
    return script;
}

Line::Script Discovery::rateScript() const {
    const auto row = findBaud(m_config.baud);  // the engine has checked that there is one
    const Line::Packet change{toPacket({kEverybody, SetBaud{row ? row->brd : kPowerUpBrd}.encode()})};
    return {change, Line::Pause{kTurnaround + std::max(m_config.adapterLatency, kMinLatency)},
            SetHostBaud{m_config.baud}, DiscardInput{}};
}

Discovery::Ask Discovery::setAddress() const {
    return {{kUnaddressed, SetAddress{addressOf(m_modules.size()), kEverybody, false}.encode(), {}}, 0};
}

Discovery::Ask Discovery::askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const {
    return {{m_modules[m_at].address, payload, {m_modules[m_at].identity.type, items}}, repeats};
}

void Discovery::onAddress(const ReplyEnd& end) {
    ++m_setAttempts;
    switch (end.result) {
        case ReplyResult::Accepted:
            return found();
        case ReplyResult::Refused:
            return fail(ConnectFailure::Garbled, {indexOf(m_modules.size())});
        case ReplyResult::Partial:
        case ReplyResult::BadChecksum:
            m_heardNoise = true;
            [[fallthrough]];
        case ReplyResult::Silent:
            // Carried out with its answer lost, or not: ask at the new address before anything else (link.md
            // 2.3). Another Set Address to 0 would give the next module the same address.
            return enter(Phase::Probe);
    }
}

void Discovery::onProbe(const ReplyEnd& end) {
    switch (end.result) {
        case ReplyResult::Accepted:
        case ReplyResult::Refused:
            return found();
        case ReplyResult::Partial:
        case ReplyResult::BadChecksum:
            return fail(ConnectFailure::Garbled, {indexOf(m_modules.size())});
        case ReplyResult::Silent:
            return m_setAttempts < 2 ? enter(Phase::Set) : endOfChain();
    }
}

void Discovery::found() {
    m_modules.push_back({indexOf(m_modules.size()), addressOf(m_modules.size()), {}});
    m_setAttempts = 0;
    enter(Phase::Set, ConnectStage::Addressing);
    if (m_modules.size() == kMaxModules)
        endOfChain();
}

void Discovery::endOfChain() {
    if (m_modules.empty())
        return fail(m_heardNoise ? ConnectFailure::Garbled : ConnectFailure::NobodyAnswers);
    m_at = 0;
    enter(Phase::Identify, ConnectStage::Identifying);
}

void Discovery::nextModule(Phase after) {
    ++m_at;
    // A module without a data sheet keeps the status it woke up with.
    while (m_phase == Phase::Define && m_at < m_modules.size() && !knownType(m_modules[m_at].identity.type))
        ++m_at;
    if (m_at < m_modules.size())
        return;
    m_at = 0;
    if (m_phase == Phase::Verify && !m_deaf.empty())
        return fail(ConnectFailure::RateChange, m_deaf);
    if (after == Phase::ChangeRate) {
        if (m_config.baud != kPowerUpBaud)
            return enter(Phase::ChangeRate, ConnectStage::ChangingRate);
        after = Phase::Define;
    }
    if (after != Phase::Define)
        return enter(after);
    while (m_at < m_modules.size() && !knownType(m_modules[m_at].identity.type))
        ++m_at;
    enter(m_at < m_modules.size() ? Phase::Define : Phase::Done, ConnectStage::Preparing);
}

void Discovery::fail(ConnectFailure reason, std::vector<ModuleIndex> modules) {
    const std::uint32_t rate = reason == ConnectFailure::RateChange ? m_config.baud : kPowerUpBaud;
    m_failure = {reason, std::move(modules), rate};
    m_phase = Phase::Failed;
}

void Discovery::enter(Phase phase, std::optional<ConnectStage> stage) {
    m_phase = phase;
    if (stage)
        m_progress = ConnectProgress{*stage, static_cast<std::uint8_t>(m_modules.size())};
}

}  // namespace nmc::bus
