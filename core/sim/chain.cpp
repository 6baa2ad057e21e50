// SPDX-License-Identifier: MIT
#include "sim/chain.h"

#include <algorithm>
#include <cassert>
#include <deque>
#include <utility>

#include "sim/faultinjector.h"
#include "sim/iomodule.h"
#include "sim/module.h"
#include "sim/random.h"
#include "sim/servomodule.h"
#include "sim/steppermodule.h"

namespace nmc::sim {

namespace {

/// After so many commands, a host whose bytes were read late is known to wait for its answers.
constexpr int kWaitsThatCount = 2;
/// Idle modules are brought up to date at least this often, so that catching up never takes long.
constexpr Duration kCatchUpEvery = std::chrono::milliseconds(100);

constexpr std::string_view kFaultsOff = "faults are not enabled; start with --enable-faults";

}  // namespace

/// The mechanism of the chain: which event is next, and which module it concerns.
class Chain::Private {
public:
    Private(const std::vector<ModuleIdentity>& identities, const ChainOptions& options);

    void runTo(TimePoint now);
    [[nodiscard]] TimePoint nextEvent() const;
    void updateAddressLines();
    void powerUp(std::size_t module);
    void clearFaults();
    /// The first module that owes the host an answer, or nullptr.
    [[nodiscard]] const Module* busyModule() const;
    [[nodiscard]] double garbleChance(const Module& module, std::uint32_t baud) const {
        return garbleProbability(module.baud(), baud, options.lineMargin);
    }

    ChainOptions options;
    std::vector<std::unique_ptr<Module>> modules;
    /// Module::nextEvent() of each module, contiguous because the search for the next event is the inner
    /// loop.
    std::vector<TimePoint> moduleEvents;
    std::vector<bool> addressLineBroken;  ///< between a module and its neighbour towards the host
    HostLine line;
    std::vector<HostByte> toHost;
    ViolationLog violations;
    ChainStatistics statistics;
    FaultInjector faults;
    TimePoint now;
    bool hasteIsUnknown = false;  ///< since bytes were read late, until the host is known to wait again
    TimePoint readLateUntil;      ///< time at which the last byte that was read late leaves the line
    int waited = 0;               ///< commands since then that were sent while no module was busy

private:
    void runModule(std::size_t index);
    void execute(Module& module);
    void sendReplyByte(Module& module);
    std::uint8_t collide(Module& sender, std::uint8_t value);
    void deliverToHost(const Module& sender, std::uint8_t value, bool garbles);
    /// `due` may be in the future; bytes do not overtake each other.
    void hostHears(std::uint8_t value, TimePoint due);
    void deliverLateBytes();
    void deliverToModules(const LineByte& byte);
    /// Returns false when the module does not listen.
    bool moduleHears(std::size_t index, std::uint8_t value, std::uint32_t baud, bool error, bool struck);
    void watchForHaste(const LineByte& byte);
    [[nodiscard]] bool mayCutReply(const Packet& packet) const;
    void catchUp();

    // Faults.
    /// A packet of the host that is being sent to the modules, and the damage done to it.
    struct PacketUnderway {
        PacketBytes bytes;  ///< up to and including the current one; none if its start was not followed
        bool decided = false;
        std::optional<FrameEdit> busEdit;
        std::vector<std::optional<FrameEdit>> moduleEdits;
    };
    void carryOutFaults();
    void carryOut(const FaultInjector::Act& act);
    void updateHolds();
    /// Returns false when the module misses its packet.
    [[nodiscard]] bool faultsLetExecute(Module& module);
    void strikeReply(Module& module);
    void followPacket(const LineByte& byte, bool insidePacket);
    void strikePacket(const PacketBytes& known, std::size_t first);
    void deliverWithFaults(const LineByte& byte);
    /// Disturbs every module; no byte of the host is involved.
    void disturbModules(std::uint8_t value, bool error);
    [[nodiscard]] FrameEdit::Byte fateOfByte(std::size_t module) const;

