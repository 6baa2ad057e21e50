// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "link/connection/busstore.h"
#include "model/procedure/procedure.h"

namespace nmc {

/// Runs procedures, at most one per module: requests their next step whenever there is an event, and 20 times
/// a second. A stop never waits for a procedure: after something else has stopped the motor, the procedure is
/// informed, and may then only cancel the chip's home search or switch the motor off. GUI thread.
class ProcedureController : public QObject {
    Q_OBJECT

public:
    /// Submits one operation.
    using Submit = std::function<bus::OperationId(Procedure::Send)>;

    ProcedureController(BusStore& store, Submit submit, QObject* parent = nullptr);

    /// Returns false while a procedure is already running with the module, unless it is a trial of gains that
    /// ends.
    [[nodiscard]] bool begin(std::unique_ptr<Procedure> procedure);
    [[nodiscard]] bool running(ModuleIndex module) const { return m_runs.count(module) != 0; }
    /// The gains that a trial on the module goes back to; empty if there is none.
    [[nodiscard]] std::optional<servo::SetGain> gainsBefore(ModuleIndex module) const;
    [[nodiscard]] bool anyRunning() const { return !m_runs.empty(); }
    /// The procedure running with the module ends once its operation in flight is over, and then stops the
    /// motor.
    [[nodiscard]] bool stopsLater(ModuleIndex module) const;

    /// The user requests something else of the module, or nothing: its procedure stops the motor and ends.
    void cancel(ModuleIndex module);
    void cancelAll();
    /// Keeps what is being tried on the module; the bus has been asked to keep it.
    void keep(ModuleIndex module);
    /// Passes new gains to the procedure running with the module. Returns false if it does not use them.
    [[nodiscard]] bool take(ModuleIndex module, const servo::SetGain& gains);
    /// The motor has been stopped or switched off by something else.
    void overtake(ModuleIndex module);
    /// A stop of all motors begins; nothing is sent until StopFinished.
    void stopAll();
    /// The connection has ended, or another one has begun.
    void forget();
    /// Handles an event. Returns false for the end of an operation that is not ours.
    bool take(const StoreEvent& event);

signals:
    /// The last running procedure has ended, and its final commands have been sent.
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
    void replace(Run& run, std::optional<bus::OperationId> next);
    void publish(Run& run);
    void report(Run& run, const ProcedureReport& report);
    void emitReports();
    void end(Run& run);
    void suspect(std::optional<ModuleIndex> module);
    bool finished(const bus::OperationFinished& finished);
    void overtakeAll();

    BusStore& m_store;
    Submit m_submit;
    QTimer m_timer;
    std::map<ModuleIndex, Run> m_runs;
    std::vector<bus::OperationId> m_replaced;  ///< in flight, by the last steps of their procedures
    std::deque<ProcedureReport> m_reports;     ///< not emitted yet
    bool m_stopping = false;
};

}  // namespace nmc
