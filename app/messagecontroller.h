// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/flightcontroller.h"
#include "app/news.h"
#include "app/positionkeeper.h"
#include "app/recordingcontroller.h"
#include "link/command/procedurecontroller.h"
#include "link/connection/busstore.h"
#include "link/files/daylog.h"
#include "model/intent/intent.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Shows conditions and events in the window, and ends their messages: a module's fault ends with its cause,
/// which look() checks; a command that a module did not carry out, when it obeys again; and everything else
/// with the connection. Events that can be viewed in the scope later are recorded. All messages are logged,
/// because they outlive the session. GUI thread.
class MessageController : public QObject {
    Q_OBJECT

public:
    /// `logFolder` need not exist.
    MessageController(MainWindow& window, const BusStore& store, const ProcedureController& procedures,
                      const PositionKeeper& positions, FlightController& flight,
                      RecordingController& recordings, const QString& logFolder);

    /// Shows conditions that have begun, and ends those that are over. Call first for every event.
    void look();
    /// Reports an event. Not for the end of an operation that belongs to a procedure or a sequence.
    void take(const StoreEvent& event);

    /// The caller also ends this message.
    void report(const Message& message);
    /// Reports what a module did not do; ends when it obeys again.
    void reportOf(const Message& message);
    /// Reports a problem of the chain; ends with this connection.
    void reportOfChain(const Message& message);
    /// A precondition of the intent was not met.
    void refused(ModuleIndex module, Refusal refusal, const Intent& intent);
    /// A move was sent a stop, because a travel limit was set nearer.
    void stoppedBeyondTravel(ModuleIndex module);
    void end(const QString& key) { m_window.endMessage(key); }

signals:
    /// Emitted before a message, so that the window is up to date with what the message reports.
    void aboutToReport();

private:
    void keepLog(const QString& line);
    /// Keeps the record that the message offers.
    [[nodiscard]] Message recorded(Message message);
    void showEnd(const ProcedureReport& report);
    [[nodiscard]] AxisScale scaleOf(const ModuleState& module) const;
    void take(const News& news);
    void on(const auto&) {}
    void on(const bus::ChainFound& found);
    void on(const bus::OperationFinished& finished);
    void on(const bus::OwedStopConfirmed& confirmed);
    void on(const bus::StopFinished& finished);
    void on(const bus::ModuleUnresponsive& silence);
    void on(const bus::HealthChanged& changed);
    void on(const bus::Readdressed& readdressed);
    void on(const PortClosed& closed);
    void endEvents(std::optional<ModuleIndex> obeyed);
    /// Adds the confirmation to the message that reports the stop.
    void amend(const QString& key, const bus::OwedStopConfirmed& confirmed);

    MainWindow& m_window;
    const BusStore& m_store;
    const ProcedureController& m_procedures;
    FlightController& m_flight;
    RecordingController& m_recordings;
    DayLog m_log;
    struct Standing {
        ModuleIndex module;
        std::uint32_t connection = 0;
    };
    std::map<QString, Standing> m_standing;                  ///< present conditions, by key
    std::map<QString, std::optional<ModuleIndex>> m_events;  ///< empty: concerns the chain
    /// The message that reports the last stop of a module, and its text, which is amended. A stop
    /// of the same module for a fault may be confirmed in its place.
    std::map<ModuleIndex, std::pair<bus::StopCause, QString>> m_stopping;
    std::map<QString, Message> m_stopMessages;
    std::set<ModuleIndex> m_unstopped;  ///< those that the last stop of all modules did not see at rest
    bool m_guardianMissed = false;      ///< the message about it has been shown
};

}  // namespace nmc
