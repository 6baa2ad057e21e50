// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSettings>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "app/portcontroller.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"

namespace nmc {

/// The connection to a port or to the simulator, as the user asks for it: opens and closes it, opens the next
/// one once the present one has closed, and searches again once nothing runs. Stores the chain found at each
/// port in the settings. GUI thread.
class Connection : public QObject {
    Q_OBJECT

public:
    Connection(QSettings& settings, BusStore& store, BusWorker& worker, Commander& commander,
               PortController& ports);

    /// Creates the transport that opens a port, in the bus thread.
    using Transports = std::function<BusWorker::TransportFactory(const ConnectTarget&)>;
    /// For tests, instead of the system's ports and the simulator.
    void setTransports(Transports transports) { m_transports = std::move(transports); }
    /// Allows control lines to inject faults into the simulator.
    void enableFaults(bool enable) { m_enableFaults = enable; }

    /// Closes the present connection first. If the port has another adapter than before, the user is asked.
    void open(const ConnectTarget& target);
    /// Opens the present connection again, or the last one.
    void reopen();
    /// The same, with commands allowed.
    void reopenFully();
    /// Opens the connection again whose adapter was unplugged last, whatever has been opened since.
    void reopenUnplugged();
    /// Opens the port of the adapter that is back.
    void openOffered();
    void close();
    /// Stops the motors and closes; ended() follows.
    void end();

    /// Searches for the chain again, once procedures and sequences have stopped their motors.
    void searchAgain();
    /// The user or a program has requested something else than the search that waits, which would stop it.
    void dropSearch() { m_searchWhenIdle = false; }
    /// Lends the line to the program that opens this path, if no procedure and no sequence is running. A path
    /// that begins with ~/, or with no /, is below the home folder.
    void lend(const QString& path);
    /// Makes the modules that are present the expected ones. Those that are missing are forgotten, as are the
    /// places of the machine beyond the chain, and the modules after them move up, unless a sequence uses
    /// one, or one that is now of another type.
    void acceptChain();

    /// Call for every event, after everything that must be over before the next connection is opened.
    void take(const StoreEvent& event);

signals:
    void opening(const nmc::ConnectTarget& target, bool simulated);
    void searching();
    /// The port that was lost is connected again.
    void recovered();
    /// These are present; the modules in `missing` are forgotten. If there are any before one that is
    /// present, no chain is connected until this returns.
    void accepted(const std::vector<nmc::ModuleIdentity>& present,
                  const std::vector<nmc::ModuleIndex>& missing);
    void reported(const nmc::Message& message);
    /// The same, of a message that ends with the connection.
    void reportedOfChain(const nmc::Message& message);
    void ended();

private:
    void openAnyway(const ConnectTarget& target);
    void followLostAdapter(const QString& port);
    void openNow(const ConnectTarget& target);
    /// The chain as it is from now on.
    struct Accepted {
        std::vector<bus::ModuleInfo> present{};
        std::vector<ModuleIndex> missing{};
    };
    void accept(const Accepted& chain);
    void searchIfIdle();
    void on(const bus::ChainFound& found);
    void on(const PortClosed& closed);
    void remember();

    QSettings& m_settings;
    BusStore& m_store;
    BusWorker& m_worker;
    Commander& m_commander;
    PortController& m_ports;
    Transports m_transports;
    std::optional<ConnectTarget> m_target;     ///< the present connection, or the last one
    std::optional<ConnectTarget> m_unplugged;  ///< the one whose adapter was unplugged last
    std::optional<ConnectTarget> m_openNext;   ///< opened when the present connection has closed
    std::map<QString, std::vector<bus::UnconfirmedStop>> m_unconfirmed;  ///< stops, by port
    std::vector<bus::ModuleInfo> m_chain;  ///< found last, with its present addresses
    /// Where the state of motors became unknown.
    struct LostLine {
        QString port;
        std::vector<bus::ModuleInfo> chain;
    };
    std::optional<LostLine> m_lost;
    std::optional<Accepted> m_accepted;  ///< with missing modules; takes effect when the port has closed
    bool m_endWhenClosed = false;
    bool m_searchWhenIdle = false;  ///< as soon as no procedure and no sequence is running
    bool m_enableFaults = false;
};

}  // namespace nmc
