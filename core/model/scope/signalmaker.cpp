// SPDX-License-Identifier: MIT
#include "model/scope/signalmaker.h"

namespace nmc {

ScopeSample derivedSample(TimePoint time, double likely, double low, double high, bool gapBefore) {
    ScopeSample value;
    value.time = time;
    value.error = static_cast<float>(likely);
    value.errorLow = static_cast<float>(low);
    value.errorHigh = static_cast<float>(high);
    value.gapBefore = gapBefore;
    return value;
}

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
    if (auto* pwm = std::get_if<PwmOutput>(&m_maker)) {
        const auto made = pwm->take(sample, m_gains);
        return made ? std::optional(
                          derivedSample(made->time, made->likely, made->low, made->high, made->gapBefore))
                    : std::nullopt;
    }
    const auto exact = [](const auto& made) {
        return made ? std::optional(
                          derivedSample(made->time, made->value, made->value, made->value, made->gapBefore))
                    : std::nullopt;
    };
    if (auto* rate = std::get_if<CountRate>(&m_maker))
        return exact(rate->take(sample));
    return exact(std::get<MeasuredAcceleration>(m_maker).take(sample));
}

}  // namespace nmc
