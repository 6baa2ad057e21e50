// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMenuBar;
class QSettings;

namespace nmc {

class MainWindow;

/// Adds the menus File, Chain, Module, View and Help of a window that has all its parts. `settings` stores
/// the chosen language.
void fillMenus(QMenuBar& bar, MainWindow& window, QSettings& settings);

}  // namespace nmc
