// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <variant>
#include <vector>

#include "base/overloaded.h"
#include "link/connection/busworker.h"
#include "model/module/linkstate.h"
#include "model/scope/history.h"
#include "model/scope/scopefeed.h"

namespace nmc {

/// Events that the user should hear about and the state does not show.
using StoreEvent =
    Join<bus::NewsEvent, std::variant<PortClosed, SimulatorAnswered, PanelFroze, ComputerSlept,
                                      GuardianStopped, GuardianMissing, LineLent, LendingProblem>>;

/// The GUI thread's copy of the connection: drains the worker's events at most 60 times a second and turns
/// them into module states and histories. Everything else in the GUI reads them from here.
class BusStore : public QObject {
    Q_OBJECT

public:
    explicit BusStore(BusWorker& worker, QObject* parent = nullptr);

    /// Called when a connection is being opened.
    void begin(const QString& port, bool simulated, std::uint32_t baud, bool readOnly = false);

    [[nodiscard]] const LinkState& link() const { return m_link; }
    [[nodiscard]] const ModuleState* module(ModuleIndex index) const;
    /// The samples of this connection's modules, or of the last connection's: they are kept until a different
    /// chain is found.
    [[nodiscard]] const History& history() const { return m_history; }
    [[nodiscard]] int movingMotors() const { return static_cast<int>(movingModules(m_link).size()); }

    /// Notes the operation whose end is awaited; OperationFinished clears it.
    void noteAsked(ModuleIndex module, bus::OperationId operation);
    /// Notes that a search has found home at `counts`; it is shown with the next update.
    void noteHome(ModuleIndex module, std::int32_t counts);
    /// Notes the argument of Engine::focus(); valid until the next call.
    void noteFocus(std::optional<ModuleIndex> module);
    /// Records the user's statement that a position is right, or in doubt.
    void declarePosition(ModuleIndex module, bool right);
    /// Sets the user's machine.
    void setMachine(const Machine& machine);
    /// That machine, as usable() for the modules of the chain.
    [[nodiscard]] const Machine& machine() const { return m_machine; }
    /// Offers the home position that follows from remembered data, if those are still true.
    void offerHome(ModuleIndex module, std::int32_t counts);
    /// Called when the user accepts, or declines, the offered home.
    void takeHome(ModuleIndex module);
    void dropHome(ModuleIndex module);
    /// Displayed positions count from there, or by the counter; see HomeFact::useWork().
    void useWorkOffset(ModuleIndex module, const std::optional<WorkOffset>& offset,
                       const std::optional<std::int32_t>& home);
    /// Called when the panel is locked for an operator, or unlocked (nothing).
    void setRights(const std::optional<OperatorRights>& rights);

    /// Computes rates since the last call from the worker's counters, for the status bar's update once a
    /// second.
    [[nodiscard]] LinkFigures pullFigures(TimePoint now);

    /// Processes the worker's events; normally called by the store's own timer.
    void drain();

signals:
    void linkChanged();
    /// Reports events for the user in bus order; linkChanged() follows.
    void happened(const nmc::StoreEvent& event);

private:
    struct Record {
        ScopeFeed feed;
        /// Everything was stopped since the last answered command: it is unknown what else was executed.
        bool open = false;
        std::uint64_t samples = 0;
        std::uint64_t samplesPulled = 0;  ///< value at the last pullFigures()
    };

    /// Applies the function to the state of a module, if the chain has it, and reports the change.
    template <typename Function>
    void change(ModuleIndex module, Function function);
    void take(const WorkerEvent& event);
    void take(const bus::Event& event);
    void take(const bus::Sample& sample);
    /// Marks the gains as unknown: the module may have other gains than those it confirmed.
    void doubtGains(ModuleIndex module);
    void executed(const bus::CommandExecuted& command);
    /// These overloads update the state from an event before it is reported.
    void note(const bus::ChainFound& chain);
    void note(const bus::ModulesSeen& seen);
    void note(const bus::CommandUnanswered& command);
    void note(const LineLent& lent);
    void note(const AnyOf<SimulatorAnswered, PanelFroze, ComputerSlept, GuardianStopped, GuardianMissing,
                          LendingProblem> auto&) {}
    void note(const bus::ModuleUnresponsive& silence);
    void note(const bus::OperationFinished& finished);
    void note(const bus::HealthChanged& changed);
    void note(const bus::ModuleRestarted& restarted);
    void note(const bus::Readdressed& readdressed);
    void note(const bus::AddressChanged& changed) {
        if (known(changed.module))
            m_link.modules[changed.module.value()].info.address = changed.address;
    }
    void note(const bus::RateChanged& changed) { m_link.baud = changed.baud; }
    void note(const AnyOf<bus::ConnectFailed, bus::LinkLost> auto&) { lost(false); }
    void note(const bus::StopFinished& stopped);
    void note(const bus::OwedStopConfirmed& confirmed);
    void note(const bus::ForeignMotion& motion);
    void note(const bus::GroupFinished& finished);
    void note(const bus::ForeignTraffic& traffic);
    void note(const AnyOf<bus::CommandRefused, bus::HoldExpired, bus::MotionSuspect, bus::StoppedBeforeLimit,
                          bus::RateChangeFailed, bus::ReaddressFailed, bus::EchoNoticed> auto&) {}
    /// It is unknown whether the module has carried out this command.
    void doubtCommand(ModuleIndex module, CommandCode command);
    /// The same for a command that sets outputs of a PIC-I/O.
    void doubtOutputs(ModuleIndex module, CommandCode command);
    void setModules(const bus::ChainFound& chain);
    /// `quiet`: LinkState::quiet.
    void lost(bool quiet);
    /// The machine applies to the modules as they are now.
    void useMachine();
    /// It is unknown whether these modules received the last commands; from here on, only their positions
    /// show whether they move.
    void doubtMotions(const std::vector<ModuleIndex>& modules);
    void closed(const PortClosed& closed);
    void pullRates(double seconds);
    void forgetChain();
    void beginHistory(const bus::ChainFound& chain);
    [[nodiscard]] bool known(ModuleIndex index) const { return index.value() < m_link.modules.size(); }

    BusWorker& m_worker;
    QTimer m_drainTimer;
    LinkState m_link;
    Machine m_usersMachine;
    Machine m_machine;
    std::vector<Record> m_records;
    History m_history;
    /// The port and the chain that the history belongs to.
    std::string m_historyPort;
    std::vector<ModuleIdentity> m_historyOf;
    bus::LinkStatistics m_lastStatistics;
    TimePoint m_lastPull;
};

}  // namespace nmc
