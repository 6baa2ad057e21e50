// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QDockWidget;
class QMainWindow;

namespace nmc {

class MonitorDock;

/// Puts the packet monitor behind the messages' tab, closed. When the user opens it, it comes to the front
/// and takes room from the scope beside it.
void placeMonitor(QMainWindow& window, MonitorDock& monitor, QDockWidget& messages, QDockWidget& scope);

}  // namespace nmc
