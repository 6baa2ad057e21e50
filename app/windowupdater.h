// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "app/flightcontroller.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Shows the store's state in the window, no more often than it can be read: the modules, the samples and
/// packets in frames, and figures once a second. Has the modules on display polled more often. GUI thread.
class WindowUpdater : public QObject {
    Q_OBJECT

public:
    WindowUpdater(MainWindow& window, BusStore& store, BusWorker& worker, Commander& commander,
                  FlightController& flight);

    /// A connection is being opened.
    void begin();
    /// Shows at once what waits to be shown.
    void catchUp();
    /// Call for every event.
    void take(const StoreEvent& event);

signals:
    void ratesMeasured(const nmc::LinkFigures& figures);

private:
    /// The state that the window's controls depend on.
    struct Shown {
        explicit Shown(const LinkState& link);
        LinkPhase phase;
        std::uint32_t connection;
        std::optional<LentLine> lent;
        std::vector<std::tuple<Activity, std::optional<bus::OperationId>, std::optional<servo::SetGain>>>
            modules;
        bool operator==(const Shown&) const = default;
    };

    void showLinkSoon();
    void showLink();
    void showFrame();
    void showFrameSoon();
    void showFigures();

    MainWindow& m_window;
    BusStore& m_store;
    BusWorker& m_worker;
    Commander& m_commander;
    FlightController& m_flight;
    QTimer m_linkTimer;
    QElapsedTimer m_linkShown;
    std::optional<Shown> m_shown;
    bool m_frames = false;  ///< a frame follows each report; otherwise, each wish of the scope
    QTimer m_frameTimer;
    QTimer m_figuresTimer;
    std::set<ModuleIndex> m_watched;  ///< polled most by the worker: shown in panels and scope
};

}  // namespace nmc
