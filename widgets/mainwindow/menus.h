// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QAction;
class QDockWidget;
class QMenuBar;
class QSettings;

namespace nmc {

class MainWindow;

/// Adds the menus File, Chain, Module, View and Help. `connectReadOnly` is added to Chain; View has a toggle
/// for each dock, and the languages; `settings` stores the chosen one.
void fillMenus(QMenuBar& bar, MainWindow& window, QAction* connectReadOnly, const QList<QDockWidget*>& docks,
               QSettings& settings);

}  // namespace nmc
