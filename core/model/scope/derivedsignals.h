// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "model/scope/customsignal.h"
#include "model/scope/history.h"

namespace nmc {

/// Signals that no sample contains, computed from the samples for as long as they are wanted. Each has its
/// own pyramid, so that drawing it costs as much as drawing any other signal. A signal that is not displayed
/// costs nothing. One thread.
class DerivedSignals {
public:
    static constexpr std::size_t kBudget = 16U << 20U;
    /// Samples per call: a millisecond or two of work.
    static constexpr std::uint64_t kAtOnce = 20'000;

    /// `budget`: bytes for each signal; its oldest values are given up when it is used up.
    explicit DerivedSignals(std::size_t budget);
    DerivedSignals() : DerivedSignals(kBudget) {}
    ~DerivedSignals();
    DerivedSignals(DerivedSignals&&) noexcept;
    DerivedSignals& operator=(DerivedSignals&&) noexcept;

    /// Selects the signals from now on; those that are not derived are ignored, and so are the user's that
    /// `custom` does not define.
    void want(std::vector<ModuleSignal> wanted, const std::vector<CustomSignal>& custom = {});
    /// Processes the new samples, always of the same history until forget(). Returns false when there are
    /// more, for another call.
    bool follow(const History& history);
    /// Called when the data are replaced.
    void forget();

    /// The history that holds the values of a signal, and as which signal.
    [[nodiscard]] SignalSource source(const History& history, const ModuleSignal& of) const;

private:
    class Track;
    std::size_t m_budget;
    std::uint64_t m_made = 0;  ///< number of tracks so far
    std::vector<std::unique_ptr<Track>> m_tracks;
};

}  // namespace nmc
