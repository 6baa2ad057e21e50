// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QList>
#include <functional>

namespace nmc {

class ScopeStrips;

/// What the wheel and the mouse can do, for the keyboard: actions whose owner is `parent`. Each hands what it
/// does to `carryOut`.
[[nodiscard]] QList<QAction*> newScopeMoves(
    QObject* parent, const std::function<void(const std::function<void(ScopeStrips&)>&)>& carryOut);

}  // namespace nmc