    Random m_random;
    Receiver m_monitor;  ///< receives the host's undamaged bytes, to distinguish whole commands from nulls
                         ///< and garbage
    bool m_hasty = false;
    std::uint8_t m_hurried = 0;  ///< the module that was busy
    TimePoint m_nextCatchUp;
    PacketUnderway m_underway;
    /// For each module: true while it does not receive what the host sends, until both are between two
    /// packets.
    std::vector<bool> m_outOfStep;
    bool m_someAreOutOfStep = false;
    std::vector<Duration> m_heldUp;  ///< line delay of each module's current reply
    std::deque<HostByte> m_late;
};

Chain::Private::Private(const std::vector<ModuleIdentity>& identities, const ChainOptions& chainOptions)
    : options(chainOptions), faults(options.seed, identities.size()), m_random(options.seed) {
    for (const ModuleIdentity& identity : identities) {
        const auto phase = static_cast<Duration::rep>(
            m_random.below(static_cast<std::uint64_t>(std::chrono::nanoseconds(kServoTick).count())));
        const ModuleOptions moduleOptions{
            Duration(phase), options.resetDeadTime, options.unpaced,        options.deafWhenAddressInputRises,
            options.motor,   options.seed,          options.hostHasOwnClock};
        assert(isKnown(identity));
        const auto index = static_cast<std::uint8_t>(modules.size());
        if (identity.type == ModuleType::Stepper)
            modules.push_back(std::make_unique<StepperModule>(identity, index, moduleOptions, violations));
        else if (identity.type == ModuleType::Io)
            modules.push_back(std::make_unique<IoModule>(identity, index, moduleOptions, violations));
        else
            modules.push_back(std::make_unique<ServoModule>(identity, index, moduleOptions, violations));
    }
    moduleEvents.assign(modules.size(), kNever);
    addressLineBroken.assign(modules.size(), false);
    m_heldUp.assign(modules.size(), Duration{});
    m_underway.moduleEdits.resize(modules.size());
    m_outOfStep.assign(modules.size(), false);
    updateAddressLines();
}

TimePoint Chain::Private::nextEvent() const {
    TimePoint next = std::min(line.nextDue().value_or(kNever), faults.nextEvent());
    if (!m_late.empty())
        next = std::min(next, m_late.front().due);
    for (const TimePoint due : moduleEvents)
        next = std::min(next, due);
    return next;
}

/// Order of simultaneous events: faults, then modules in addressing order, then the host's byte. A byte that
/// arrives at the end of a tick belongs to the next tick, and one that arrives together with a reply's byte
/// does not cut that byte.
void Chain::Private::runTo(TimePoint until) {
    for (;;) {
        const auto first = std::min_element(moduleEvents.begin(), moduleEvents.end());
        const TimePoint moduleDue = first == moduleEvents.end() ? kNever : *first;
        const TimePoint lineDue = line.nextDue().value_or(kNever);
        const TimePoint faultDue = faults.nextEvent();
        const TimePoint due = std::min({moduleDue, lineDue, faultDue});
        if (due > until)
            break;
        now = std::max(now, due);
        if (faultDue <= due)
            carryOutFaults();
        else if (moduleDue <= lineDue)
            runModule(static_cast<std::size_t>(first - moduleEvents.begin()));
        else
            deliverToModules(line.take());
    }
    now = std::max(now, until);
    deliverLateBytes();
    catchUp();
}

void Chain::Private::catchUp() {
    if (now < m_nextCatchUp)
        return;
    m_nextCatchUp = now + kCatchUpEvery;
    for (const auto& module : modules) {
        // A pending command must find its module at the command's own tick, not beyond it.
        module->advanceTo(now);
    }
    updateAddressLines();  // A servo fault in step and direction mode shows on them.
}

// ---- Modules ----

void Chain::Private::runModule(std::size_t index) {
    Module& module = *modules[index];
    if (module.isReplying() && module.replyByteDue() <= module.executesAt()) {
        sendReplyByte(module);
    } else {
        execute(module);
    }
    moduleEvents[index] = module.nextEvent();
}

void Chain::Private::execute(Module& module) {
    if (faults.any() && !faultsLetExecute(module))
        return;
    module.execute();
    if (options.onExecuted)
        options.onExecuted(ModuleIndex(module.index()), module.snapshot(now));
    updateAddressLines();
    if (faults.any())
        strikeReply(module);
}

void Chain::Private::powerUp(std::size_t module) {
    modules[module]->powerUp(now);
    moduleEvents[module] = modules[module]->nextEvent();
    updateAddressLines();
}

void Chain::Private::updateAddressLines() {
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const bool low = i == 0 || (modules[i - 1]->addressOutputIsLow() && !addressLineBroken[i - 1]);
        modules[i]->setAddressInput(low, now);
    }
}

