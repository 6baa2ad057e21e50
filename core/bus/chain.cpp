// SPDX-License-Identifier: MIT
#include "bus/chain.h"

#include <algorithm>
#include <iterator>
#include <memory>

#include "module/commandfacts.h"

namespace nmc::bus {

Chain::Chain(const std::vector<ModuleInfo>& modules, std::uint32_t rate, bool readOnly)
    : m_rate(rate), m_readOnly(readOnly), m_schedule(modules.size()) {
    for (const ModuleInfo& info : modules) {
        m_modules.emplace_back(info);
        if (readOnly)
            m_modules.back().belief.forgetItems();
    }
}

bool Chain::anythingMoves() const {
    return std::ranges::any_of(m_modules, [](const Module& module) { return module.belief.moving(); });
}

bool Chain::anyRestarted() const {
    return std::ranges::any_of(m_modules, [](const Module& module) { return module.belief.restarted(); });
}

/// Modules nearer the host may be cut off with it: it is the farthest, but not one that was already silent
/// when nobody was without an address, as long as there is another.
std::optional<ModuleIndex> Chain::restartedOf(const std::vector<ModuleIndex>& silent) const {
    for (const ModuleIndex module : silent)
        if (belief(module).restarted())
            return module;
    const auto recent =
        std::ranges::find_if(silent, [this](ModuleIndex module) { return !m_schedule.sought(module); });
    if (recent == silent.end()) {
        // The stop that is owed to it would end, although its motor may run.
        const bool open = silent.empty() || (silent.size() > 1 && at(silent.front()).owed);
        return open ? std::nullopt : std::optional(silent.front());
    }
    // Otherwise the next one may have restarted and cut this one off.
    const bool alone = recent == silent.begin() || std::prev(recent)->value() + 1 != recent->value();
    return alone ? std::optional(*recent) : std::nullopt;
}

void Chain::forgetStates() {
    for (Module& module : m_modules) {
        auto owed = module.owed;
        module = Module(module.belief);
        module.belief.forgetItems();
        if (owed)
            owed->target = StopTarget(module.belief, owed->target.manner());
        module.owed = owed;
    }
}

Ask Chain::command(Purpose purpose, const Order& order) const {
    const Belief& module = belief(order.module);
    const Payload payload = payloadOf(order.command);
    const RetryRule rule = factsOf(order.command).retry;
    Ask ask;
    ask.purpose = purpose;
    ask.module = order.module;
    ask.request = {module.info().address, payload, layoutOf(module, payload)};
    if (m_readOnly && payload.code != CommandCode::ReadStatus) {
        ask.request.reply.items = {};
        ask.request.framing = Framing::Open;  // its length depends on what another host has defined
    }
    ask.command = order.command;
    ask.silentRepeats = rule.silentRepeats;
    ask.repeatAtOnce = rule.atOnce;
    ask.refusedAttempts = rule.refusedAttempts;
    return ask;
}

Ask Chain::status(Purpose purpose, ModuleIndex module, std::optional<StatusItems> items) const {
    const StatusItems standing = standingItems(belief(module).info().identity);
    if (items || m_readOnly)
        return command(purpose, {module, ServoCommand(ReadStatus{items.value_or(standing)})});
    if (!belief(module).items())
        return command(purpose, {module, ServoCommand(DefineStatus{standing})});
    return command(purpose, {module, ServoCommand(Nop{})});
}

Ask Chain::look(Purpose purpose, ModuleIndex module) const {
    const bool known = belief(module).items().has_value();
    return status(purpose, module, known ? std::optional(belief(module).otherItems()) : std::nullopt);
}

ReplyLayout Chain::layoutOf(const Belief& module, const Payload& payload) const {
    const ModuleIdentity identity = module.info().identity;
    if (payload.code == CommandCode::ReadStatus || payload.code == CommandCode::DefineStatus)
        return {identity, StatusItems(payload.data[0])};
    // What another host has defined may be anything.
    return {identity, module.items().value_or(m_readOnly ? fullItems(identity) : standingItems(identity))};
}

std::size_t Chain::longestReply() const {
    std::size_t longest = 0;
    for (const Module& module : m_modules) {
        const ModuleIdentity identity = module.belief.info().identity;
        longest = std::max(longest, replyLength(identity, allItems(identity)));
    }
    return longest;
}

Ask Chain::next(StopTarget& target) const {
    const ModuleIndex module = target.module();
    const StopTarget::Question question = target.next(belief(module));
    Ask ask = question.stop ? command(Purpose::Stop, {module, *question.stop})
                            : status(Purpose::Stop, module, question.items);
    ask.reported = question.stop.has_value();
    ask.silentRepeats = 0;
    ask.refusedAttempts = 1;
    return ask;
}

std::optional<CommandExecuted> Chain::takeBlindStop(StopTarget& target) {
    const auto blind = target.takeBlind();
    if (!blind)
        return std::nullopt;
    const ModuleIndex module = target.module();
    return CommandExecuted{module, blind->latched, blind->stop, {}, takeUnanswered(module, blind->latched)};
}

const Chain::Module* Chain::find(BusAddress address) const {
    const auto found = std::ranges::find_if(
        m_modules, [address](const Module& module) { return module.belief.info().address == address; });
    return found != m_modules.end() ? &*found : nullptr;
}

std::vector<ModuleInfo> Chain::infos() const {
    std::vector<ModuleInfo> infos;
    for (const Module& module : m_modules)
        infos.push_back(module.belief.info());
    return infos;
}

void Chain::noteSent(ModuleIndex index, const ModuleCommand& command, TimePoint latched) {
    Module& module = at(index);
    module.belief.onSent(command, latched);
    if (const auto* own = std::get_if<ServoCommand>(&command))
        module.sent.apply(*own, module.belief.info().identity);
    module.plausibility.onSent(command, module.sent, latched);
    module.watch.onSent(command, module.sent);
    module.ownMotion.onSent(command);
    const Effect effect = factsOf(command).effect;
    if (effect == Effect::Counter)
        module.travel.onCounterSet();
    if (effect == Effect::Start)
        module.trust.expectMotion();
    if (effect == Effect::Stop)
        m_schedule.unfocus();  // a stop must be monitored on all modules
}

void Chain::owe(ModuleIndex index, StopCause cause, StopManner manner) {
    Module& module = at(index);
    if (module.belief.restarted())
        return;  // off by itself, and without an address
    if (!hasStop(module.belief.info().identity.type))
        return;  // it has no stop command
    if (m_readOnly && cause != StopCause::StopAll)
        return;  // the user did not request it
    // A motor that runs the wrong way would continue with its servo on.
    const bool bothWanted =
        module.owed && ofOperator(module.owed->cause) && ofOperator(cause) && cause != StopCause::TravelLimit;
    if (module.owed && !bothWanted)
        manner = firmer(manner, module.owed->target.manner());
    const auto before = std::exchange(module.owed, OwedStop{StopTarget(module.belief, manner), cause});
    if (!before || !before->standsAlone())
        return;
    module.owed->outstanding = before->outstanding;
    const bool fault = !ofOperator(cause) && cause != StopCause::StopAll;
    if (!fault || !ofOperator(before->cause))
        module.owed->cause = before->cause;
}

void Chain::hurryOwedStop(ModuleIndex index, TimePoint now) {
    if (auto& owed = at(index).owed)
        owed->due = now;
}

void Chain::welcome(ModuleIndex index, TimePoint now) {
    ModuleInfo info = at(index).belief.info();
    info.group = GroupPlace{};
    const StopOutputs off = at(index).belief.outputs().stopOutputs();
    // Constructed in place: for an assignment, g++ 12 reports an empty optional as used uninitialised.
    std::destroy_at(&at(index));
    std::construct_at(&at(index), info);
    at(index).belief.setStopOutputs(off);
    at(index).belief.forgetItems();
    m_schedule.recover(index, now);
}

std::vector<Order> Chain::stops() const {
    std::vector<Order> stops;
    for (const Module& module : m_modules) {
        const ModuleInfo& info = module.belief.info();
        // A motor that has to be switched off is not held instead.
        const StopManner owed = module.owed ? module.owed->target.manner() : StopManner::Smoothly;
        auto stop = stopFor(module.belief, firmer(StopManner::Abruptly, owed));
        if (!stop)
            continue;
        stops.push_back({info.index, *stop});
        if (info.identity.type != ModuleType::Io)
            continue;
        // Pins and PWM outputs need separate commands.
        Belief then = module.belief;
        then.onExecuted(*stop);
        if ((stop = stopFor(then)))
            stops.push_back({info.index, *stop});
    }
    return stops;
}

std::vector<PacketBytes> Chain::outputStops() const {
    std::vector<PacketBytes> packets;
    for (const Order& stop : stops())
        if (std::holds_alternative<IoCommand>(stop.command))
            packets.push_back(toPacket({belief(stop.module).info().address, payloadOf(stop.command)}));
    return packets;
}

std::vector<std::uint8_t> Chain::stopBurst() const {
    std::vector<std::uint8_t> burst;
    if (m_readOnly)
        return burst;
    const std::size_t pause = nullsForTurnaround(byteTimeAtBaud(m_rate));
    const auto add = [&](ModuleIndex module, const ModuleCommand& command) {
        if (burst.empty())
            burst.assign(kNullCount, 0);
        const PacketBytes packet = toPacket({belief(module).info().address, payloadOf(command)});
        burst.insert(burst.end(), packet.begin(), packet.end());
        // Nothing waits between the packets any more, so nulls must provide the delay: a packet that arrives
        // before the previous one was carried out replaces it (DS-V 4.1).
        burst.insert(burst.end(), pause, 0);
    };
    for (const Order& stop : stops()) {
        // A motor that oscillates with the gains on trial would not come to rest by a stop alone.
        if (const auto& trial = at(stop.module).trial)
            add(stop.module, ServoCommand(trial->net.back));
        add(stop.module, stop.command);
    }
    return burst;
}

std::optional<BusAddress> Chain::groupOf(const std::vector<Order>& stops) const {
    if (stops.size() < 2)
        return std::nullopt;
    const auto& place = belief(stops.front().module).info().group;
    const auto same = [&](const Order& s) {
        return payloadOf(s.command) == payloadOf(stops.front().command);
    };
    const auto isStopped = [&](const Module& module) {
        return std::ranges::any_of(stops,
                                   [&](const Order& s) { return s.module == module.belief.info().index; });
    };
    // Only if all groups are known: those left by another host may have a leader, or be different. And only
    // if all members answer: a module that restarted unnoticed is in group FF, off, and would be switched on.
    const auto fits = [&](const Module& module) {
        const auto& other = module.belief.info().group;
        const bool heard = answers(module.belief.info().index);
        if (!place || !other || (BusAddress(place->group) == kEverybody && !heard))
            return false;
        const bool member = other->group == place->group;
        return member == isStopped(module) && (!member || heard);
    };
    if (!std::ranges::all_of(stops, same) || !std::ranges::all_of(m_modules, fits))
        return std::nullopt;
    return BusAddress(place->group);
}

Line::Script Chain::stopScript(const std::vector<Order>& stops) const {
    Line::Script script;
    if (const auto group = groupOf(stops)) {
        std::size_t reply = 0;  // of the group's leader
        for (const Order& order : stops)
            if (belief(order.module).info().group->leader)
                reply = layoutOf(belief(order.module), payloadOf(order.command)).length();
        addStop(script, *group, payloadOf(stops.front().command), reply);
        return script;
    }
    for (const Order& order : stops) {
        const Payload payload = payloadOf(order.command);
        addStop(script, belief(order.module).info().address, payload,
                layoutOf(belief(order.module), payload).length());
    }
    return script;
}

void Chain::addStop(Line::Script& script, BusAddress address, const Payload& payload,
                    std::size_t reply) const {
    script.insert(script.end(), {Line::Packet{toPacket({address, payload}), reply}, Line::Spacer{}});
    if (reply > 0)
        script.emplace_back(Line::Pause{byteTimeAtBaud(m_rate) * static_cast<Duration::rep>(reply)});
}

}  // namespace nmc::bus
