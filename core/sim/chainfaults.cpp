// SPDX-License-Identifier: MIT
// What is made to go wrong with a chain on purpose (simulator.md, Faults).
#include <algorithm>

#include "sim/chainprivate.h"

namespace nmc::sim {

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
    if (faults.ignores(module.index(), code, now)) {
        module.forgetPending();
        return false;
    }
    if (faults.refuses(module.index(), code, now))
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
        m_underway.decided = byte.value != kHeader;
        m_underway.busEdit.reset();
        std::ranges::fill(m_underway.moduleEdits, std::nullopt);
        if (m_underway.decided)
            return;
    }
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
