// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <map>
#include <vector>

#include "widgets/scope/scopewords.h"
#include "widgets/scope/tracedefinition.h"

namespace nmc {

/// What the scope shows, as the user has arranged it; kept between sessions.
struct ScopeSetup {
    static constexpr std::size_t kStrips = 4;

    /// Limits of the height of a strip, relative to the others.
    static constexpr double kLowest = 0.05, kHighest = 20;

    /// From the top; a strip without signals is not shown.
    std::array<std::vector<SignalRef>, kStrips> strips;
    std::array<double, kStrips> heights{1.5, 1, 1.2, 1.2};  ///< in any unit
    bool lane = false;                                      ///< of status bits is shown
    bool readings = true;                                   ///< unfolded while cursors are shown
    double seconds = 10;
    /// Bits in the lane for each type of module, where they are not the usual ones.
    std::map<ModuleType, std::vector<ScopeBit>> bits{};
    TraceDefinitions custom{};  ///< the user's own traces, for the signals Custom1 to Custom4

    /// Position and command position, below them the error, and below that the A/D values (such as the motor
    /// current) where they are reported.
    [[nodiscard]] static ScopeSetup usual();
    /// Position and error, equally high: there, the error is what matters.
    [[nodiscard]] static ScopeSetup forTuning();
    /// Text for the settings file.
    [[nodiscard]] QString toText() const;
    /// Anything that the text lacks, or that is unreadable, is as in `initial`; if neither signals nor the
    /// lane remain, so are the signals.
    [[nodiscard]] static ScopeSetup fromText(const QString& text, const ScopeSetup& initial = usual());

    [[nodiscard]] bool shows(std::size_t strip, const SignalRef& signal) const;
    void set(std::size_t strip, const SignalRef& signal, bool shown);
    [[nodiscard]] std::vector<ScopeBit> bitsOf(ModuleType type) const;
    /// Modules that are shown whichever module is selected.
    [[nodiscard]] std::vector<ModuleIndex> fixedModules() const;

    bool operator==(const ScopeSetup&) const = default;
};

}  // namespace nmc
