// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/flightcontroller.h"
#include "app/recordingcontroller.h"
#include "link/command/procedurecontroller.h"
#include "link/connection/busstore.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Tells the window what is the case and what has happened, and when that is over: a fault of a module ends
/// with its cause, which look() compares; what a module did not do, when it obeys again; and all of a
/// connection with it. What can be looked at in the scope afterwards is kept. GUI thread.
class MessageController : public QObject {
    Q_OBJECT

public:
    MessageController(MainWindow& window, const BusStore& store, const ProcedureController& procedures,
                      FlightController& flight, RecordingController& recordings, QObject* parent = nullptr);

    /// Tells what is the case by now and was not, and ends what is not any more. With every news.
    void look();

    /// Whoever tells it ends it, too.
    void report(const Message& message);
    /// What its module did not do; over when it obeys again.
    void reportOf(const Message& message);
    /// Of the chain as it is in this connection.
    void reportOfChain(const Message& message);
    /// Of modules that were told to stop: the message says so when they are seen at rest.
    void noteStop(const Message& message, bus::StopCause cause, const std::vector<ModuleIndex>& modules);

    void stopConfirmed(const bus::OwedStopConfirmed& confirmed);
    void obeyed(ModuleIndex module);
    /// The chain has been looked for anew: what still is the case is told again.
    void chainFound();
    void connectionEnded();
    void end(const QString& key) { m_window.endMessage(key); }

signals:
    /// What will be told now is told of what can be seen.
    void aboutToReport();

private:
    void endEvents(std::optional<ModuleIndex> obeyed);

    MainWindow& m_window;
    const BusStore& m_store;
    const ProcedureController& m_procedures;
    FlightController& m_flight;
    RecordingController& m_recordings;
    struct Standing {
        ModuleIndex module;
        std::uint32_t connection = 0;
    };
    std::map<QString, Standing> m_standing;                  ///< what is the case, by key
    std::map<QString, std::optional<ModuleIndex>> m_events;  ///< empty: of the chain
    /// Which message tells of it, with its words, which grow.
    std::map<std::pair<bus::StopCause, ModuleIndex>, QString> m_stopping;
    std::map<QString, Message> m_stopMessages;
};

}  // namespace nmc
