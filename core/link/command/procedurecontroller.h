// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "link/connection/busstore.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Runs procedures, at most one with each module: asks them what is next whenever there is news, and 20 times
/// a second. A stop never waits for one: whatever has stopped the motor is told to it afterwards, and all
/// that it may still send then is that the chip need not look for home any more, or that the motor is off.
/// GUI thread.
class ProcedureController : public QObject {
    Q_OBJECT

public:
    /// Submits one operation.
    using Submit = std::function<bus::OperationId(Procedure::Send)>;

    ProcedureController(BusStore& store, Submit submit, QObject* parent = nullptr);

    /// False while one runs with that module already.
    [[nodiscard]] bool begin(std::unique_ptr<Procedure> procedure);
    [[nodiscard]] bool running(ModuleIndex module) const { return m_runs.count(module) != 0; }
    [[nodiscard]] bool anyRunning() const { return !m_runs.empty(); }

    /// The user wants something else of the module, or nothing: its procedure stops the motor, and ends.
    void cancel(ModuleIndex module);
    void cancelAll();
    /// What is being tried with it is to stay: the bus is asked for that now.
    void keep(ModuleIndex module);
    /// Other gains for the procedure that runs with it. False: it has no use for them.
    [[nodiscard]] bool take(ModuleIndex module, const servo::SetGain& gains);
    /// The motor has been stopped or switched off by somebody else.
    void overtake(ModuleIndex module);
    /// A stop of all motors begins; until stopFinished() nothing is sent.
    void stopAll();
    /// The connection is over, or another has begun.
    void forget();
    /// Sorts the news out; false for the end of an operation that is none of ours.
    bool take(const StoreEvent& event);

signals:
    /// The last one that ran is over, and its motor told what it leaves behind.
    void idle();
    void reported(const nmc::ProcedureReport& report);

private:
    struct Run {
        std::unique_ptr<Procedure> procedure;
        std::optional<bus::OperationId> operation;
        std::optional<ProcedureReport> reported;
        bool overtaken = false;
    };

    void look();
    void advance();
    void ask(Run& run, const ModuleState& module, TimePoint now, bool& over);
    void publish(Run& run);
    void end(Run& run);
    void suspect(std::optional<ModuleIndex> module);
    bool finished(const bus::OperationFinished& finished);
    void overtakeAll();

    BusStore& m_store;
    Submit m_submit;
    QTimer m_timer;
    std::map<ModuleIndex, Run> m_runs;
    bool m_stopping = false;
};

}  // namespace nmc
