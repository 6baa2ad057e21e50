// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/connection.h"
#include "app/flightcontroller.h"
#include "app/machinecontroller.h"
#include "app/messagecontroller.h"
#include "app/motionkeeper.h"
#include "app/portcontroller.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Carries out what the buttons of messages request, except for what the window does itself. GUI thread.
class MessageActions : public QObject {
    Q_OBJECT

public:
    MessageActions(MainWindow& window, BusStore& store, BusWorker& worker, Connection& connection,
                   PortController& ports, MachineController& machine, MotionKeeper& motions,
                   FlightController& flight, MessageController& messages);

signals:
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);

private:
    void act(const Message& message, MessageAction action);
    void lookFirst(const QString& key);
    void takePosition(ModuleIndex module);

    MainWindow& m_window;
    BusStore& m_store;
    BusWorker& m_worker;
    Connection& m_connection;
    PortController& m_ports;
    MachineController& m_machine;
    MotionKeeper& m_motions;
    FlightController& m_flight;
    MessageController& m_messages;
};

}  // namespace nmc
