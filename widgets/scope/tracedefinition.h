// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "widgets/scope/scopemodule.h"

namespace nmc {

/// A trace as the user defines it: one signal or the sum of two, each in the unit in which it is shown and
/// multiplied by a factor, and then through a low-pass filter.
struct TraceDefinition {
    static constexpr int kLongestName = 24, kLongestUnit = 12;
    static constexpr double kLeastFactor = 1e-9, kMostFactor = 1e9;  ///< without their sign
    static constexpr double kMostCutoff = 1'000;                     ///< Hz

    struct Part {
        SignalRef signal;  ///< not itself a custom trace; its module may be empty
        double factor = 1;
        bool operator==(const Part&) const = default;
    };
    QString name, unit;
    Part first{};
    std::optional<Part> second{};
    double cutoff = 0;  ///< Hz, of the filter; 0: none

    /// Text for the settings file, without = and ;.
    [[nodiscard]] QString toText() const;
    [[nodiscard]] static std::optional<TraceDefinition> fromText(const QString& text);
    /// As it is shown for a module under `place`; nothing if one of its signals does not exist there.
    [[nodiscard]] std::optional<CustomTrace> at(const ModuleSignal& place,
                                                const std::vector<ScopeModule>& modules) const;
    bool operator==(const TraceDefinition&) const = default;
};
using TraceDefinitions = std::array<std::optional<TraceDefinition>, kCustomSignals>;

/// The modules, which have no traces of the user's yet, with these.
[[nodiscard]] std::vector<ScopeModule> withTraces(const std::vector<ScopeModule>& modules,
                                                  const TraceDefinitions& definitions);

}  // namespace nmc
