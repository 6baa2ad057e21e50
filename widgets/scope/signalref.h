// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "base/strong.h"
#include "model/scope/scopesignal.h"

namespace nmc {

/// A signal as the user chooses it; if `module` is empty, that of the module selected in the window.
struct SignalRef {
    std::optional<ModuleIndex> module;
    ScopeSignal signal = ScopeSignal::Position;
    auto operator<=>(const SignalRef&) const = default;

    /// Text for the settings file.
    [[nodiscard]] QString toText() const;
    [[nodiscard]] static std::optional<SignalRef> fromText(const QString& text);
};

}  // namespace nmc
