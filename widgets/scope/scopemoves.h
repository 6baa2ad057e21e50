// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>
#include <functional>

namespace nmc {

class ScopeStrips;

/// Creates actions that do by keyboard what the wheel and the mouse do; `parent` owns them. Each passes its
/// change to `carryOut`.
[[nodiscard]] QList<QAction*> newScopeMoves(
    QObject* parent, const std::function<void(const std::function<void(ScopeStrips&)>&)>& carryOut);

}  // namespace nmc
