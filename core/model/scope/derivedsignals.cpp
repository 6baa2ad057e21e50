// SPDX-License-Identifier: MIT
#include "model/scope/derivedsignals.h"

#include <algorithm>
#include <variant>

#include "model/scope/countrate.h"
#include "model/scope/measuredacceleration.h"
#include "model/scope/pwmoutput.h"

namespace nmc {

/// Its values are kept as calculated errors are, because these have bounds.
class DerivedSignals::Track {
public:
    explicit Track(const ModuleSignal& of) : m_of(of) { forget(); }

    [[nodiscard]] const ModuleSignal& of() const { return m_of; }
    [[nodiscard]] const ModuleHistory& values() const { return *m_values.module(ModuleIndex(0)); }

    void forget() {
        m_values = History(1, kBudget);
        m_taken = 0;
        m_gainsTaken = 0;
        m_gains.reset();
        if (m_of.signal == ScopeSignal::Pwm)
            m_maker = PwmOutput();
        else if (m_of.signal == ScopeSignal::CountRate)
            m_maker = CountRate();
        else
            m_maker = MeasuredAcceleration();
    }

    bool follow(const History& history) {
        const ModuleHistory* samples = history.module(m_of.module);
        if (samples == nullptr)
            return true;
        m_taken = samples->visitSince(
            m_taken, [&](const ScopeSample& sample) { take(sample, history.gains()); }, kAtOnce);
        return m_taken == samples->count();
    }

private:
    void take(const ScopeSample& sample, const std::vector<GainsChange>& gains) {
        for (; m_gainsTaken < gains.size() && gains[m_gainsTaken].time <= sample.time; ++m_gainsTaken)
            if (gains[m_gainsTaken].module == m_of.module)
                m_gains = gains[m_gainsTaken].gains;
        if (auto* pwm = std::get_if<PwmOutput>(&m_maker)) {
            if (const auto made = pwm->take(sample, m_gains))
                keep(made->time, made->likely, made->low, made->high, made->gapBefore);
        } else if (auto* rate = std::get_if<CountRate>(&m_maker)) {
            if (const auto made = rate->take(sample))
                keep(made->time, made->value, made->value, made->value, made->gapBefore);
        } else if (const auto made = std::get<MeasuredAcceleration>(m_maker).take(sample)) {
            keep(made->time, made->value, made->value, made->value, made->gapBefore);
        }
    }
    void keep(TimePoint time, double value, double low, double high, bool gapBefore) {
        ScopeSample made;
        made.time = time;
        made.error = static_cast<float>(value);
        made.errorLow = static_cast<float>(low);
        made.errorHigh = static_cast<float>(high);
        made.gapBefore = gapBefore;
        m_values.append(ModuleIndex(0), made);
    }

    ModuleSignal m_of;
    History m_values;
    std::uint64_t m_taken = 0;
    std::size_t m_gainsTaken = 0;
    std::optional<servo::SetGain> m_gains;
    std::variant<MeasuredAcceleration, PwmOutput, CountRate> m_maker;
};

DerivedSignals::DerivedSignals() = default;
DerivedSignals::~DerivedSignals() = default;
DerivedSignals::DerivedSignals(DerivedSignals&&) noexcept = default;
DerivedSignals& DerivedSignals::operator=(DerivedSignals&&) noexcept = default;

void DerivedSignals::want(const std::vector<ModuleSignal>& wanted) {
    const auto has = [this](const ModuleSignal& signal) {
        return std::any_of(m_tracks.begin(), m_tracks.end(),
                           [&](const auto& track) { return track->of() == signal; });
    };
    std::erase_if(m_tracks, [&](const auto& track) {
        return std::find(wanted.begin(), wanted.end(), track->of()) == wanted.end();
    });
    for (const ModuleSignal& signal : wanted)
        if (isDerived(signal.signal) && !has(signal))
            m_tracks.push_back(std::make_unique<Track>(signal));
}

bool DerivedSignals::follow(const History& history) {
    bool all = true;
    for (const auto& track : m_tracks)
        all = track->follow(history) && all;
    return all;
}

void DerivedSignals::forget() {
    for (const auto& track : m_tracks)
        track->forget();
}

DerivedSignals::Source DerivedSignals::source(const History& history, const ModuleSignal& of) const {
    if (!isDerived(of.signal))
        return {history.module(of.module), of.signal};
    for (const auto& track : m_tracks)
        if (track->of() == of)
            return {&track->values(), ScopeSignal::Error};
    return {};
}

}  // namespace nmc
