// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "bus/engineconfig.h"
#include "link/command/procedurecontroller.h"
#include "link/command/sequencecontroller.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "model/intent/intent.h"

namespace nmc {

/// Carries out requests to modules and groups: as an operation, as a procedure, or as a command to a group.
/// Whatever was running with the module before is ended, and a stop does not wait for any of it. The class
/// also keeps the bus informed of what follows from the machine: travel limits, limit stops that are due, the
/// outputs that a stop of all modules takes low, and the module that a test needs polled fast. GUI thread.
class Commander : public QObject {
    Q_OBJECT

public:
    Commander(BusStore& store, BusWorker& worker, QObject* parent = nullptr);

    [[nodiscard]] ProcedureController& procedures() { return m_procedures; }
    [[nodiscard]] SequenceController& sequences() { return m_sequences; }
    [[nodiscard]] bool anyRunning() const { return m_procedures.anyRunning() || m_sequences.running(); }

    /// Emits sent() or refused(), unless the intent needs no command. Returns the operation, if it is one.
    std::optional<bus::OperationId> carryOut(ModuleIndex module, const Intent& intent);
    /// Stops the motor smoothly, even if its module is believed silent. Returns false if nothing is on that
    /// could be stopped; emits nothing.
    [[nodiscard]] bool stop(ModuleIndex module);
    /// Towards a travel limit, the held motion becomes a move to it. Returns false if it is not possible now;
    /// nothing is sent then.
    [[nodiscard]] bool hold(const bus::HoldToMove& wanted);
    void command(const bus::GroupCommand& command);
    void change(const bus::GroupChange& change);
    /// Modules known to be in the group, and those whose group is unknown.
    [[nodiscard]] std::vector<ModuleIndex> membersOf(std::uint8_t group) const;
    /// Ends procedures and sequences, which stop their motors.
    void stopRuns();
    /// Ends procedures and sequences before a stop of all motors, or before closing a connection, which stops
    /// them.
    void endRuns();

    /// Must be called as soon as a connection is being opened, whose bus thread does not know any stop
    /// outputs yet: it may send a stop before this thread hears of the chain.
    void opened();
    /// Must be called first for every event. Returns true if the operation that ended belongs to a procedure
    /// or a sequence, which reports the outcome, or is a stop that stoppedBeyondTravel() has reported.
    [[nodiscard]] bool take(const StoreEvent& event);

signals:
    /// A precondition of the intent is not met.
    void refused(nmc::ModuleIndex module, nmc::Refusal refusal, const nmc::Intent& intent);
    void sent(nmc::ModuleIndex module, const nmc::Intent& intent);
    /// A command that may set these modules in motion is about to be sent. The end of the operation or of the
    /// group command follows.
    void aboutToMove(nmc::bus::OperationId id, const std::vector<nmc::ModuleIndex>& modules);
    void aboutToHold(nmc::ModuleIndex module);
    /// A move has been sent a stop, because its goal is beyond a travel limit that was set nearer.
    void stoppedBeyondTravel(nmc::ModuleIndex module);

private:
    bus::OperationId submit(bus::Operation operation);
    /// Empty if nothing is on that could be stopped.
    [[nodiscard]] std::optional<bus::OperationId> sendStop(ModuleIndex module);
    bus::OperationId nextId() { return bus::OperationId(++m_lastOperation); }
    void look();
    void sendTravelLimits();
    void stopBeyondTravel();
    void sendStopOutputs();
    void keepArmed(const ModuleState& module);
    void noteTest(const ProcedureReport& report);
    void shareBus();

    BusStore& m_store;
    BusWorker& m_worker;
    ProcedureController m_procedures;
    SequenceController m_sequences;
    std::uint32_t m_lastOperation = 0;
    std::vector<bus::TravelLimits> m_travelLimits;  ///< as last sent; empty: the bus may have other limits
    std::vector<bus::TravelLimits> m_goalsWithin;   ///< those by which the goals were last judged
    std::vector<bus::OperationId> m_travelStops;    ///< those of stopBeyondTravel() under way
    std::optional<std::pair<ModuleIndex, TimePoint>> m_held;  ///< the last call of hold(), and its time
    std::vector<bus::StopOutputs> m_stopOutputs;  ///< as last sent; empty: the bus may have others
    std::map<ModuleIndex, TimePoint> m_armedAt;   ///< when a limit stop was last sent
    std::set<ModuleIndex> m_tested;               ///< by running procedures (isTest)
    QTimer m_focusTimer;                          ///< renews the focus, which the bus otherwise withdraws
};

}  // namespace nmc
