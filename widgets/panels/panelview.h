// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "model/intent/intent.h"
#include "model/module/modulescale.h"
#include "model/procedure/procedure.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"

namespace nmc {

/// What the user has just changed of an axis, to be done to its settings as they are: the box that says so
/// touches its own part of them, and knows nothing of the others.
using SettingsEdit = std::function<void(AxisSettings&)>;

/// Everything that the panel of a module shows, as one value; valid for the call only.
struct PanelView {
    const ModuleState& module;
    const AxisSettings& settings;
    const ProcedureReport* procedure = nullptr;  ///< the last one of this module
    bool connected = false;
    std::optional<double> age{};  ///< s, of what is older than it should be

    [[nodiscard]] std::optional<Refusal> whyNot(IntentKind kind) const {
        return connected ? nmc::whyNot(kind, module) : std::optional(Refusal::NotConnected);
    }
    [[nodiscard]] AxisScale scale() const { return scaleOf(module, settings); }
};

}  // namespace nmc
