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

/// What the user should hear of, and the state does not tell; samples and progress are state, not news.
using StoreEvent =
    std::variant<bus::ChainFound, bus::ConnectFailed, bus::OperationFinished, bus::StopFinished,
                 bus::ModuleUnresponsive, bus::CommandRefused, bus::LinkLost, bus::HoldExpired,
                 bus::HealthChanged, bus::ModuleRestarted, bus::MotionSuspect, bus::StoppedBeforeLimit,
                 bus::GroupFinished, bus::RateChanged, bus::RateChangeFailed, bus::OwedStopConfirmed,
                 bus::Readdressed, bus::ReaddressFailed, bus::EchoNoticed, bus::ForeignTraffic,
                 bus::ForeignMotion, bus::AddressChanged, PortClosed, SimulatorAnswered, PanelFroze,
                 ComputerSlept, GuardianStopped, GuardianMissing>;

/// The GUI thread's copy of the connection: drains the worker's events at most 60 times a second and turns
/// them into module states and histories. Everything else in the GUI reads it here.
class BusStore : public QObject {
    Q_OBJECT

public:
    explicit BusStore(BusWorker& worker, QObject* parent = nullptr);

    /// A connection is being opened.
    void begin(const QString& port, bool simulated, std::uint32_t baud, bool readOnly = false);

    [[nodiscard]] const LinkState& link() const { return m_link; }
    [[nodiscard]] const ModuleState* module(ModuleIndex index) const;
    /// What the modules of this connection said, or of the last one: it stays until another chain is found.
    [[nodiscard]] const History& history() const { return m_history; }
    [[nodiscard]] int movingMotors() const { return static_cast<int>(movingModules().size()); }
    [[nodiscard]] std::vector<ModuleIndex> movingModules() const;

    /// Its end comes as OperationFinished.
    void noteAsked(ModuleIndex module, bus::OperationId operation);
    /// A search has found home there; shown with the next news.
    void noteHome(ModuleIndex module, std::int32_t counts);
    /// As Engine::focus(), until the next call.
    void noteFocus(std::optional<ModuleIndex> module);
    /// The user's word on a position: right, or in doubt.
    void declarePosition(ModuleIndex module, bool right);
    /// How its axes may move, as the user has set it.
    void setMachine(const Machine& machine);
    /// Where its home is if what was remembered is true.
    void offerHome(ModuleIndex module, std::int32_t counts);
    /// The user has taken that, or does not want it.
    void takeHome(ModuleIndex module);
    void dropHome(ModuleIndex module);
    /// The panel is locked for an operator, or not any more.
    void setRights(const std::optional<OperatorRights>& rights);

    /// Rates since the last call, from the worker's counters; for the status bar's 1 Hz pull.
    [[nodiscard]] LinkFigures pullFigures(TimePoint now);

    /// Takes over what the worker has; usually called by the store's own timer.
    void drain();

signals:
    void linkChanged();
    /// News for the user, in the order of the bus; linkChanged() follows.
    void happened(const nmc::StoreEvent& event);

private:
    struct Record {
        ScopeFeed feed;
        /// Since the last command that was answered an operation was cancelled, or all was stopped: what else
        /// was carried out is not known.
        bool open = false;
        std::uint64_t samples = 0;
        std::uint64_t samplesPulled = 0;  ///< when the figures were pulled last
    };

    void take(const WorkerEvent& event);
    void take(const bus::Event& event);
    void take(const bus::Sample& sample);
    void noteGains(const bus::CommandExecuted& executed);
    /// It may have other gains than those that it confirmed.
    void doubtGains(ModuleIndex module);
    void executed(const bus::CommandExecuted& command);
    /// What news change here, before they are told.
    void note(const bus::ChainFound& chain);
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
    void note(const AnyOf<bus::ConnectFailed, bus::LinkLost> auto&) { m_link.phase = LinkPhase::Lost; }
    void note(const bus::StopFinished& stopped);
    void note(const bus::OwedStopConfirmed& confirmed);
    void note(const bus::ForeignMotion& motion);
    void note(const bus::GroupFinished& finished);
    void note(const bus::ForeignTraffic& traffic);
    void note(const AnyOf<bus::CommandRefused, bus::HoldExpired, bus::MotionSuspect, bus::StoppedBeforeLimit,
                          bus::RateChangeFailed, bus::ReaddressFailed, bus::EchoNoticed> auto&) {}
    /// What these were told has not been heard of: what moves them is for their positions to say.
    void doubtMotions(const std::vector<ModuleIndex>& modules);
    void closed(const PortClosed& closed);
    void pullRates(double seconds);
    void forgetChain();
    void beginHistory(const bus::ChainFound& chain);
    [[nodiscard]] bool known(ModuleIndex index) const { return index.value() < m_link.modules.size(); }

    BusWorker& m_worker;
    QTimer m_drainTimer;
    LinkState m_link;
    Machine m_machine;
    std::vector<Record> m_records;
    History m_history;
    /// Whose history it is.
    std::string m_historyPort;
    std::vector<ModuleIdentity> m_historyOf;
    bus::LinkStatistics m_lastStatistics;
    TimePoint m_lastPull;
};

}  // namespace nmc
