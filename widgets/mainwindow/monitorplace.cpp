// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/monitorplace.h"

#include <QAction>
#include <QMainWindow>

#include "widgets/monitor/monitordock.h"

namespace nmc {

namespace {

/// Width, in lines of text, for the time, the bytes and the beginning of their meaning.
constexpr int kWantedWidth = 44;

void makeRoom(QMainWindow& window, MonitorDock& monitor, QDockWidget& scope) {
    monitor.raise();
    const int wanted = monitor.fontMetrics().height() * kWantedWidth;
    const bool beside = window.dockWidgetArea(&monitor) == window.dockWidgetArea(&scope) && scope.isVisible();
    if (!beside || monitor.width() >= wanted)
        return;
    const int both = monitor.width() + scope.width();
    const int taken = qMin(wanted, both * 2 / 3);
    window.resizeDocks({&scope, &monitor}, {both - taken, taken}, Qt::Horizontal);
}

}  // namespace

void placeMonitor(QMainWindow& window, MonitorDock& monitor, QDockWidget& messages, QDockWidget& scope) {
    window.addDockWidget(Qt::BottomDockWidgetArea, &monitor);
    window.tabifyDockWidget(&messages, &monitor);
    monitor.hide();
    // Queued: until then, the layout does not know that the monitor is visible.
    QObject::connect(
        monitor.toggleViewAction(), &QAction::triggered, &monitor,
        [&window, &monitor, &scope](bool shown) {
            if (shown)
                makeRoom(window, monitor, scope);
        },
        Qt::QueuedConnection);
}

}  // namespace nmc
