// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "model/module/modulescale.h"
#include "model/procedure/procedure.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {

/// A change that the user has just made to an axis, to be applied to its present settings: each box changes
/// only its own part of them.
using SettingsEdit = std::function<void(AxisSettings&)>;

/// Everything that the panel of a module shows, as one value; valid only during the call.
struct PanelView {
    const ModuleState& module;
    const AxisSettings& settings;
    const ProcedureReport* procedure = nullptr;  ///< the last one of this module
    bool connected = false;
    std::optional<double> age{};            ///< s; age of a state that is older than it should be
    std::optional<ModuleIndex> namesake{};  ///< another module of the chain with the same axis name

    [[nodiscard]] AxisScale scale() const { return scaleOf(module, settings); }
    /// The gains of the module; while others are tried, those from before: the ones on trial are temporary,
    /// and their output limit is lowered.
    [[nodiscard]] const std::optional<servo::SetGain>& gains() const {
        return procedure != nullptr && procedure->tries() ? procedure->gains : module.gains;
    }
};

}  // namespace nmc
