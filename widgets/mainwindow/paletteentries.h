// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/mainwindow/commandpalette.h"

class QAction;
class QMenuBar;

namespace nmc {

class ModulePanel;
class Session;

/// What can be found in the palette: the pendant and the commands of the page that is shown, what is in the
/// menus, and the commands of the other modules. `panel` and `session` must outlive the entries.
[[nodiscard]] std::vector<CommandPalette::Entry> paletteEntries(ModulePanel& panel, Session& session,
                                                                QAction* pendant, const QMenuBar& menus);

}  // namespace nmc
