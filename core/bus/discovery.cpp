// SPDX-License-Identifier: MIT
#include "bus/discovery.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/baud.h"
#include "protocol/commands.h"

namespace nmc::bus {

namespace {

/// Rates other than that after power-up at which a chain is often left.
constexpr std::array<std::uint32_t, 3> kUsualRates{115'200, 57'600, 9'600};
static_assert(kUsualRates.size() + 1 == kBaudRows.size());

/// Rates other than that after power-up at which the chain may have been left.
[[nodiscard]] std::vector<std::uint32_t> otherRates(const EngineConfig& config) {
    if (config.fixedRate)
        return {};
    std::vector<std::uint32_t> rates(kUsualRates.begin(), kUsualRates.end());
    for (const std::uint32_t rate : {config.baud, config.knownBaud})
        if (rate != 0 && rate != kPowerUpBaud && std::ranges::find(rates, rate) == rates.end())
            rates.push_back(rate);
    return rates;
}

/// That after power-up comes first.
[[nodiscard]] std::vector<std::uint32_t> ratesToSearch(const EngineConfig& config) {
    std::vector<std::uint32_t> rates = otherRates(config);
    rates.insert(rates.begin(), kPowerUpBaud);
    return rates;
}

[[nodiscard]] std::vector<BusAddress> addressesOf(const std::vector<ModuleInfo>& modules) {
    std::vector<BusAddress> addresses;
    for (const ModuleInfo& module : modules)
        addresses.push_back(module.address);
    return addresses;
}

[[nodiscard]] ModuleIndex indexOf(std::size_t index) {
    return ModuleIndex(static_cast<std::uint8_t>(index));
}

}  // namespace

Discovery::Discovery(const EngineConfig& config, Start start)
    : m_config(config),
      m_look(ratesToSearch(config), addressesOf(config.known)),
      m_addressing(start == Start::Restart),
      m_phase(start == Start::Look ? Phase::Look : Phase::Restart),
      m_progress(
          ConnectProgress{start == Start::Look ? ConnectStage::Looking : ConnectStage::Restarting, 0}) {}

bool Discovery::resume() {
    if (m_phase < Phase::Addressing || m_phase > Phase::Identify || !givesAddresses())
        return false;
    m_addressing.resume();
    m_resumed = true;
    return true;
}

Discovery::Next Discovery::next() {
    if (std::exchange(m_resumed, false))
        return Line::toRate(kPowerUpBaud);
    switch (m_phase) {
        case Phase::Look:
            return look();
        case Phase::Restart:
            enter(Phase::Addressing, ConnectStage::Addressing);
            return restartScript();
        case Phase::Addressing:
            return addressing();
        case Phase::Identify:
            return askModule(encode(ReadStatus{kIdentityItems}), kIdentityItems, 2);
        case Phase::ChangeRate:
            return changeRate();
        case Phase::Define:
            return defineItems(standingItems(m_modules[m_at].identity));
        case Phase::Confirm:
            return askModule(encode(ReadStatus{kAllItems}), kAllItems, 2);
        case Phase::Done: {
            ChainFound found{m_modules, rate(), m_attached, m_attached && m_look.unaddressed()};
            found.readOnly = m_config.readOnly;
            return found;
        }
        case Phase::Failed:
            break;
    }
    return m_failure;
}

Discovery::Next Discovery::look() {
    auto next = m_look.next();
    if (auto* script = std::get_if<Line::Script>(&next))
        return std::move(*script);
    if (const auto* request = std::get_if<Request>(&next))
        return Ask::toConnect(*request, 0, Quarantine::None);
    return lookedUp();
}

/// Handles the end of the search: attach to the chain found, or assign addresses to one that has none.
Discovery::Next Discovery::lookedUp() {
    if (const auto trouble = m_look.trouble()) {
        std::vector<ModuleIndex> modules;
        for (const std::size_t module : m_look.collided())
            modules.push_back(indexOf(module));
        fail(*trouble, std::move(modules));
        return m_failure;
    }
    if (m_look.rate()) {
        m_attached = true;
        takeModules(m_look.addresses(), {});
        enter(Phase::Identify, ConnectStage::Identifying);
    } else if (m_config.readOnly) {
        fail(ConnectFailure::Unaddressed);
        return m_failure;
    } else {
        m_addressing = Addressing(m_look.unaddressed());
        enter(Phase::Addressing, ConnectStage::Addressing);
    }
    // The search may have ended at another rate, or with a module that received part of a command.
    return Line::toRate(m_look.rate().value_or(kPowerUpBaud));
}

Discovery::Next Discovery::addressing() {
    auto next = m_addressing.next();
    if (auto* ask = std::get_if<Ask>(&next))
        return std::move(*ask);
    takeModules(m_addressing.addresses(), GroupPlace{});
    if (const auto* failed = std::get_if<Addressing::Failed>(&next)) {
        // One without an address has answered before.
        const bool lost = failed->reason == ConnectFailure::NobodyAnswers && m_look.unaddressed();
        fail(lost ? ConnectFailure::Disturbed : failed->reason,
             failed->module ? std::vector{indexOf(*failed->module)} : std::vector<ModuleIndex>{});
        return m_failure;
    }
    queryModules();
    return this->next();
}

void Discovery::onReply(const ReplyEnd& end) {
    const bool accepted = end.result == ReplyResult::Accepted;
    switch (m_phase) {
        case Phase::Look:
            return onLook(end);
        case Phase::Addressing:
            return onAddressing(end);
        case Phase::Identify:
            return onIdentity(end);
        case Phase::ChangeRate:
            return m_rateChange->onReply(end);
        case Phase::Define:
            if (!accepted)
                return failAnswer(end);
            m_heard.push_back({indexOf(m_at), end});
            return nextModule(Phase::Confirm);
        case Phase::Confirm:
            // Sooner or later, two modules at one address give different answers.
            if (!accepted || uniform({end.bytes.data(), end.bytes.size()}) ||
                end.report.identity != m_modules[m_at].identity)
                return failAnswer(end);
            m_heard.push_back({indexOf(m_at), end});
            return nextModule(Phase::Done);
        case Phase::Restart:
        case Phase::Done:
        case Phase::Failed:
            return;
    }
}

Line::Script Discovery::restartScript() const {
    Line::Script script{Line::Gap{}};
    std::vector<std::uint32_t> rates = otherRates(m_config);
    rates.push_back(kPowerUpBaud);
    for (const std::uint32_t rate : rates) {
        script.insert(script.end(), {SetHostBaud{rate}, Line::Nulls{}, Line::Pause{kAfterNulls}});
        // A module that another host put into a different group does not receive FF (DS-V 5.2, faults.md
        // F-48). FF and the power-up rate come last: everything is reset together then, and only the farthest
        // module is enabled.
        for (unsigned group = kFirstGroup; group <= kEverybody.value(); ++group) {
            const BusAddress address(static_cast<std::uint8_t>(group));
            script.insert(script.end(),
                          {Line::Packet{toPacket({address, encode(HardReset{})})}, Line::Spacer{}});
        }
        // The port's rate must not change before its own buffer is empty; the adapter may lag.
        script.emplace_back(Line::Lag{});
    }
    // Nulls after a stray AA form a Reset Position to address 0, which is harmless because everything was
    // just reset.
    script.insert(script.end(), {Line::Pause{m_config.resetWait}, DiscardInput{}, Line::Nulls{},
                                 Line::Lag{kAfterNulls}, DiscardInput{}});
    return script;
}

Discovery::Next Discovery::changeRate() {
    if (!m_rateChange) {
        std::vector<RateChange::Target> chain;
        for (const ModuleInfo& module : m_modules)
            chain.push_back({module.address, {module.identity, StatusItems{}}});
        m_rateChange.emplace(std::move(chain), std::vector{kEverybody}, kPowerUpBaud, m_config.baud,
                             RateChange::WayBack::None);
    }
    auto next = m_rateChange->next();
    if (auto* script = std::get_if<Line::Script>(&next))
        return std::move(*script);
    if (auto* ask = std::get_if<Ask>(&next))
        return std::move(*ask);
    const auto& ended = std::get<RateChange::Ended>(next);
    if (ended.reached) {
        enterModules(Phase::Define);
        return this->next();
    }
    std::vector<ModuleIndex> deaf;
    for (const std::size_t module : ended.deaf)
        deaf.push_back(indexOf(module));
    fail(ConnectFailure::RateChange, std::move(deaf));
    return m_failure;
}

/// Defines the items of all further replies; on a read-only connection, what others have defined is kept.
Ask Discovery::defineItems(StatusItems items) const {
    return askModule(m_config.readOnly ? encode(ReadStatus{items}) : encode(DefineStatus{items}), items, 2);
}

Ask Discovery::askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const {
    return Ask::toConnect({m_modules[m_at].address, payload, {m_modules[m_at].identity, items}}, repeats);
}

void Discovery::onLook(const ReplyEnd& end) {
    const std::size_t before = m_look.addresses().size();
    m_look.onReply(end);
    if (m_look.addresses().size() != before)
        m_progress = ConnectProgress{ConnectStage::Looking, static_cast<std::uint8_t>(before + 1)};
}

void Discovery::onAddressing(const ReplyEnd& end) {
    const std::size_t before = m_addressing.addresses().size();
    m_addressing.onReply(end);
    if (const std::size_t now = m_addressing.addresses().size(); now != before)
        m_progress = ConnectProgress{ConnectStage::Addressing, static_cast<std::uint8_t>(now)};
}

void Discovery::onIdentity(const ReplyEnd& end) {
    const bool heard = end.result == ReplyResult::Accepted && end.report.identity &&
                       !uniform({end.bytes.data(), end.bytes.size()});
    if (!heard)
        return failAnswer(end);
    m_modules[m_at].identity = *end.report.identity;
    nextModule(Phase::ChangeRate);
}

void Discovery::takeModules(const std::vector<BusAddress>& addresses, std::optional<GroupPlace> group) {
    for (const BusAddress address : addresses)
        m_modules.push_back({indexOf(m_modules.size()), address, {}, group});
}

void Discovery::queryModules() {
    m_at = 0;
    m_silentInRow = 0;
    m_heard.clear();
    enter(Phase::Identify, ConnectStage::Identifying);
}

/// Proceeds to the next module of this phase, or to the following phase.
void Discovery::nextModule(Phase after) {
    ++m_at;
    m_silentInRow = 0;
    if (m_phase == Phase::Define || m_phase == Phase::Confirm)
        skipUnknown();
    if (m_at >= m_modules.size())
        enterModules(after);
}

void Discovery::enterModules(Phase phase) {
    m_at = 0;
    if (phase == Phase::ChangeRate && (m_attached || m_config.baud == kPowerUpBaud || m_rateChange))
        phase = Phase::Define;
    if (phase == Phase::ChangeRate)
        return enter(phase, ConnectStage::ChangingRate);
    enter(phase, phase == Phase::Define ? std::optional(ConnectStage::Preparing) : std::nullopt);
    skipUnknown();
    if (m_at >= m_modules.size())
        enter(Phase::Done);
}

/// A module without a data sheet keeps its power-up status.
void Discovery::skipUnknown() {
    while (m_at < m_modules.size() && !isKnown(m_modules[m_at].identity))
        ++m_at;
}

/// A module that answered before no longer does, or keeps answering wrongly. One that has just been given its
/// address and is silent is queried again: a new search might miss it.
void Discovery::failAnswer(const ReplyEnd& end) {
    if (!m_attached && end.bytes.empty() && ++m_silentInRow < Addressing::kAliveAttempts)
        return;
    fail(end.bytes.empty() ? ConnectFailure::Garbled : ConnectFailure::Collision, {indexOf(m_at)});
}

void Discovery::fail(ConnectFailure reason, std::vector<ModuleIndex> modules) {
    const std::uint32_t rate = reason == ConnectFailure::RateChange ? m_config.baud : kPowerUpBaud;
    m_failure = {reason, std::move(modules), rate, m_config.fixedRate};
    m_phase = Phase::Failed;
}

void Discovery::enter(Phase phase, std::optional<ConnectStage> stage) {
    m_phase = phase;
    if (stage)
        m_progress = ConnectProgress{*stage, static_cast<std::uint8_t>(m_modules.size())};
}

}  // namespace nmc::bus
