// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "link/command/procedurecontroller.h"
#include "link/command/sequencecontroller.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "model/intent/intent.h"

namespace nmc {

/// Carries out what is asked of modules and groups: as one operation, as a procedure, or as a command to a
/// group. Whatever ran with the module before gives way, and a stop waits for none of it. It also keeps the
/// bus informed of what follows from the machine: limits of travel, limit stops that are due, and the module
/// that a test wants to see closely. GUI thread.
class Commander : public QObject {
    Q_OBJECT

public:
    Commander(BusStore& store, BusWorker& worker, QObject* parent = nullptr);

    [[nodiscard]] ProcedureController& procedures() { return m_procedures; }
    [[nodiscard]] SequenceController& sequences() { return m_sequences; }
    [[nodiscard]] bool anyRunning() const { return m_procedures.anyRunning() || m_sequences.running(); }

    /// sent() or refused() follows, unless it needs no command.
    void carryOut(ModuleIndex module, const Intent& intent);
    /// Towards a limit of travel it is a move there. False: it is not possible now, and nothing was sent.
    [[nodiscard]] bool hold(const bus::HoldToMove& wanted);
    void command(const bus::GroupCommand& command);
    void change(const bus::GroupChange& change);
    /// Procedures and sequences stop their motors, and end.
    void stopRuns();
    /// They end before a stop of all motors, or before an end of the connection that stops them.
    void endRuns();

    /// Every event is to come here first. True: the operation that ended belongs to a procedure or a
    /// sequence, which reports the outcome.
    [[nodiscard]] bool take(const StoreEvent& event);

signals:
    /// The precondition that is not met.
    void refused(nmc::ModuleIndex module, nmc::Refusal refusal, const nmc::Intent& intent);
    void sent(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// What may set these in motion is about to be sent. The operation's end, or the group's, follows.
    void aboutToMove(nmc::bus::OperationId id, const std::vector<nmc::ModuleIndex>& modules);
    void aboutToHold(nmc::ModuleIndex module);

private:
    bus::OperationId submit(bus::Operation operation);
    bus::OperationId nextId() { return bus::OperationId(++m_lastOperation); }
    void look();
    void sendTravelLimits();
    void keepArmed(const ModuleState& module);
    [[nodiscard]] std::vector<ModuleIndex> membersOf(std::uint8_t group) const;
    void noteTest(const ProcedureReport& report);
    void shareBus();

    BusStore& m_store;
    BusWorker& m_worker;
    ProcedureController m_procedures;
    SequenceController m_sequences;
    std::uint32_t m_lastOperation = 0;
    std::vector<bus::TravelLimits> m_travelLimits;  ///< as sent last; empty: the bus may have others
    std::map<ModuleIndex, TimePoint> m_armedAt;     ///< when a limit stop was sent last
    std::set<ModuleIndex> m_tested;                 ///< by procedures that run (isTest)
    QTimer m_focusTimer;                            ///< the bus takes back a focus that nobody renews
};

}  // namespace nmc
