// SPDX-License-Identifier: MIT
#include "model/scope/derivedsignals.h"

#include <algorithm>

namespace nmc {

class DerivedSignals::Track {
public:
    explicit Track(const ModuleSignal& of) : m_maker(of), m_values(1, kBudget) {}

    [[nodiscard]] const ModuleSignal& of() const { return m_maker.of(); }
    [[nodiscard]] const ModuleHistory& values() const { return *m_values.module(ModuleIndex(0)); }

    bool follow(const History& history) {
        const ModuleHistory* samples = history.module(of().module);
        if (samples == nullptr)
            return true;
        m_taken = samples->visitSince(
            m_taken,
            [&](const ScopeSample& sample) {
                if (const auto value = m_maker.take(sample, history.gains()))
                    m_values.append(ModuleIndex(0), *value);
            },
            kAtOnce);
        return m_taken == samples->count();
    }

private:
    SignalMaker m_maker;
    History m_values;
    std::uint64_t m_taken = 0;
};

DerivedSignals::DerivedSignals() = default;
DerivedSignals::~DerivedSignals() = default;
DerivedSignals::DerivedSignals(DerivedSignals&&) noexcept = default;
DerivedSignals& DerivedSignals::operator=(DerivedSignals&&) noexcept = default;

void DerivedSignals::want(const std::vector<ModuleSignal>& wanted) {
    const auto has = [this](const ModuleSignal& signal) {
        return std::ranges::any_of(m_tracks, [&](const auto& track) { return track->of() == signal; });
    };
    std::erase_if(m_tracks,
                  [&](const auto& track) { return std::ranges::find(wanted, track->of()) == wanted.end(); });
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
        *track = Track(track->of());
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
