// SPDX-License-Identifier: MIT
#include "bus/lending.h"

#include <algorithm>
#include <array>

#include "module/commandfacts.h"

namespace nmc::bus {

namespace {

/// The command that these bytes are to a module of that type; for an unknown type, only one that means the
/// same on every chip.
[[nodiscard]] std::optional<ModuleCommand> commandOf(const ModuleIdentity& module, const Payload& payload) {
    const CommandCode code = payload.code;
    const bool common = code == CommandCode::SetAddress || code == CommandCode::DefineStatus ||
                        code == CommandCode::ReadStatus || code == CommandCode::Nop;
    if (!common && !isKnown(module))
        return std::nullopt;
    return withDecoded(module, payload, [](const auto& command) {
        return command ? std::optional(ModuleCommand(*command)) : std::nullopt;
    });
}

/// The items that this request asks for, if it does.
[[nodiscard]] std::optional<StatusItems> itemsAsked(const Payload& payload) {
    const bool asks = payload.code == CommandCode::ReadStatus || payload.code == CommandCode::DefineStatus;
    return asks && !payload.data.empty() ? std::optional(StatusItems(payload.data[0])) : std::nullopt;
}

/// The chip may obey a Hard Reset to FF whatever its group. A PIC-SERVO up to version 4 and a PIC-I/O do not
/// (DS-S 5.1 Hard Reset; docs/family.md).
[[nodiscard]] bool mayObeyResetOfAll(const ModuleIdentity& module) {
    const bool firstServo = module.type == ModuleType::Servo && hasDataSheet(module);
    return !firstServo && module.type != ModuleType::Io;
}

/// The identity in a reply with these items from a module of any type: the one that has a reply of that
/// length, and reports itself.
[[nodiscard]] std::optional<ModuleIdentity> identityIn(StatusItems items, ByteSpan reply) {
    static constexpr std::array<ModuleIdentity, 5> kLayouts{{{ModuleType::Servo, kPathVersion - 1},
                                                             {ModuleType::Servo, kPathVersion},
                                                             {ModuleType::Adc, 0},
                                                             {ModuleType::Io, 1},
                                                             {ModuleType::Stepper, 1}}};
    for (const ModuleIdentity& layout : kLayouts) {
        const auto report = decodeStatus(layout, items, reply);
        if (report && report->identity && report->identity->type == layout.type &&
            replyLength(*report->identity, items) == reply.size())
            return report->identity;
    }
    return std::nullopt;
}

}  // namespace

void Lending::begin() {
    m_phase = Phase::Passing;
    m_packets = {};
    m_passed.clear();
}

void Lending::end() {
    m_phase = Phase::None;
    m_cutBy.reset();
    std::vector<ModuleInfo> heard = m_chain.infos();
    if (std::erase_if(heard, [](const ModuleInfo& info) { return info.identity == kUnheardModule; }) > 0)
        become(std::move(heard));
}

bool Lending::delays(TimePoint now) {
    if (!passes())
        return false;
    if (m_packets.incomplete() && (!m_cutBy || now < *m_cutBy)) {
        m_cutBy = m_cutBy.value_or(now + kPatience);
        return true;
    }
    m_phase = Phase::HeldOff;
    m_cutBy.reset();
    m_asked.clear();
    return false;
}

std::size_t Lending::passing(ByteSpan bytes) const {
    if (!m_cutBy)
        return bytes.size();
    PacketSplitter ahead = m_packets;
    std::size_t count = 0;
    while (count < bytes.size() && ahead.incomplete())
        ahead.take(bytes[count++]);
    return count;
}

// ---- what the program sends ----

bool Lending::onPassed(ByteSpan bytes, Duration byteTime, TimePoint end) {
    const auto startOf = [&](std::size_t size, std::size_t behind) {
        return end - byteTime * static_cast<Duration::rep>(size + behind);
    };
    const auto skip = [&](std::size_t behind) {
        if (std::vector<std::uint8_t> skipped = m_packets.takeSkipped(); !skipped.empty()) {
            const TimePoint start = startOf(skipped.size(), behind);
            m_passed.push_back({std::move(skipped), false, start});
        }
    };
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (!m_packets.take(bytes[i]))
            continue;
        const PacketBytes& packet = m_packets.packet();
        const std::size_t behind = bytes.size() - i - 1;
        skip(packet.size() + behind);
        m_passed.push_back({{packet.begin(), packet.end()}, true, startOf(packet.size(), behind)});
    }
    skip(0);
    return m_packets.incomplete();
}

