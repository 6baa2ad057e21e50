// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <optional>

#include "link/command/procedurecontroller.h"
#include "link/connection/busstore.h"
#include "model/response/responsefile.h"
#include "widgets/mainwindow/mainwindow.h"

namespace nmc {

/// Passes to the window what tests of a position loop measure, cut from the history: step responses, the
/// edges of a square wave, frequency responses. GUI thread.
class LoopTestController : public QObject {
    Q_OBJECT

public:
    LoopTestController(MainWindow& window, const BusStore& store, const ProcedureController& procedures);

private:
    void take(const ProcedureReport& report);
    /// Passes the run to the window when it is over.
    void followSteps(const ProcedureReport& report);
    /// Passes each edge to the window when the next one begins.
    void followSquareWave(const ProcedureReport& report);
    [[nodiscard]] std::optional<KeptResponse> recordOf(const ModuleState& module,
                                                       const ResponseTaken& taken) const;

    MainWindow& m_window;
    const BusStore& m_store;
    std::map<ModuleIndex, ResponseTaken> m_steps;  ///< the last one of each module that was stored
    std::map<ModuleIndex, ResponseTaken> m_edges;  ///< the last one of each running square wave
};

}  // namespace nmc
