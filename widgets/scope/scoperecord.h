// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "widgets/scope/scopemodule.h"

namespace nmc {

/// Something to be looked at in the scope that is over: a recording from a file, or what happened around a
/// fault.
struct ScopeRecord {
    QString title;  ///< "mill.csv", "Module 1 switched itself off, 14:02:11"
    History history;
    std::vector<ScopeModule> modules;
    bool simulated = false;
    std::optional<ModuleIndex> module{};  ///< the one that it is about
    std::optional<TimePoint> event{};     ///< when it happened
};

}  // namespace nmc