std::optional<Lending::Passed> Lending::takePassed(TimePoint by) {
    if (m_passed.empty() || m_passed.front().start > by)
        return std::nullopt;
    Passed first = std::move(m_passed.front());
    m_passed.pop_front();
    return first;
}

std::optional<Ask> Lending::follow(const PacketBytes& packet, TimePoint latched) {
    const bool right = parsePacket(packet).has_value();
    Ask ask;
    ask.purpose = Purpose::Lent;
    ask.asSent = packet;
    ask.request.address = BusAddress(packet[1]);
    ask.request.payload.code = static_cast<CommandCode>(packet[2] & 0x0FU);
    ask.request.payload.data.append(ByteSpan(packet).subspan(3, packet.size() - 4));
    ask.request.framing = Framing::Open;
    if (right && ask.request.payload.code == CommandCode::HardReset) {
        followReset(ask.request.address);
        return std::nullopt;
    }
    if (ask.request.address.value() >= kFirstGroup) {
        followGroup(ask, right, latched);
        return ask.module ? std::optional(std::move(ask)) : std::nullopt;
    }
    const Chain::Module* module = m_chain.find(ask.request.address);
    if (right)
        ask.command = commandOf(module != nullptr ? module->belief.info().identity : kUnheardModule,
                                ask.request.payload);
    if (module == nullptr)
        return ask;
    ask.module = module->belief.info().index;
    ask.reported = ask.command && !isQuestion(*ask.command);
    frame(ask, module->belief);
    return ask;
}

/// The leader answers; of the other members it remains unknown whether they have received it.
void Lending::followGroup(Ask& ask, bool right, TimePoint latched) {
    for (const Chain::Module& module : m_chain.modules()) {
        const ModuleInfo& info = module.belief.info();
        if (info.group && BusAddress(info.group->group) != ask.request.address)
            continue;
        const auto command = right ? commandOf(info.identity, ask.request.payload) : std::nullopt;
        const bool changes = command && !isQuestion(*command);
        if (info.group && info.group->leader) {
            ask.module = info.index;
            ask.command = command;
            ask.reported = changes;
            frame(ask, module.belief);
        } else if (command) {
            m_chain.noteSent(info.index, *command, latched);
            if (changes)
                m_events.emplace_back(CommandUnanswered{info.index, *command});
        }
    }
}

/// It is not answered; those that may have obeyed are gone until they have an address again.
void Lending::followReset(BusAddress address) {
    const auto obeys = [address](const ModuleInfo& info) {
        const bool member = !info.group || BusAddress(info.group->group) == address;
        return info.address == address || (address.value() >= kFirstGroup && member) ||
               (address == kEverybody && mayObeyResetOfAll(info.identity));
    };
    std::vector<ModuleInfo> rest = m_chain.infos();
    if (std::erase_if(rest, obeys) > 0)
        become(std::move(rest));
}

/// The reply has a known length only if its items are known, and what these mean to the module.
void Lending::frame(Ask& ask, const Belief& module) const {
    const ModuleIdentity identity = module.info().identity;
    const auto asked = itemsAsked(ask.request.payload);
    const auto items = asked ? asked : module.items();
    ask.request.reply = {identity, {}};
    if (!items || (!isKnown(identity) && (items->mask() & ~unsigned{StatusItems::Identity}) != 0))
        return;
    ask.request.reply.items = *items;
    ask.request.framing = Framing::Settled;
}

// ---- what is answered ----

Line::Script Lending::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    const bool known = ask.module && ask.command;
    // Two zero bytes are the shortest reply of a PIC-I/O; a line that is held low sends more of them.
    const bool held = uniform(end.bytes) && end.bytes.size() > kMinReply;
    if (!unanswered(end.result) && !held)
        onAnswered(ask, end, now);
    else if (known && ask.reported)
        m_events.emplace_back(CommandUnanswered{*ask.module, *ask.command});
    return {};
}

