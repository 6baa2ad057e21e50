// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <map>
#include <vector>

#include "widgets/scope/scopemodule.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

/// What the scope shows, as the user has arranged it; kept between sessions.
struct ScopeSetup {
    static constexpr std::size_t kStrips = 4;

    /// Of a strip, against the others.
    static constexpr double kLowest = 0.05, kHighest = 20;

    /// From the top; a strip without signals is not shown.
    std::array<std::vector<SignalRef>, kStrips> strips;
    std::array<double, kStrips> heights{1.5, 1, 1.2, 1.2};  ///< in any unit
    bool lane = false;                                      ///< of status bits
    bool readings = true;                                   ///< unfolded, where there are cursors
    double seconds = 10;
    /// Of each kind of module, where they are not the usual ones.
    std::map<ModuleType, std::vector<ScopeBit>> bits{};

    /// Position with its command, below them the error, and the current where it is reported.
    [[nodiscard]] static ScopeSetup usual();
    /// For the settings file.
    [[nodiscard]] QString toText() const;
    /// What cannot be read is left out; nothing readable at all is the usual.
    [[nodiscard]] static ScopeSetup fromText(const QString& text);

    [[nodiscard]] bool shows(std::size_t strip, const SignalRef& signal) const;
    void set(std::size_t strip, const SignalRef& signal, bool shown);
    [[nodiscard]] std::vector<ScopeBit> bitsOf(ModuleType type) const;
    /// Modules that are shown whichever is selected.
    [[nodiscard]] std::vector<ModuleIndex> fixedModules() const;

    bool operator==(const ScopeSetup&) const = default;
};

}  // namespace nmc
