// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/rig.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "protocol/baud.h"
#include "sim/line.h"

namespace nmc::test {

using namespace bus;
using namespace std::chrono_literals;

namespace {

constexpr Duration kHandEvery = 100ms;  // interval at which a held button repeats its request
constexpr std::uint32_t kFirstGroupOperation = 10'000;
/// The velocity item only has whole counts per tick (DS-V 5.2); anything slower is left to the mechanics.
constexpr double kStill = 1.5;
/// A module that has restarted is deaf for some ms; its motor coasts.
constexpr Duration kRestarting = 50ms;

/// Number of events of this kind for the operation.
template <typename Finished>
[[nodiscard]] std::size_t endsOf(const FaultyBus& bus, OperationId id) {
    std::size_t n = 0;
    for (const Event& event : bus.events)
        if (const auto* finished = std::get_if<Finished>(&event))
            n += finished->id == id ? 1U : 0U;
    return n;
}

}  // namespace

sim::ChainOptions Rig::optionsOf(const World& world) {
    sim::ChainOptions options;
    options.seed = world.seed;
    options.deafWhenAddressInputRises = world.deafWhenAddressInputRises;
    return options;
}

EngineConfig Rig::configOf(const World& world) {
    EngineConfig config;
    config.baud = world.baud;
    config.readOnly = world.readOnly;
    config.adapterLatency = std::max<Duration>(config.adapterLatency, world.latency);
    return config;
}

Rig::Rig(const World& w)
    : world(w),
      bus(w.chain, configOf(w), optionsOf(w)),
      everOn(w.chain.size()),
      m_oath(*this),
      m_owedStops(*this),
      m_look(*this),
      m_deafUntil(w.chain.size()),
      m_driven(w.chain.size()) {
    bus.adapterDelay = w.latency;
    bus.onCommand = [this](std::vector<std::uint8_t>& bytes) {
        note(bytes);
        if (onPacket)
            onPacket(bytes);
    };
    plugIn();
}

/// Makes the adapter echo if it is of that kind.
void Rig::plugIn() {
    if (world.echoes)
        bus.fault("bus echo");
}

Rig::~Rig() {
    bus.onCommand = nullptr;
}

// ---- Acts ----

void Rig::begin(bool asRestart) {
    m_searching = true;  // a search that is under way is replaced, and has no end of its own
    restartAsked = asRestart && !world.readOnly;
    asRestart ? bus.engine.restart(bus.now) : bus.engine.connect(bus.now);
    settle();
}

void Rig::connect() {
    begin(false);
}

void Rig::restart() {
    begin(true);
}

void Rig::changeRate(std::uint32_t baud) {
    ++m_rateChanges;
    bus.engine.changeRate(baud, bus.now);
    settle();
}

void Rig::distrust() {
    bus.engine.distrust(bus.now);
    settle();
}

void Rig::submit(std::vector<Order> steps) {
    m_oath.forget();
    for (const Order& order : steps)
        if (known && order.module.value() < known->modules.size())
            if (const std::uint8_t place = known->modules[order.module.value()].place; place < size())
                everOn[place] = true;
    m_operations.push_back(bus.submit(std::move(steps)));
}

void Rig::submit(std::variant<GroupChange, GroupCommand> what) {
    m_oath.forget();
    const OperationId id(kFirstGroupOperation + static_cast<std::uint32_t>(m_groupOperations.size()));
    m_groupOperations.push_back(id);
    bus.engine.submit(GroupOperation{id, what}, bus.now);
    settle();
}

void Rig::hold(const HoldToMove& hold, Duration time, bool lapses) {
    m_oath.forget();
    m_hand = Hand{hold, bus.now, bus.now + time, lapses, wire.size()};
    m_hand->hold.press = ++m_presses;
    moveHand();
}

void Rig::moveHand() {
    if (!handIsDue())
        return;
    if (bus.now < m_hand->until) {
        bus.engine.hold(m_hand->hold, bus.now);
        m_hand->next = std::min(bus.now + kHandEvery, m_hand->until);
    } else {
        const Hand ended = *std::exchange(m_hand, std::nullopt);
        const Duration later = ended.lapses ? EngineConfig{}.holdTimeout : Duration{};
        m_owedStops.onHoldEnded(ended.hold, ended.wireFrom, bus.now + later);
        if (ended.lapses)
            return;
        bus.engine.release(bus.now);
    }
    settle();
}

void Rig::stopAll() {
    m_hand.reset();
    observe();
    situations.insert(situation());
    m_oath.asked();
    m_look.stopAsked();
    m_owedStops.forget();
    bus.engine.stopAll(bus.now);
    settle();
    observe();
}

/// The situation in which the stop is requested.
std::string Rig::situation() const {
    if (stopping())
        return "a stop";
    if (searching())
        return known ? "a search for a chain that was known" : "a search for an unknown chain";
    if (!known)
        return "no chain";
    if (rateChanging())
        return "a change of rate";
    if (lost)
        return "a lost link";
    if (bus.now < faultsUntil)
        return "a bad line";
    return m_foundNobody ? "a search in vain" : "a chain that is well";
}

void Rig::replaceEngine(std::uint32_t baud, bool readOnly) {
    expectEnds();
    world.baud = baud;
    world.readOnly = readOnly;
    bus.newHost(configOf(world));
    bus.events.clear();
    bus.sent.clear();
    known.reset();
    m_hand.reset();
    m_oath.reset();
    m_owedStops.forget();
    m_searching = m_searchesItself = false;
    m_operations.clear();
    m_groupOperations.clear();
    m_rateChanges = m_rateEnds = 0;
    m_seen = 0;
    restartAsked = lost = m_givenUp = false;
    m_look.begin();
}

void Rig::powerCycle(std::uint8_t place) {
    m_powerCycled = true;
    m_oath.forget();
    m_owedStops.forget();
    m_look.onPowerCycle(place);
    m_deafUntil[place] = std::max(m_deafUntil[place], bus.now + kRestarting);
    faultsUntil = std::max(faultsUntil, bus.now + kRestarting);
    bus.chain.powerCycle(ModuleIndex(place), bus.now);
}

void Rig::fault(const std::string& line, Duration time, bool deafens, std::optional<std::uint8_t> place) {
    const TimePoint until = bus.now + time;
    m_foreignHost = m_foreignHost || line.starts_with("foreign");
    noisyCommands = noisyCommands || line.starts_with("noise cmd");
    faultsUntil = std::max(faultsUntil, until);
    for (std::uint8_t i = 0; deafens && i < size(); ++i)
        if (!place || *place == i)
            m_deafUntil[i] = std::max(m_deafUntil[i], until);
    const std::string target = place ? "module " + std::to_string(*place + 1) : std::string("bus");
    const std::string lasts =
        line.find(" n=") == std::string::npos ? " for=" + std::to_string(time / 1us) + "us" : "";
    bus.fault(target + " " + line + lasts);
}

void Rig::clearFaults() {
    bus.clearFaults();
    plugIn();
    faultsUntil = std::min(faultsUntil, bus.now);
    for (TimePoint& until : m_deafUntil)
        until = std::min(until, bus.now);
}

void Rig::load(std::uint8_t place, double newtonMetres) {
    m_driven[place] = true;
    bus.chain.set(ModuleIndex(place), sim::Input::Load, newtonMetres, bus.now);
}

// ---- Time ----

void Rig::run(Duration time) {
    static_cast<void>(runUntil([] { return false; }, time));
}

std::uint64_t Rig::bytesCrossed() const {
    const sim::ChainStatistics statistics = bus.chain.statistics();
    return statistics.bytesIn + statistics.bytesOut;
}

void Rig::runBytes(std::uint64_t bytes, Duration limit) {
    const std::uint64_t wanted = bytesCrossed() + bytes;
    static_cast<void>(runUntil([&] { return bytesCrossed() >= wanted; }, limit));
}

void Rig::runToRest() {
    const auto ended = [&] { return !searching() && !stopping() && !rateChanging(); };
    static_cast<void>(runUntil(ended, StopOath::kSearchBound));
    run(StopOath::kStopBound + 100ms);
}

void Rig::expectEnds() {
    observe();
    for (const OperationId id : m_operations)
        if (const auto n = endsOf<OperationFinished>(bus, id); n != 1)
            complain("finished: " + std::to_string(n) + " ends of operation " + std::to_string(id.value()));
    for (const OperationId id : m_groupOperations)
        if (const auto n = endsOf<GroupFinished>(bus, id); n != 1)
            complain("finished: " + std::to_string(n) + " ends of group operation " +
                     std::to_string(id.value()));
    if (m_searching)
        complain("finished: a search has no end");
    if (m_rateEnds != m_rateChanges)
        complain("finished: " + std::to_string(m_rateEnds) + " ends of " + std::to_string(m_rateChanges) +
                 " changes of rate");
    if (world.readOnly)
        m_look.check();
}

// ---- Truth ----

bool Rig::isOn(std::uint8_t place) {
    const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
    if (truth.stepper)
        return truth.stepper->ampEnabled || truth.stepper->moving;
    return truth.servo.servoOn || truth.servo.pwm != 0;
}

bool Rig::resetOnTheWay(std::uint8_t place) {
    auto last = wire.rbegin();
    TimePoint left = lineFree;
    for (; last != wire.rend() && last->packet.empty(); ++last)
        left -= byteTimeAtBaud(last->baud) * static_cast<Duration::rep>(last->nulls);
    if (last == wire.rend() || last->code() != CommandCode::HardReset || left + kServoTick <= bus.now)
        return false;
    const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
    return last->address() == truth.address || last->address() == truth.group;
}

bool Rig::atRest(std::uint8_t place) {
    const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
    if (truth.stepper)
        return !truth.stepper->moving;
    const bool commanded = truth.servo.servoOn && truth.servo.commandVelocity != 0;
    return !commanded && std::abs(truth.servo.velocity) < kStill;
}

double Rig::shaft(std::uint8_t place) {
    const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
    return truth.stepper ? static_cast<double>(truth.stepper->shaft) : truth.servo.shaftCounts;
}

bool Rig::hears(std::uint8_t place, std::uint8_t address, std::uint32_t baud) {
    const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
    return truth.listening && truth.address == address && sim::garbleProbability(truth.baud, baud) <= 0 &&
           bus.now >= m_deafUntil[place];
}

std::uint64_t Rig::replies(std::uint8_t place) const {
    return bus.chain.statistics().modules[place].replies;
}

void Rig::complain(const std::string& what) {
    char time[32];
    std::snprintf(time, sizeof time, " [%.6f s]", toSeconds(bus.now.time_since_epoch()));
    complaints.push_back(what + time);
}

// ---- What is seen ----

void Rig::note(ByteSpan bytes) {
    lineFree =
        std::max(lineFree, bus.now) + static_cast<Duration::rep>(bytes.size()) * byteTimeAtBaud(bus.hostBaud);
    for (WireItem& item : itemsOf(bytes, bus.now, bus.hostBaud)) {
        for (std::uint8_t place = 0; item.isStop() && place < size(); ++place) {
            const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
            const bool meant = item.address() == truth.address || item.address() == truth.group;
            item.places |= meant ? 1U << place : 0U;
        }
        m_oath.onSent(item);
        m_owedStops.onSent(item);
        if (world.readOnly)
            m_look.onSent(item);
        wire.push_back(std::move(item));
    }
}

void Rig::observe() {
    for (; m_seen < bus.events.size(); ++m_seen)
        handle(bus.events[m_seen]);
    m_oath.onTime();
    m_owedStops.onTime();
}

void Rig::handle(const Event& event) {
    if (const auto* found = std::get_if<ChainFound>(&event)) {
        chainFound(*found);
    } else if (std::holds_alternative<ConnectFailed>(event)) {
        searchEnded(false);
    } else if (std::holds_alternative<ConnectProgress>(event)) {
        m_searchesItself = m_givenUp;  // it does once all answers are right again
    } else if (const auto* changed = std::get_if<RateChanged>(&event)) {
        ++m_rateEnds;
        if (known)
            known->baud = changed->baud;
    } else if (std::holds_alternative<RateChangeFailed>(event)) {
        ++m_rateEnds;
    } else if (std::holds_alternative<LinkLost>(event)) {
        lost = true;
    } else if (const auto* silence = std::get_if<ModuleUnresponsive>(&event)) {
        lost = lost && silence->silent;
    } else if (const auto* restarted = std::get_if<ModuleRestarted>(&event)) {
        if (restarted->quiet && !world.readOnly)
            m_oath.stopsByItself();
    } else if (const auto* health = std::get_if<HealthChanged>(&event)) {
        if (!health->module)
            m_givenUp = health->health == LinkHealth::Lost;
        if (m_givenUp && !health->module && !world.readOnly)
            m_oath.stopsByItself();
    } else if (std::holds_alternative<ForeignTraffic>(event) && !m_foreignHost) {
        complain("foreign: nobody else is on the line");
    } else if (std::holds_alternative<ForeignMotion>(event)) {
        complain("foreign: nobody else moves a motor");
    } else if (const auto* finished = std::get_if<StopFinished>(&event)) {
        m_oath.onFinished(*finished);
    }
    m_owedStops.onEvent(event);
    if (world.readOnly)
        m_look.onEvent(event);
}

void Rig::searchEnded(bool found) {
    m_foundNobody = !found;
    const bool asked = std::exchange(m_searching, false);
    const bool itself = std::exchange(m_searchesItself, false);
    if (!asked && !itself)
        complain("finished: an end of a search that nobody asked for");
}

void Rig::chainFound(const ChainFound& found) {
    searchEnded(true);
    lost = m_givenUp = false;
    KnownChain chain;
    chain.baud = found.baud;
    for (const ModuleInfo& info : found.modules) {
        KnownChain::Module module{KnownChain::kNowhere, info.address.value()};
        unsigned there = 0;
        for (std::uint8_t place = 0; place < size(); ++place) {
            const sim::ModuleSnapshot truth = bus.chain.snapshot(ModuleIndex(place), bus.now);
            if (truth.address != module.address || sim::garbleProbability(truth.baud, found.baud) > 0)
                continue;
            ++there;
            module.place = place;
            everOn[place] = found.attached ? everOn[place] || isOn(place) : isOn(place);
        }
        const std::string address = std::to_string(module.address);
        // A module that was reset, for instance by a restart of the network that a stop has interrupted, is
        // known to be absent.
        const bool absent = std::ranges::count(found.absent, info.index) != 0;
        // Modules that answer another host may be taken for the one that was queried.
        if (there != 1 && !absent && !m_powerCycled && !m_foreignHost)
            complain("chain: " + std::to_string(there) + " modules have the address " + address);
        else if (there == 1 && bus.chain.identity(ModuleIndex(module.place)) != info.identity)
            complain("chain: address " + address + " is not what it is said to be");
        chain.modules.push_back(module);
    }
    known = std::move(chain);
    m_oath.onChainFound();
}

}  // namespace nmc::test