void Chain::Private::sendReplyByte(Module& module) {
    const bool paced = module.replyByteStart() < module.replyByteDue();
    std::uint8_t value = module.replyByte();
    if (paced)
        value = collide(module, value);
    const double chance = paced ? garbleChance(module, line.baud()) : 0.0;
    deliverToHost(module, value, chance > 0.0 && m_random.unit() < chance);
    if (module.replyByteSent())
        ++statistics.exchanges;
}

/// The line carries a 0 wherever any driver sends one. A byte that begins while another is being sent is not
/// received as a separate byte.
std::uint8_t Chain::Private::collide(Module& sender, std::uint8_t value) {
    for (std::size_t i = 0; i < modules.size(); ++i) {
        Module& other = *modules[i];
        if (&other == &sender || !other.isReplying() || other.replyByteStart() >= sender.replyByteDue())
            continue;
        value &= other.replyByte();
        if (!sender.replyIsStruck() && !other.replyIsStruck()) {
            sender.replyCollided(now);
            other.replyCollided(now);
        }
        if (other.replyByteSent())
            ++statistics.exchanges;
        moduleEvents[i] = other.nextEvent();
    }
    return value;
}

void Chain::Private::deliverToHost(const Module& sender, std::uint8_t value, bool garbles) {
    ++statistics.bytesOut;
    if (garbles) {
        value = garbled(value, m_random);
        modules[sender.index()]->countGarbled();
    }
    if (faults.strikesByte(FaultKind::MuteRx, sender.index(), now))
        return;
    hostHears(faults.breaks(&FaultSides::status, now) ? std::uint8_t{0} : value,
              now + m_heldUp[sender.index()]);
}

void Chain::Private::hostHears(std::uint8_t value, TimePoint due) {
    if (toHost.size() + m_late.size() == kMaxWaitingHostBytes) {
        ++statistics.bytesLost;
        return;
    }
    if (!m_late.empty())
        m_late.push_back({std::max(due, m_late.back().due), value});
    else if (due > now)
        m_late.push_back({due, value});
    else
        toHost.push_back({now, value});
}

void Chain::Private::deliverLateBytes() {
    for (; !m_late.empty() && m_late.front().due <= now; m_late.pop_front())
        toHost.push_back(m_late.front());
}

// ---- The host ----

void Chain::Private::deliverToModules(const LineByte& byte) {
    if (faults.any() || byte.foreign || m_someAreOutOfStep)
        return deliverWithFaults(byte);
    m_underway.bytes.clear();
    ++statistics.bytesIn;
    watchForHaste(byte);
    bool heard = false;
    for (std::size_t i = 0; i < modules.size(); ++i)
        heard |= moduleHears(i, byte.value, byte.baud, false, false);
    statistics.bytesUnheard += heard ? 0 : 1;
}

bool Chain::Private::moduleHears(std::size_t index, std::uint8_t value, std::uint32_t baud, bool error,
                                 bool struck) {
    Module& module = *modules[index];
    const bool listens = module.isAwake(now);
    module.dropReply();
    if (listens) {
        const double chance = garbleChance(module, baud);
        const bool wrong = chance > 0.0 && m_random.unit() < chance;
        if (wrong)
            module.countGarbled();
        module.hears(wrong ? garbled(value, m_random) : value, wrong || error, struck, hasteIsUnknown, now);
    }
    moduleEvents[index] = module.nextEvent();
    return listens;
}

const Module* Chain::Private::busyModule() const {
    for (const auto& module : modules)
        if (module->owesAnswer())
            return module.get();
    return nullptr;
}

/// A stop cannot wait for an answer. At an address that no module has, it may be meant for one that has
/// restarted.
bool Chain::Private::mayCutReply(const Packet& packet) const {
    if (packet.code() != CommandCode::StopMotor)
        return false;
    const auto isFor = [&](const auto& module) { return module->isAddressedBy(packet.address); };
    const auto isStopped = [&](const auto& module) { return isFor(module) && module->isStop(packet); };
    return std::ranges::none_of(modules, isFor) || std::ranges::any_of(modules, isStopped);
}

