// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/owedoath.h"

#include <algorithm>

#include "tests/sessions/operator.h"

namespace nmc::test {

using namespace bus;
using namespace std::chrono_literals;

namespace {

constexpr std::uint8_t kFirstGroup = 0x80;
constexpr unsigned kStartNow = 0x80;  // of Load Trajectory's control byte (DS-V 5.2, DS-S 5.1)

[[nodiscard]] bool startsMotion(const WireItem& item) {
    return item.code() == CommandCode::StartMotion ||
           (item.code() == CommandCode::LoadTrajectory && (item.control() & kStartNow) != 0);
}

/// Velocity mode, starting at once.
[[nodiscard]] std::vector<std::uint8_t> packetOf(const HoldToMove& hold, std::uint8_t address) {
    Payload payload;
    if (hold.pace) {
        stepper::LoadTrajectory load;
        load.speed = hold.pace->speed;
        load.accelerationTime = hold.pace->accelerationTime;
        load.reverse = hold.reverse;
        load.startNow = true;
        payload = encode(load);
    } else {
        servo::LoadTrajectory load;
        load.velocity = hold.velocity;
        load.acceleration = hold.acceleration;
        load.profile = servo::ProfileMode::Velocity;
        load.reverse = hold.reverse;
        load.startNow = true;
        payload = encode(load);
    }
    const PacketBytes packet = toPacket({BusAddress(address), payload});
    return {packet.begin(), packet.end()};
}

}  // namespace

/// Nothing is owed for a hold that the engine has not carried out.
void OwedStopOath::onHoldEnded(const HoldToMove& hold, std::size_t wireFrom, TimePoint due) {
    const auto& wire = m_rig->wire;
    const std::size_t index = hold.module.value();
    if (!m_rig->known || index >= m_rig->known->modules.size())
        return;
    const std::vector<std::uint8_t> packet = packetOf(hold, m_rig->known->modules[index].address);
    if (std::any_of(wire.begin() + static_cast<std::ptrdiff_t>(wireFrom), wire.end(),
                    [&](const WireItem& item) { return item.packet == packet; }))
        owe(hold.module, due);
}

void OwedStopOath::owe(ModuleIndex module, TimePoint due) {
    const std::size_t index = module.value();
    if (!m_rig->known || index >= m_rig->known->modules.size())
        return;
    const KnownChain::Module& m = m_rig->known->modules[index];
    if (m.place != KnownChain::kNowhere)
        m_debts.push_back({index, m.place, m.address, due});
}

void OwedStopOath::onEvent(const Event& event) {
    if (const auto* suspect = std::get_if<MotionSuspect>(&event)) {
        owe(suspect->module, m_rig->bus.now);
    } else if (const auto* group = std::get_if<GroupFinished>(&event)) {
        for (const GroupMember& member : group->members)
            if (group->stopped)
                owe(member.module, m_rig->bus.now);
    } else if (const auto* confirmed = std::get_if<OwedStopConfirmed>(&event)) {
        checkConfirmed(*confirmed);
    }
}

void OwedStopOath::checkConfirmed(const OwedStopConfirmed& event) {
    const std::size_t index = event.module.value();
    if (!m_rig->known || index >= m_rig->known->modules.size())
        return m_rig->complain("owed: module " + std::to_string(index) + " is not of the chain");
    const bool owed = std::ranges::any_of(m_debts, [&](const Debt& debt) { return debt.index == index; });
    const std::uint8_t place = m_rig->known->modules[index].place;
    if (owed && place != KnownChain::kNowhere && !m_rig->atRest(place))
        m_rig->complain("owed: module " + std::to_string(index) + " is confirmed and moves");
    std::erase_if(m_debts, [&](const Debt& debt) { return debt.index == index; });
}

/// A start ends the debt: one from before, or a new one by the operator. That nothing else starts a motor is
/// checked by StopOath.
void OwedStopOath::onSent(const WireItem& item) {
    if (startsMotion(item))
        std::erase_if(m_debts, [&](const Debt& debt) {
            return item.address() == debt.address || item.address() >= kFirstGroup;
        });
}

void OwedStopOath::onTime() {
    const TimePoint now = m_rig->bus.now;
    if (now < m_nextLook || !m_rig->known)
        return;
    m_nextLook = now + kLookEvery;
    std::erase_if(m_debts, [&](Debt& debt) {
        if (!m_rig->hears(debt.place, debt.address, m_rig->known->baud))
            debt.heardSince = now;
        const bool late = now - debt.heardSince > kSoon;
        if (late && !m_rig->isDriven(debt.place) && !m_rig->atRest(debt.place))
            m_rig->complain("owed: module " + std::to_string(debt.index) + " hears, and runs on");
        return late;
    });
}

}  // namespace nmc::test
