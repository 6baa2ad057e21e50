// SPDX-License-Identifier: MIT
#include "bus/discovery.h"

#include <array>
#include <utility>

#include "protocol/baud.h"
#include "protocol/commands.h"

namespace nmc::bus {

namespace {

/// Beyond this number, a search that continues is out of control.
constexpr std::uint8_t kLastNumber = 100;
/// This many consecutive addresses without an answer mean the end of the chain, provided that its last module
/// keeps answering.
constexpr unsigned kSetAttempts = 2;
/// Number of queries, at least a tenth of a second apart, that a module must leave unanswered before the line
/// is considered disturbed.
constexpr unsigned kAliveAttempts = 10;
/// This many wrong answers in a row at a number that was just assigned are not the line's fault.
constexpr unsigned kWrongAttempts = 3;

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

[[nodiscard]] Ask question(const Request& request, std::uint8_t silentRepeats, Quarantine quarantine) {
    Ask ask;
    ask.purpose = Purpose::Connect;
    ask.request = request;
    ask.silentRepeats = silentRepeats;
    ask.quarantine = quarantine;
    return ask;
}

[[nodiscard]] ModuleIndex indexOf(std::size_t index) {
    return ModuleIndex(static_cast<std::uint8_t>(index));
}

}  // namespace

Discovery::Discovery(const EngineConfig& config, Start start)
    : m_config(config),
      m_look(ratesToSearch(config), addressesOf(config.known)),
      m_phase(start == Start::Look ? Phase::Look : Phase::Restart),
      m_expected(start == Start::Restart),
      m_progress(
          ConnectProgress{start == Start::Look ? ConnectStage::Looking : ConnectStage::Restarting, 0}) {}

bool Discovery::resume() {
    if (m_phase < Phase::Set || m_phase > Phase::Identify || !givesAddresses())
        return false;
    // The last number sent may have been received, unless that has already been determined.
    const BusAddress last(m_number);
    if (m_phase == Phase::Set &&
        std::ranges::find(m_modules, last, &ModuleInfo::address) == m_modules.end() &&
        !m_recheck.contains(last))
        m_phase = Phase::Probe;
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
            enter(Phase::Set, ConnectStage::Addressing);
            return restartScript();
        case Phase::Set:
            return setAddress();
        case Phase::Probe:
            return probe(BusAddress(m_number), m_unheardInRow + 1 < kSetAttempts ? 1 : 0);
        case Phase::Alive:
            return stillThere();
        case Phase::Recheck:
            return m_recheck.next() ? probe(*m_recheck.next(), 0) : stillThere();
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
        return question(*request, 0, Quarantine::None);
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
        for (const BusAddress address : m_look.addresses())
            m_modules.push_back({indexOf(m_modules.size()), address, {}, {}});
        enter(Phase::Identify, ConnectStage::Identifying);
    } else if (m_config.readOnly) {
        fail(ConnectFailure::Unaddressed);
        return m_failure;
    } else {
        m_expected = m_look.unaddressed();
        enter(Phase::Set, ConnectStage::Addressing);
    }
    // The search may have ended at another rate, or with a module that received part of a command.
    return Line::toRate(m_look.rate().value_or(kPowerUpBaud));
}

