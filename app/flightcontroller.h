// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "link/connection/busstore.h"
#include "model/scope/flightrecorder.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Keeps the data around a fault or a stop for its message: "Show the last 2 s". GUI thread.
class FlightController {
public:
    FlightController(MainWindow& window, const BusStore& store) : m_window(window), m_store(store) {}

    /// `what`: headline of the message that reports it. Returns the number of the record (Message::record), 0
    /// if there are no samples of what led to it.
    unsigned note(const QString& what, std::optional<ModuleIndex> module, TimePoint at);
    /// Call once per frame.
    void keep(TimePoint now) { m_recorder.keep(m_store.history(), now); }
    /// Call when the connection has ended.
    void keepAll() { m_recorder.keepAll(m_store.history()); }
    /// Shows the record in the scope if anything was recorded.
    void show(unsigned record);

private:
    /// As at the time of the event, because the chain may be a different one when the record is viewed.
    struct Circumstances {
        QString title;
        std::vector<ScopeModule> modules;
        QString port;
        bool simulated = false;
        QDateTime date;
    };

    MainWindow& m_window;
    const BusStore& m_store;
    FlightRecorder m_recorder;
    std::map<unsigned, Circumstances> m_circumstances;
};

}  // namespace nmc
