// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "model/scope/history.h"
#include "model/scope/signalmaker.h"

namespace nmc {

/// The signals that no sample has, made from samples for as long as they are wanted, each with a pyramid of
/// its own, so that drawing them costs what drawing any other costs. What nobody looks at costs nothing. One
/// thread.
class DerivedSignals {
public:
    static constexpr std::size_t kBudget = 16U << 20U;  ///< bytes, of each
    /// Samples: a millisecond or two of work.
    static constexpr std::uint64_t kAtOnce = 20'000;

    DerivedSignals();
    ~DerivedSignals();
    DerivedSignals(DerivedSignals&&) noexcept;
    DerivedSignals& operator=(DerivedSignals&&) noexcept;

    /// From now on; those of them that are not derived are left out.
    void want(const std::vector<ModuleSignal>& wanted);
    /// Takes what has come, always of the same history until forget(). False: there is more of it, for
    /// another call.
    bool follow(const History& history);
    /// Other data.
    void forget();

    /// Where the values of a signal are, and as which signal; `samples` is null where there are none.
    struct Source {
        const ModuleHistory* samples = nullptr;
        ScopeSignal signal = ScopeSignal::Position;
    };
    [[nodiscard]] Source source(const History& history, const ModuleSignal& of) const;

private:
    class Track;
    std::vector<std::unique_ptr<Track>> m_tracks;
};

}  // namespace nmc