void Lending::onAnswered(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    if (m_chain.rate() != m_line.baud()) {
        m_chain.setRate(m_line.baud());
        m_events.emplace_back(ModulesSeen{m_chain.infos(), m_chain.rate()});
    }
    if (ask.module && !m_chain.answers(*ask.module)) {
        m_chain.schedule().recover(*ask.module, now);
        m_events.emplace_back(ModuleUnresponsive{*ask.module, false});
    }
    if (end.result == ReplyResult::Refused)
        return;
    if (ask.command && is<SetAddress>(*ask.command))
        onAddress(ask);
    else if (ask.request.address != kUnaddressed && ask.request.address.value() < kFirstGroup)
        onHeard(ask, end);
}

void Lending::onAddress(const Ask& ask) {
    const SetAddress& set = *getIf<SetAddress>(*ask.command);
    if (ask.module) {
        m_chain.at(*ask.module).belief.setAddress(set.address);
        m_events.emplace_back(AddressChanged{*ask.module, set.address});
    } else if (ask.request.address == kUnaddressed) {
        // It has been reset, or powered up, and takes the place of one that had this address.
        std::vector<ModuleInfo> now = m_chain.infos();
        const ModuleInfo found{{}, set.address, kUnheardModule, GroupPlace{set.group.value(), set.leader}};
        const auto same = std::ranges::find(now, set.address, &ModuleInfo::address);
        same != now.end() ? void(*same = found) : now.push_back(found);
        become(std::move(now), set.address);
    }
}

/// A module that was not known here has answered, or one of unheard type has reported it.
void Lending::onHeard(const Ask& ask, const ReplyEnd& end) {
    const Chain::Module* module = m_chain.find(ask.request.address);
    if (module != nullptr && module->belief.info().identity != kUnheardModule)
        return;
    const auto asked = itemsAsked(ask.request.payload);
    const auto items = asked || module == nullptr ? asked : module->belief.items();
    const auto identity = items ? identityIn(*items, end.bytes) : std::nullopt;
    if (module != nullptr && !identity)
        return;
    std::vector<ModuleInfo> now = m_chain.infos();
    if (module == nullptr)
        now.push_back({{}, ask.request.address, kUnheardModule, {}});
    std::ranges::find(now, ask.request.address, &ModuleInfo::address)->identity =
        identity.value_or(kUnheardModule);
    become(std::move(now));
}

/// What is known of modules that remain is kept. Of a new one, nothing is known unless it has just been
/// reset.
void Lending::become(std::vector<ModuleInfo> modules, std::optional<BusAddress> reset) {
    for (std::size_t i = 0; i < modules.size(); ++i)
        modules[i].index = ModuleIndex(static_cast<std::uint8_t>(i));
    Chain chain(modules, m_chain.rate(), false);
    for (Chain::Module& module : chain.modules()) {
        const ModuleInfo info = module.belief.info();
        const Chain::Module* before = m_chain.find(info.address);
        if (info.address == reset)
            continue;
        if (before != nullptr && before->belief.info().identity == info.identity) {
            module = *before;
            module.belief.foundAgain(info.index);
            continue;
        }
        module.belief.attach();
        if (before == nullptr || !before->belief.items())
            module.belief.forgetItems();
        else
            module.belief.onExecuted(ServoCommand(DefineStatus{*before->belief.items()}));
    }
    m_chain = std::move(chain);
    m_changed = true;
    m_events.emplace_back(ModulesSeen{std::move(modules), m_chain.rate()});
}

// ---- after a stop ----

const Chain::Module* Lending::unheard() const {
    const auto found = std::ranges::find_if(m_chain.modules(), [this](const Chain::Module& module) {
        const ModuleInfo& info = module.belief.info();
        return info.identity == kUnheardModule && !m_asked.contains(info.address);
    });
    return heldOff() && found != m_chain.modules().end() ? &*found : nullptr;
}

bool Lending::wants(TimePoint /*now*/) const {
    return unheard() != nullptr;
}

Next Lending::next(TimePoint /*now*/) {
    if (auto nulls = m_recovery.flush())
        return std::move(*nulls);
    const ModuleInfo info = unheard()->belief.info();
    m_asked.insert(info.address);
    Ask ask = m_chain.status(Purpose::Stop, info.index, kIdentityItems);
    ask.handlesFailure = true;
    return ask;
}

}  // namespace nmc::bus
