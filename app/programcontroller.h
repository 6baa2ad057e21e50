// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/machinecontroller.h"
#include "app/messagecontroller.h"
#include "app/pathcontroller.h"
#include "link/command/commander.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Points, sequences, paths and the homing of all axes: passes the window's requests on, and shows what comes
/// of them. GUI thread.
class ProgramController : public QObject {
    Q_OBJECT

public:
    ProgramController(MainWindow& window, const BusStore& store, MachineController& machine,
                      Commander& commander, MessageController& messages);

private:
    void showRun(const SequenceReport& report);

    MainWindow& m_window;
    MachineController& m_machine;
    SequenceController& m_sequences;
    MessageController& m_messages;
    PathController m_paths;
};

}  // namespace nmc
