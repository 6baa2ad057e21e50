// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QDockWidget;
class QMenuBar;

namespace nmc {

class MainWindow;

/// File, View and Help. View has a toggle for each dock.
void fillMenus(QMenuBar& bar, MainWindow& window, const QList<QDockWidget*>& docks);

}  // namespace nmc
