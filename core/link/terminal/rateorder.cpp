// SPDX-License-Identifier: MIT
#include "link/terminal/rateorder.h"

namespace nmc {

std::size_t RateOrder::beforeNewRate(const HostActs& acts, std::uint32_t baud, bool modulesHaveIt) {
    const std::size_t all = acts.bytes.size();
    const bool changed = acts.baud.value_or(baud) != baud;
    if (changed && acts.first == FirstAct::SetTerminal) {
        m_sentRateCommand = false;
        endOfLastRateCommand(acts.bytes);
        return 0;
    }
    const bool wantsNewRate = m_sentRateCommand;
    const std::size_t behindRateCommand = endOfLastRateCommand(acts.bytes);
    if (!changed)
        return all;
    m_sentRateCommand = false;
    if (behindRateCommand > 0 || wantsNewRate)
        return behindRateCommand;
    return acts.first == FirstAct::Wrote || modulesHaveIt ? all : 0;
}

std::size_t RateOrder::endOfLastRateCommand(ByteSpan bytes) {
    std::size_t end = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (!m_monitor.hears(bytes[i], false))
            continue;
        const sim::Packet& packet = m_monitor.packet();
        const bool isOne = packet.code() == CommandCode::SetBaud || packet.code() == CommandCode::HardReset;
        m_sentRateCommand = isOne && packet.sumIsRight();
        if (m_sentRateCommand)
            end = i + 1;
    }
    return end;
}

}  // namespace nmc
