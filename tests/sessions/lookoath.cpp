// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sessions/lookoath.h"

#include "tests/sessions/rig.h"

namespace nmc::test {

void LookOath::begin() {
    m_stopAsked = false;
    m_moving.clear();
    for (std::uint8_t place = 0; place < m_rig->size(); ++place)
        m_moving.push_back(!m_rig->atRest(place));
    m_before = m_rig->bus.chain.statistics();
}

void LookOath::onPowerCycle(std::uint8_t place) {
    if (place < m_moving.size())
        m_moving[place] = false;
}

bool LookOath::permits(CommandCode code) const {
    return code == CommandCode::Nop || code == CommandCode::ReadStatus ||
           (code == CommandCode::StopMotor && m_stopAsked);
}

void LookOath::onSent(const WireItem& item) {
    const bool nulls = item.packet.empty();
    if (!nulls && (!item.code() || !permits(*item.code())))
        m_rig->complain("wire: " + toHex(item.packet) + " went out");
}

void LookOath::onEvent(const bus::Event& event) {
    if (std::holds_alternative<bus::MotionSuspect>(event))
        m_rig->complain("motions: that of somebody else is suspected");
}

void LookOath::check() {
    const sim::ChainStatistics now = m_rig->bus.chain.statistics();
    for (std::uint8_t place = 0; place < m_moving.size(); ++place) {
        const std::string named = "place " + std::to_string(place);
        for (unsigned c = 0; c < now.modules[place].executed.size(); ++c)
            // Noise before nulls may turn them into a packet: AA and zeros reset the position at address 0.
            if (!m_rig->noisyCommands && !permits(static_cast<CommandCode>(c)) &&
                now.modules[place].executed[c] != m_before.modules[place].executed[c])
                m_rig->complain("truth: " + named + " has carried out command " + std::to_string(c));
        if (m_moving[place] && !m_stopAsked && m_rig->atRest(place))
            m_rig->complain("motions: " + named + " does not move any more");
    }
}

}  // namespace nmc::test