/// DS-V 4.1: no new command before the answer. The rule makes an exception for stops. Nulls and garbage do
/// not count, because every host begins with them.
void Chain::Private::watchForHaste(const LineByte& byte) {
    const bool complete = m_monitor.hears(byte.value, false);
    if (!complete && !m_monitor.inPacket()) {
        m_hasty = false;
        return;
    }
    if (const Module* busy = m_hasty ? nullptr : busyModule()) {
        m_hasty = true;
        m_hurried = busy->index();
    }
    if (!complete)
        return;
    const Packet& packet = m_monitor.packet();
    if (m_hasty && !hasteIsUnknown && packet.sumIsRight() && !mayCutReply(packet))
        violations.add({now, m_hurried, ViolationKind::CommandInFlight, packet.bytes()});
    if (hasteIsUnknown && !m_hasty && now > readLateUntil && ++waited == kWaitsThatCount)
        hasteIsUnknown = false;
    m_hasty = false;
}

// ---- Chain ----

Chain::Chain(const std::vector<ModuleIdentity>& modules, ChainOptions options)
    : d(std::make_unique<Private>(modules, options)) {}
Chain::~Chain() = default;
Chain::Chain(Chain&&) noexcept = default;
Chain& Chain::operator=(Chain&&) noexcept = default;

void Chain::setHostBaud(std::uint32_t baud) {
    assert(baud > 0);
    d->line.setBaud(baud);
}

bool Chain::understands(std::uint32_t baud) const {
    return std::ranges::any_of(
        d->modules, [this, baud](const auto& module) { return d->garbleChance(*module, baud) < 0.5; });
}

void Chain::hostSends(ByteSpan bytes, TimePoint now, bool readLate) {
    d->runTo(now);
    d->line.send(bytes, d->now);
    if (!readLate)
        return;
    d->hasteIsUnknown = true;
    d->readLateUntil = d->line.freeAt();
    d->waited = 0;
}

TimePoint Chain::hostLineFreeAt() const {
    return d->line.freeAt();
}

tl::expected<void, std::string> Chain::foreignSends(ByteSpan bytes, TimePoint now) {
    d->runTo(now);
    if (!d->options.enableFaults)
        return tl::unexpected(std::string(kFaultsOff));
    d->line.send(bytes, d->now, true);
    return {};
}

void Chain::advanceTo(TimePoint now) {
    d->runTo(now);
}

std::vector<HostByte> Chain::takeHostBytes() {
    return std::exchange(d->toHost, {});
}

std::optional<TimePoint> Chain::nextEvent() const {
    const TimePoint next = d->nextEvent();
    return next == kNever ? std::nullopt : std::optional(next);
}

std::size_t Chain::moduleCount() const {
    return d->modules.size();
}

ModuleIdentity Chain::identity(ModuleIndex module) const {
    return d->modules[module.value()]->snapshot({}).identity;
}

ModuleSnapshot Chain::snapshot(ModuleIndex module, TimePoint now) {
    d->runTo(now);
    Module& m = *d->modules[module.value()];
    m.advanceTo(d->now);
    static_cast<void>(m.isAwake(d->now));
    ModuleSnapshot s = m.snapshot(d->now);
    s.addressLineBroken = d->addressLineBroken[module.value()];
    return s;
}

void Chain::set(ModuleIndex module, Input input, std::optional<double> value, TimePoint now,
                unsigned number) {
    d->runTo(now);
    Module& m = *d->modules[module.value()];
    m.advanceTo(d->now);
    m.set(input, value, number);
}

void Chain::powerCycle(ModuleIndex module, TimePoint now) {
    d->runTo(now);
    d->powerUp(module.value());
}

void Chain::breakAddressLine(ModuleIndex module, TimePoint now) {
    d->runTo(now);
    d->addressLineBroken[module.value()] = true;
    d->updateAddressLines();
}

void Chain::mendAddressLine(ModuleIndex module, TimePoint now) {
    d->runTo(now);
    d->addressLineBroken[module.value()] = false;
    d->updateAddressLines();
}

