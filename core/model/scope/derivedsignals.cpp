// SPDX-License-Identifier: MIT
#include "model/scope/derivedsignals.h"

#include <algorithm>
#include <variant>

#include "model/scope/countrate.h"
#include "model/scope/measuredacceleration.h"
#include "model/scope/pwmoutput.h"

namespace nmc {

class DerivedSignals::Track {
public:
    /// `of` must be a derived signal, but not a custom one. `number`: no other track has had it.
    Track(const ModuleSignal& of, std::size_t budget, std::uint64_t number)
        : m_of(of), m_values(1, budget), m_number(number) {
        if (of.signal == ScopeSignal::Pwm)
            m_maker = PwmOutput();
        else if (of.signal == ScopeSignal::CountRate)
            m_maker = CountRate();
    }
    Track(const CustomSignal& how, std::size_t budget, std::uint64_t number)
        : m_of(how.of), m_maker(CustomSignalMaker(how)), m_values(1, budget), m_number(number) {}

    /// Forgets all values, and what was computed so far.
    void startOver(std::size_t budget, std::uint64_t number) {
        *this = custom() != nullptr ? Track(*custom(), budget, number) : Track(m_of, budget, number);
    }
    /// Null unless it is the user's.
    [[nodiscard]] const CustomSignal* custom() const {
        const auto* maker = std::get_if<CustomSignalMaker>(&m_maker);
        return maker != nullptr ? &maker->how() : nullptr;
    }
    [[nodiscard]] const ModuleSignal& of() const { return m_of; }
    [[nodiscard]] SignalSource source() const {
        return {m_values.module(ModuleIndex(0)), ScopeSignal::Error, m_number};
    }

    bool follow(const History& history, const DerivedSignals& others) {
        return std::visit([&](auto& maker) { return follow(maker, history, others); }, m_maker);
    }

private:
    bool follow(auto& maker, const History& history, const DerivedSignals& /*others*/) {
        const ModuleHistory* samples = history.module(m_of.module);
        if (samples == nullptr)
            return true;
        m_taken = samples->visitSince(
            m_taken,
            [&](const ScopeSample& sample) {
                if (const auto value = take(maker, sample, history.gains()))
                    m_values.append(ModuleIndex(0), *value);
            },
            kAtOnce);
        return m_taken == samples->count();
    }
    bool follow(CustomSignalMaker& maker, const History& history, const DerivedSignals& others) {
        const CustomSignal& how = maker.how();
        const SignalSource first = others.source(history, how.first.of);
        const SignalSource second = how.second ? others.source(history, how.second->of) : first;
        if (first.samples == nullptr || second.samples == nullptr)
            return true;
        const auto last = second.samples->last();
        bool waits = false;  // for the second part
        const auto take = [&](const ScopeSample& sample) {
            waits = !last || sample.time > last->time;
            if (waits)
                return;
            if (const auto value = maker.take(sample, first.signal, second))
                m_values.append(ModuleIndex(0), *value);
        };
        for (std::uint64_t i = 0; i < kAtOnce; ++i) {
            const std::uint64_t next = first.samples->visitSince(m_taken, take, 1);
            if (waits || next == m_taken)
                return true;
            m_taken = next;
        }
        return m_taken == first.samples->count();
    }

    static std::optional<ScopeSample> take(auto& maker, const ScopeSample& sample,
                                           const std::vector<GainsChange>& /*gains*/) {
        return maker.take(sample);
    }
    std::optional<ScopeSample> take(PwmOutput& maker, const ScopeSample& sample,
                                    const std::vector<GainsChange>& gains) {
        for (; m_gainsTaken < gains.size() && gains[m_gainsTaken].time <= sample.time; ++m_gainsTaken)
            if (gains[m_gainsTaken].module == m_of.module)
                m_gains = gains[m_gainsTaken].gains;
        return maker.take(sample, m_gains);
    }

    ModuleSignal m_of;
    std::variant<MeasuredAcceleration, PwmOutput, CountRate, CustomSignalMaker> m_maker;
    History m_values;
    std::uint64_t m_number;
    std::uint64_t m_taken = 0;
    std::size_t m_gainsTaken = 0;
    std::optional<servo::SetGain> m_gains;
};

DerivedSignals::DerivedSignals(std::size_t budget) : m_budget(budget) {}
DerivedSignals::~DerivedSignals() = default;
DerivedSignals::DerivedSignals(DerivedSignals&&) noexcept = default;
DerivedSignals& DerivedSignals::operator=(DerivedSignals&&) noexcept = default;

void DerivedSignals::want(std::vector<ModuleSignal> wanted, const std::vector<CustomSignal>& custom) {
    const auto has = [this](const ModuleSignal& signal) {
        return std::ranges::any_of(m_tracks, [&](const auto& track) { return track->of() == signal; });
    };
    for (const CustomSignal& how : custom) {
        wanted.push_back(how.first.of);
        if (how.second)
            wanted.push_back(how.second->of);
    }
    std::erase_if(m_tracks, [&](const auto& track) {
        return track->custom() != nullptr ? std::ranges::find(custom, *track->custom()) == custom.end()
                                          : std::ranges::find(wanted, track->of()) == wanted.end();
    });
    for (const ModuleSignal& signal : wanted)
        if (isDerived(signal.signal) && !customIndex(signal.signal) && !has(signal))
            m_tracks.push_back(std::make_unique<Track>(signal, m_budget, ++m_made));
    for (const CustomSignal& how : custom)
        if (!has(how.of))
            m_tracks.push_back(std::make_unique<Track>(how, m_budget, ++m_made));
}

bool DerivedSignals::follow(const History& history) {
    bool all = true;
    for (const auto& track : m_tracks)
        all = track->follow(history, *this) && all;
    return all;
}

void DerivedSignals::forget() {
    for (const auto& track : m_tracks)
        track->startOver(m_budget, ++m_made);
}

SignalSource DerivedSignals::source(const History& history, const ModuleSignal& of) const {
    if (!isDerived(of.signal))
        return {history.module(of.module), of.signal};
    for (const auto& track : m_tracks)
        if (track->of() == of)
            return track->source();
    return {};
}

}  // namespace nmc
