// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connection.h"

#include <QDir>
#include <utility>

#include "app/knownchain.h"
#include "link/connection/networktransport.h"
#include "link/connection/serialtransport.h"
#include "link/connection/simulatortransport.h"
#include "model/intent/rights.h"
#include "model/module/chaindiagnosis.h"
#include "model/sequence/sequenceedit.h"
#include "protocol/baud.h"
#include "sim/chainspec.h"
#include "widgets/common/apitexts.h"
#include "widgets/common/texts.h"

namespace nmc {

namespace {

/// The chain after '=', or the default one.
auto simulatedChain(const QString& port) {
    const std::string chain = port.mid(kSimulatorPort.size() + 1).toStdString();
    return sim::parseChain(chain.empty() ? sim::kDefaultChain : std::string_view(chain));
}

/// A name of this form that does not specify a valid chain is not a port at all.
bool isSimulator(const QString& port) {
    return port == kSimulatorPort ||
           (port.startsWith(kSimulatorPort + QLatin1Char('=')) && simulatedChain(port).has_value());
}

}  // namespace

Connection::Connection(QSettings& settings, BusStore& store, BusWorker& worker, Commander& commander,
                       PortController& ports)
    : m_settings(settings), m_store(store), m_worker(worker), m_commander(commander), m_ports(ports) {
    connect(&commander.procedures(), &ProcedureController::idle, this, &Connection::searchIfIdle);
    connect(&commander.sequences(), &SequenceController::reported, this,
            [this](const SequenceReport& report) {
                if (report.over())
                    searchIfIdle();
            });
}

void Connection::open(const ConnectTarget& target) {
    if (m_ports.mayConnect(target))
        openAnyway(target);
}

void Connection::reopen() {
    if (m_target)
        open(*m_target);
}

void Connection::reopenFully() {
    if (m_target)
        open({m_target->port, m_target->baud, false});
}

void Connection::reopenUnplugged() {
    if (m_unplugged)
        open(*m_unplugged);
}

void Connection::openOffered() {
    if (const auto offer = m_ports.offered())
        openAnyway(*offer);
}

/// If the adapter that was lost is back at this port, its stops are owed there.
void Connection::followLostAdapter(const QString& port) {
    const auto before = m_ports.lostBefore(port);
    if (!before || *before == port)
        return;
    m_unconfirmed[port] = std::exchange(m_unconfirmed[*before], {});
    if (m_lost && m_lost->port == *before)
        m_lost->port = port;
}

void Connection::openAnyway(const ConnectTarget& target) {
    followLostAdapter(target.port);
    m_openNext = target;
    if (m_worker.isOpen()) {
        m_commander.endRuns();
        m_worker.close();  // PortClosed opens the next one
    } else
        openNow(*std::exchange(m_openNext, std::nullopt));
}

void Connection::openNow(const ConnectTarget& target) {
    m_target = target;
    const QString port = target.port;
    const bool simulated = isSimulator(port);
    bus::EngineConfig config;
    const auto network = parseNetworkLine(port.toStdString());
    // The rate of a raw line is set elsewhere, so the chain stays at the one that it has after power-up.
    const bool fixed = network && network->protocol == NetworkLine::Protocol::Raw;
    config.baud = fixed ? kPowerUpBaud : target.baud;
    config.readOnly = target.readOnly;
    if (m_lost && m_worker.stopWaits())  // opening ends the wait, whichever port is opened
        for (const bus::ModuleInfo& module : m_lost->chain)
            m_unconfirmed[m_lost->port].push_back({module, StopManner::Abruptly});
    config.unconfirmed = m_unconfirmed[port];
    BusWorker::TransportFactory factory;
    if (simulated) {
        config.adapterLatency = Duration::zero();
        sim::ChainOptions options;
        options.enableFaults = m_enableFaults;
        factory = [modules = simulatedChain(port).value(), options] {
            return std::make_unique<SimulatorTransport>(modules, options);
        };
    } else {
        config.adapterLatency = m_ports.adapterLatency(port);
        config.known = knownChain(m_settings, port);
        config.knownBaud = knownRate(m_settings, port);
        if (isNetworkName(port.toStdString()))
            factory = [line = network.value_or(NetworkLine{}), port = port.toStdString(),
                       baud = config.baud] { return std::make_unique<NetworkTransport>(line, port, baud); };
        else
            factory = [port, baud = target.baud] { return std::make_unique<SerialTransport>(port, baud); };
        m_ports.opening(target);
    }
    emit opening(target, simulated);
    m_store.begin(port, simulated, config.baud, target.readOnly);
    m_worker.open(m_transports ? m_transports(target) : std::move(factory), config);
    m_commander.opened();
}

void Connection::close() {
    m_openNext.reset();
    m_commander.endRuns();
    m_worker.close();
}

void Connection::end() {
    if (!m_worker.isOpen()) {
        emit ended();
        return;
    }
    m_endWhenClosed = true;
    close();
}

void Connection::searchAgain() {
    if (!m_worker.isOpen())
        return reopen();
    m_searchWhenIdle = m_commander.anyRunning();
    if (m_searchWhenIdle)
        m_commander.stopRuns();  // nothing is left running without supervision: the motors stop first
    else
        m_worker.connectAgain();
    emit searching();
}

void Connection::searchIfIdle() {
    if (m_searchWhenIdle)
        searchAgain();
}

void Connection::lend(const QString& path) {
    const QString below = path.startsWith(QStringLiteral("~/")) ? path.mid(2) : path;
    const std::string terminal = QDir::home().absoluteFilePath(below).toStdString();
    if (m_commander.anyRunning())
        emit reported(texts::notLent({LendingProblem::Kind::NotNow, terminal, {}}));
    else
        m_worker.lend(terminal);
}

void Connection::acceptChain() {
    const LinkState& link = m_store.link();
    if (whyNotEdited(link.rights) || link.modules.empty())
        return;  // the button shows why, and where nothing was found, there is nothing to work with
    // Where no chain is remembered, a module of the chain that is missing keeps its place.
    const bool remembered = link.phase == LinkPhase::Connected && !link.simulated;
    Accepted chain;
    for (const ModuleState& module : link.modules)
        if (remembered && isMissing(module))
            chain.missing.push_back(module.info.index);
        else
            chain.present.push_back(module.info);
    // The known chain is dropped only by reconnecting, and closing the connection stops motors.
    const bool reconnects = !chain.missing.empty();
    if (reconnects && !link.readOnly && m_store.movingMotors() > 0) {
        emit reported(texts::chainNotAccepted());
        return;
    }
    for (std::size_t i = link.modules.size(); i < m_store.machine().axes.size(); ++i)
        chain.missing.emplace_back(static_cast<std::uint8_t>(i));
    // A module of another type has other inputs and outputs under the same numbers.
    std::vector<ModuleIndex> unusable = chain.missing;
    for (const ModuleState& module : link.modules)
        if (module.otherType())
            unusable.push_back(module.info.index);
    const Program& program = m_store.machine().program;
    if (const auto user = userOfModules(program, unusable)) {
        const ModuleIndex used = *moduleOf(*rowAt(program, *user));
        const ModuleState* there = m_store.module(used);
        emit reportedOfChain(texts::moduleStillUsed(*user, used, there != nullptr && there->otherType()));
        return;
    }
    if (reconnects) {
        m_accepted = std::move(chain);
        return openAnyway(*m_target);
    }
    accept(chain);
    if (remembered)
        rememberChain(m_settings, m_target->port, chain.present);
}

void Connection::accept(const Accepted& chain) {
    std::vector<ModuleIdentity> identities;
    for (const bus::ModuleInfo& module : chain.present)
        identities.push_back(module.identity);
    emit accepted(identities, chain.missing);
}

void Connection::take(const StoreEvent& event) {
    if (const auto* found = std::get_if<bus::ChainFound>(&event))
        on(*found);
    else if (const auto* closed = std::get_if<PortClosed>(&event))
        on(*closed);
    else if (std::holds_alternative<bus::LinkLost>(event))
        m_lost = {m_target->port, m_chain};
    else if (std::holds_alternative<bus::AddressChanged>(event) && !m_store.link().lent)
        remember();
    else if (const auto* changed = std::get_if<bus::RateChanged>(&event);
             changed != nullptr && !m_store.link().simulated)
        rememberRate(m_settings, m_target->port, changed->baud);
}

/// Known modules that are missing are reported separately, as silent.
void Connection::on(const bus::ChainFound& found) {
    if (m_lost && m_lost->port == m_target->port) {
        if (!found.readOnly)  // otherwise, the stops that are owed still wait
            m_lost.reset();
        emit recovered();
    }
    m_chain = found.modules;
    const int modules = static_cast<int>(found.modules.size());
    // The machine's own list takes precedence over what was seen at this port.
    const auto ofMachine = static_cast<int>(expectedModules(m_store.machine()));
    const auto known = static_cast<int>(knownChain(m_settings, m_target->port).size());
    const int expected = ofMachine > 0 ? ofMachine : known;
    if (modules < expected) {
        const ModuleIndex last(static_cast<std::uint8_t>(modules - 1));
        emit reported(texts::fewerThanExpected(modules, expected,
                                               QString::fromStdString(m_store.machine().axis(last).name)));
    } else if (found.absent.empty() && !found.unaddressed && !m_store.link().simulated) {
        rememberChain(m_settings, m_target->port, found.modules);
    }
}

void Connection::on(const PortClosed& closed) {
    m_searchWhenIdle = false;
    m_unconfirmed[m_target->port] = closed.unconfirmed;
    if (closed.error && closed.error->problem == PortProblem::Gone) {
        m_lost = {m_target->port, m_chain};
        m_unplugged = m_target;
    }
    m_ports.closed(closed.error);
    // Only now: while the modules have their former numbers, none must get the settings of another.
    if (const auto chain = std::exchange(m_accepted, std::nullopt)) {
        rememberChain(m_settings, m_target->port, chain->present);
        accept(*chain);
    }
    if (m_endWhenClosed)
        emit ended();
    else if (m_openNext)
        openNow(*std::exchange(m_openNext, std::nullopt));
}

/// Stores the changed addresses, so that the chain can be found again.
void Connection::remember() {
    m_chain.clear();
    for (const ModuleState& module : m_store.link().modules)
        m_chain.push_back(module.info);
    if (!m_store.link().simulated)
        rememberChain(m_settings, m_target->port, m_chain);
}

}  // namespace nmc