tl::expected<unsigned, std::string> Chain::inject(const FaultSpec& fault, TimePoint now) {
    d->runTo(now);
    if (!d->options.enableFaults)
        return tl::unexpected(std::string(kFaultsOff));
    if (d->faults.size() == FaultInjector::kMaxFaults)
        return tl::unexpected("there are " + std::to_string(FaultInjector::kMaxFaults) +
                              " faults already; allowed is fault clear");
    if (fault.at && *fault.at < d->now)
        return tl::unexpected("at is past: it is " + std::to_string(toSeconds(d->now.time_since_epoch())) +
                              " s; allowed is any later time");
    const unsigned number = d->faults.add(fault, d->now);
    d->runTo(now);
    return number;
}

void Chain::clearFaults(TimePoint now) {
    d->runTo(now);
    d->clearFaults();
}

std::vector<FaultReport> Chain::faults() const {
    return d->faults.reports(d->now);
}

ChainStatistics Chain::statistics() const {
    ChainStatistics s = d->statistics;
    s.time = d->now;
    s.bytesLost += d->line.lost();
    for (const auto& module : d->modules)
        s.modules.push_back(module->statistics());
    return s;
}

const ViolationLog& Chain::violations() const {
    return d->violations;
}

void Chain::clearStatistics(TimePoint now) {
    d->runTo(now);
    d->statistics = {};
    d->line.forgetLost();
    d->violations.clear();
    for (const auto& module : d->modules)
        module->clearStatistics();
}

// ---- faults that are made on purpose (docs/simulator.md) ----

// ---- Things that happen at a time ----

void Chain::Private::carryOutFaults() {
    for (const FaultInjector::Act& act : faults.takeDue(now))
        carryOut(act);
}

void Chain::Private::carryOut(const FaultInjector::Act& act) {
    if (const auto* cycle = std::get_if<FaultInjector::PowerCycle>(&act)) {
        powerUp(cycle->module);
    } else if (const auto* give = std::get_if<FaultInjector::GiveAddress>(&act)) {
        modules[give->to]->takeAddress(modules[give->from]->address());
    } else if (const auto* define = std::get_if<FaultInjector::DefineItems>(&act)) {
        modules[define->module]->defineItems(define->mask);
    } else if (const auto* noise = std::get_if<FaultInjector::NoiseByte>(&act)) {
        if (noise->sides.command)
            disturbModules(noise->value, false);
        if (noise->sides.status)
            hostHears(noise->value, now);
    } else if (const auto* foreign = std::get_if<FaultInjector::ForeignPacket>(&act)) {
        Payload payload{foreign->code, {}};
        if (foreign->code != CommandCode::Nop)
            payload.data.push_back(foreign->items);
        line.send(toPacket({BusAddress(modules[foreign->module]->address()), payload}), now, true);
    } else if (const auto* begins = std::get_if<FaultInjector::BreakBegins>(&act)) {
        if (begins->sides.command)
            disturbModules(0, true);
        if (begins->sides.status)
            hostHears(0, now);
    } else {
        updateHolds();
    }
}

void Chain::Private::updateHolds() {
    for (const auto& module : modules) {
        module->advanceTo(now);
        module->holdShaft(faults.isOn(FaultKind::Stall, module->index(), now));
        module->reverseEncoder(faults.isOn(FaultKind::Reverse, module->index(), now));
    }
}

void Chain::Private::clearFaults() {
    faults.clear();
    for (const auto& module : modules)
        module->giveAddressBack();
    std::ranges::fill(m_heldUp, Duration{});
    updateHolds();
}

// ---- Commands and replies ----

bool Chain::Private::faultsLetExecute(Module& module) {
    const CommandCode code = module.pendingPacket().code();
    if (faults.strikesCommand(FaultKind::Ignore, module.index(), code, now)) {
        module.forgetPending();
        return false;
    }
    if (faults.strikesCommand(FaultKind::Cksum, module.index(), code, now))
        module.damagePending();
    return true;
}

void Chain::Private::strikeReply(Module& module) {
    if (!module.isReplying())
        return;
    std::vector<std::uint8_t> bytes(module.reply().begin(), module.reply().end());
    const auto fate = faults.strikeReply(module.index(), module.answeredCode(), bytes, now);
    if (!fate.sent)
        bytes.clear();
    module.replaceReply(bytes, fate.begunLater);
    m_heldUp[module.index()] = fate.heldUp;
}

