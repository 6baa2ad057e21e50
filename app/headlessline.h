// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <set>

#include "app/apicontroller.h"
#include "app/connection.h"
#include "app/portcontroller.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "link/connection/processguard.h"
#include "link/connection/sleepinhibitor.h"
#include "model/settings/machine.h"

namespace nmc {

/// A connection to a port or to the simulator without a window, at which programs are let in and one of them
/// may move motors without being asked: there is nobody to ask. What the window would do for safety is here
/// as well: travel limits, the stop of everything at the end and before the computer sleeps, and the
/// guardian. GUI thread.
class HeadlessLine : public QObject {
    Q_OBJECT

public:
    /// `machine`: names, units and travel limits; nothing of it is sent to the modules.
    HeadlessLine(QSettings& settings, const Machine& machine);

    void open(const ConnectTarget& target);
    /// Stops the motors and closes; ended() follows.
    void end() { m_connection.end(); }

    /// Where programs are let in.
    [[nodiscard]] QString socket() const { return m_api.socket(); }
    [[nodiscard]] BusWorker& worker() { return m_worker; }

signals:
    /// The chain has been found, and every module of it that answers has reported.
    void connected();
    /// It could not be connected, or is no longer, although it was not ended from here; the cause has been
    /// reported.
    void lost();
    void ended();
    /// What the window would show.
    void reported(const nmc::Message& message);

private:
    void take(const StoreEvent& event);
    void reportStanding();
    void announce();

    ProcessGuard m_guardian;
    BusWorker m_worker;
    BusStore m_store{m_worker};
    Commander m_commander{m_store, m_worker};
    SleepInhibitor m_sleep;
    PortController m_ports{PortController::Places()};
    Connection m_connection;
    ApiController m_api{m_store, m_worker, m_connection, m_commander};
    bool m_found = false;          ///< connected() is due
    std::set<QString> m_standing;  ///< keys of the conditions that have been reported
};

}  // namespace nmc
