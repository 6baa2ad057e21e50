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

/// Shows conditions and events in the window, and ends their messages: a module's fault ends with its cause,
/// which look() checks; a command that a module did not carry out, when it obeys again; and everything else
/// with the connection. Events that can be viewed in the scope later are recorded. GUI thread.
class MessageController : public QObject {
    Q_OBJECT

public:
    MessageController(MainWindow& window, const BusStore& store, const ProcedureController& procedures,
                      FlightController& flight, RecordingController& recordings, QObject* parent = nullptr);

    /// Shows conditions that have begun, and ends those that are over. Call with every event.
    void look();

    /// The caller also ends this message.
    void report(const Message& message);
    /// Reports what a module did not do; ends when it obeys again.
    void reportOf(const Message& message);
    /// Reports a problem of the chain; ends with this connection.
    void reportOfChain(const Message& message);
    /// Notes that `message` reports a stop sent to these modules; it is amended when they are seen at rest.
    void noteStop(const Message& message, bus::StopCause cause, const std::vector<ModuleIndex>& modules);

    void stopConfirmed(const bus::OwedStopConfirmed& confirmed);
    void obeyed(ModuleIndex module);
    /// The chain has been searched for again: conditions that persist are reported again.
    void chainFound();
    void connectionEnded();
    void end(const QString& key) { m_window.endMessage(key); }

signals:
    /// Emitted before a message, so that the window is up to date with what the message reports.
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
    std::map<QString, Standing> m_standing;                  ///< present conditions, by key
    std::map<QString, std::optional<ModuleIndex>> m_events;  ///< empty: concerns the chain
    /// The message that reports each stop, and its text, which is amended.
    std::map<std::pair<bus::StopCause, ModuleIndex>, QString> m_stopping;
    std::map<QString, Message> m_stopMessages;
};

}  // namespace nmc