// ---- Bytes from the host ----

void Chain::Private::deliverWithFaults(const LineByte& byte) {
    const bool insidePacket = m_monitor.inPacket();
    if (!byte.foreign) {
        ++statistics.bytesIn;
        watchForHaste(byte);
        followPacket(byte, insidePacket);
    }
    const bool broken = faults.breaks(&FaultSides::command, now);
    faults.strikesByte(FaultKind::MuteTx, std::nullopt, now);
    bool heard = byte.foreign;
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const FrameEdit::Byte fate = byte.foreign ? FrameEdit::Byte{} : fateOfByte(i);
        const bool mute = faults.isOn(FaultKind::MuteTx, static_cast<std::uint8_t>(i), now);
        if (!insidePacket && !modules[i]->inPacket())
            m_outOfStep[i] = false;
        if (byte.foreign || mute || broken || fate.error || fate.flips != 0 || fate.copies != 1)
            m_outOfStep[i] = true;
        const auto value = static_cast<std::uint8_t>(broken ? 0U : unsigned{byte.value} ^ fate.flips);
        for (unsigned copy = 0; copy < fate.copies && !mute; ++copy)
            heard |= moduleHears(i, value, byte.baud, broken || fate.error, m_outOfStep[i]);
    }
    m_someAreOutOfStep = std::ranges::count(m_outOfStep, true) > 0;
    statistics.bytesUnheard += heard ? 0 : 1;
    if (!byte.foreign && faults.strikesByte(FaultKind::Echo, std::nullopt, now))
        hostHears(byte.value, now);
}

void Chain::Private::disturbModules(std::uint8_t value, bool error) {
    m_outOfStep.assign(modules.size(), true);
    m_someAreOutOfStep = true;
    for (std::size_t i = 0; i < modules.size(); ++i)
        moduleHears(i, value, line.baud(), error, true);
}

/// A packet is struck when its header is sent if the host has handed it over whole. From a host that sends
/// byte by byte, it is struck when its command byte is sent, because its type and length are unknown before.
void Chain::Private::followPacket(const LineByte& byte, bool insidePacket) {
    if (!insidePacket) {
        m_underway.bytes.clear();
        m_underway.decided = false;
        m_underway.busEdit.reset();
        std::ranges::fill(m_underway.moduleEdits, std::nullopt);
    }
    // Bytes between packets are not struck, nor is the rest of a packet that was under way before the faults.
    if (m_underway.bytes.empty() && (insidePacket || byte.value != kHeader))
        return;
    m_underway.bytes.push_back(byte.value);
    if (m_underway.decided)
        return;
    if (!insidePacket) {
        const PacketBytes whole = line.packetBehind(byte.value);
        if (whole.size() > kCommandByteAt && whole.size() == packetLength(whole[kCommandByteAt]))
            strikePacket(whole, 0);
    } else if (m_underway.bytes.size() > kCommandByteAt) {
        strikePacket(m_underway.bytes, kCommandByteAt);
    }
}

void Chain::Private::strikePacket(const PacketBytes& known, std::size_t first) {
    const auto code = static_cast<CommandCode>(known[kCommandByteAt] & 0x0FU);
    const FrameInSight packet{known, packetLength(known[kCommandByteAt]), first, true};
    m_underway.decided = true;
    m_underway.busEdit = faults.strikePacket(std::nullopt, code, packet, now);
    for (const auto& module : modules)
        if (module->isAwake(now) && module->isAddressedBy(known[1]))
            m_underway.moduleEdits[module->index()] = faults.strikePacket(module->index(), code, packet, now);
}

FrameEdit::Byte Chain::Private::fateOfByte(std::size_t module) const {
    if (m_underway.bytes.empty())
        return {};
    const std::size_t at = m_underway.bytes.size() - 1;
    if (const auto& edit = m_underway.moduleEdits[module])
        return edit->at[at];
    return m_underway.busEdit ? m_underway.busEdit->at[at] : FrameEdit::Byte{};
}

}  // namespace nmc::sim
