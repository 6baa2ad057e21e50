// SPDX-License-Identifier: MIT
#include "model/scope/signalmaker.h"

namespace nmc {

SignalMaker::SignalMaker(const ModuleSignal& of) : m_of(of) {
    if (of.signal == ScopeSignal::Pwm)
        m_maker = PwmOutput();
    else if (of.signal == ScopeSignal::CountRate)
        m_maker = CountRate();
}

std::optional<ScopeSample> SignalMaker::take(const ScopeSample& sample,
                                             const std::vector<GainsChange>& gains) {
    for (; m_gainsTaken < gains.size() && gains[m_gainsTaken].time <= sample.time; ++m_gainsTaken)
        if (gains[m_gainsTaken].module == m_of.module)
            m_gains = gains[m_gainsTaken].gains;
    if (auto* pwm = std::get_if<PwmOutput>(&m_maker))
        return pwm->take(sample, m_gains);
    if (auto* rate = std::get_if<CountRate>(&m_maker))
        return rate->take(sample);
    return std::get<MeasuredAcceleration>(m_maker).take(sample);
}

}  // namespace nmc