void Discovery::onReply(const ReplyEnd& end) {
    const bool accepted = end.result == ReplyResult::Accepted;
    switch (m_phase) {
        case Phase::Look:
            return onLook(end);
        case Phase::Set:
            return onAddress(end);
        case Phase::Probe:
            return onProbe(end);
        case Phase::Alive:
            return onAlive(end);
        case Phase::Recheck:
            return m_recheck.next() ? onRecheck(end) : onAlive(end);
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

/// Always sends the next number: if the previous one was received and its answers were lost, the next module
/// would take it as well.
Ask Discovery::setAddress() {
    const SetAddress set{BusAddress(++m_number), kEverybody, false};
    Ask ask = question({kUnaddressed, encode(set), {}}, 0, Quarantine::Brief);
    ask.refusedAttempts = 1;
    return ask;
}

/// Defines the items of all further replies; on a read-only connection, what others have defined is kept.
Ask Discovery::defineItems(StatusItems items) const {
    return askModule(m_config.readOnly ? encode(ReadStatus{items}) : encode(DefineStatus{items}), items, 2);
}

/// The reply differs in length from the answer to Set Address, which may still be on its way.
Ask Discovery::probe(BusAddress address, std::uint8_t repeats) const {
    return question({address, encode(ReadStatus{kIdentityItems}), {{}, kIdentityItems}}, repeats,
                    Quarantine::Brief);
}

/// The reply has the same length as the answers to Set Address, which are valid even when late.
Ask Discovery::stillThere() const {
    const BusAddress address = m_modules.empty() ? kUnaddressed : m_modules.back().address;
    return question({address, encode(Nop{}), {}}, 0, Quarantine::Full);
}

Ask Discovery::askModule(const Payload& payload, StatusItems items, std::uint8_t repeats) const {
    return question({m_modules[m_at].address, payload, {m_modules[m_at].identity, items}}, repeats,
                    Quarantine::Full);
}

void Discovery::onLook(const ReplyEnd& end) {
    const std::size_t before = m_look.addresses().size();
    m_look.onReply(end);
    if (m_look.addresses().size() != before)
        m_progress = ConnectProgress{ConnectStage::Looking, static_cast<std::uint8_t>(before + 1)};
}

void Discovery::onAddress(const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted)
        return found(BusAddress(m_number));
    m_heardNoise = m_heardNoise || !end.bytes.empty();
    // Either it was carried out and the answer was lost, or it was not: the new address is queried before
    // anything else (link.md 2.3). At what seems to be the end of the chain, this is the first query of the
    // recheck.
    if (end.bytes.empty() && m_unheardInRow + 1 == kSetAttempts) {
        m_recheck.add(BusAddress(m_number));
        return endOfAddressing();
    }
    enter(Phase::Probe);
}

void Discovery::onProbe(const ReplyEnd& end) {
    switch (end.result) {
        case ReplyResult::Accepted:
        case ReplyResult::Refused:
            return found(BusAddress(m_number));
        case ReplyResult::Surplus:
        case ReplyResult::Partial:
        case ReplyResult::BadChecksum:
        case ReplyResult::Rejected:
        case ReplyResult::Echo:
            if (++m_wrongInRow < kWrongAttempts)
                return;
            return fail(
                end.result == ReplyResult::Surplus ? ConnectFailure::Collision : ConnectFailure::Garbled,
                {indexOf(m_modules.size())});
        case ReplyResult::Unresponsive:
            m_recheck.add(BusAddress(m_number));
            m_aliveInVain = 0;
            m_wrongInRow = 0;
            return m_modules.empty() && !m_expected ? onNumberUnheard() : enter(Phase::Alive);
    }
}

/// Silence means the end of the chain only if a module is heard right after it. Otherwise the number may have
/// been taken, and the search waits for the line. Of a chain none of whose modules is known yet, the one
/// without an address is queried; if it stays silent, it has perhaps taken the number.
void Discovery::onAlive(const ReplyEnd& end) {
    const bool heard = !unanswered(end.result);
    if (!heard && ++m_aliveInVain < kAliveAttempts)
        return;
    if (!heard && !m_modules.empty())
        return fail(ConnectFailure::Disturbed, {indexOf(m_modules.size() - 1)});
    if (!heard) {
        m_expected = false;
        return endOfAddressing();
    }
    if (m_phase == Phase::Recheck)
        return onRechecked();
    if (m_aliveInVain > 0)
        return nextNumber();
    onNumberUnheard();
}

void Discovery::onNumberUnheard() {
    if (++m_unheardInRow < kSetAttempts)
        return enter(Phase::Set);
    endOfAddressing();
}

void Discovery::onRecheck(const ReplyEnd& end) {
    const BusAddress address = *m_recheck.next();
    if (m_recheck.onReply(end)) {
        const auto after =
            std::ranges::find_if(m_modules, [&](const ModuleInfo& m) { return address < m.address; });
        m_modules.insert(after, {{}, address, {}, GroupPlace{}});
    } else {
        m_heardNoise = m_heardNoise || !end.bytes.empty();
    }
    if (m_recheck.next())
        return;
    if (m_recheck.found()) {
        m_unheardInRow = 0;
        return nextNumber();
    }
    if (m_modules.empty() && !m_expected)
        endOfChain();
}

/// The last module that is known has answered after a recheck. If it did not do so at once, or any answer was
/// late, the silence of the others shows nothing, and neither does that after the last Set Address.
void Discovery::onRechecked() {
    if (m_aliveInVain == 0 && !m_recheck.doubtful())
        return endOfChain();
    m_recheck.noteInVain();
    if (m_recheck.exhausted())
        return m_modules.empty() ? endOfChain()
                                 : fail(ConnectFailure::Disturbed, {indexOf(m_modules.size() - 1)});
    m_unheardInRow = kSetAttempts - 1;
    nextNumber();
}

void Discovery::nextNumber() {
    m_number < kLastNumber ? enter(Phase::Set) : fail(ConnectFailure::Disturbed);
}

void Discovery::onIdentity(const ReplyEnd& end) {
    const bool heard = end.result == ReplyResult::Accepted && end.report.identity &&
                       !uniform({end.bytes.data(), end.bytes.size()});
    if (!heard)
        return failAnswer(end);
    m_modules[m_at].identity = *end.report.identity;
    nextModule(Phase::ChangeRate);
}

void Discovery::found(BusAddress address) {
    m_modules.push_back({indexOf(m_modules.size()), address, {}, GroupPlace{}});
    m_unheardInRow = 0;
    m_wrongInRow = 0;
    enter(Phase::Set, ConnectStage::Addressing);
    if (m_modules.size() == kMaxModules)
        endOfAddressing();
}

void Discovery::endOfAddressing() {
    if (m_recheck.empty())
        return endOfChain();
    m_aliveInVain = 0;
    m_recheck.begin();
    enter(Phase::Recheck);
}

void Discovery::endOfChain() {
    if (m_modules.empty())
        return fail(m_heardNoise           ? ConnectFailure::Garbled
                    : m_look.unaddressed() ? ConnectFailure::Disturbed  // one has answered
                                           : ConnectFailure::NobodyAnswers);
    for (std::size_t i = 0; i < m_modules.size(); ++i)
        m_modules[i].index = indexOf(i);
    m_addressed = true;
    queryModules();
}

void Discovery::queryModules() {
    m_at = 0;
    m_aliveInVain = 0;
    m_heard.clear();
    enter(Phase::Identify, ConnectStage::Identifying);
}

/// Proceeds to the next module of this phase, or to the following phase.
void Discovery::nextModule(Phase after) {
    ++m_at;
    m_aliveInVain = 0;
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
    if (!m_attached && end.bytes.empty() && ++m_aliveInVain < kAliveAttempts)
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
