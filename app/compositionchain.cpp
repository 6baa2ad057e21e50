// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to the chain as a whole, and what is remembered about it.
#include "app/composition.h"
#include "app/knownchain.h"
#include "model/module/chaindiagnosis.h"
#include "widgets/common/requests.h"
#include "widgets/common/texts.h"

namespace nmc {

void Composition::wireChain() {
    const Requests* requests = &m_window.requests();
    connect(requests, &Requests::scan, this, &Composition::scanAgain);
    connect(requests, &Requests::acceptChain, this, &Composition::acceptChain);
    connect(requests, &Requests::rate, &m_worker, &BusWorker::changeRate);
    connect(requests, &Requests::address, &m_worker, &BusWorker::changeAddress);
    const auto changeGroup = [this](const bus::GroupChange& change) {
        m_commander.change(change);
        m_machine.noteGroup(change);
    };
    connect(requests, &Requests::groupChange, this, changeGroup);
    connect(requests, &Requests::groupNamed, &m_machine, &MachineController::nameGroup);
    connect(&m_machine, &MachineController::groupChangeRequested, this, changeGroup);
    connect(requests, &Requests::groupCommand, &m_commander, &Commander::command);
}

void Composition::scanAgain() {
    if (m_worker.isOpen()) {
        m_scanWhenIdle = m_commander.anyRunning();
        if (m_scanWhenIdle) {
            // Nothing is left running without supervision: the motors stop first.
            m_commander.stopRuns();
        } else
            m_worker.connectAgain();
    } else if (m_target) {
        connectTo(*m_target);
    }
    m_messages.end(texts::key::port());
}

/// Known modules that are missing are reported separately, as silent.
void Composition::noteChain(const bus::ChainFound& found) {
    const int modules = static_cast<int>(found.modules.size());
    // The machine's own list takes precedence over what was seen at this port.
    const auto told = static_cast<int>(expectedModules(m_machine.machine()));
    const auto known = static_cast<int>(knownChain(m_settings, m_target->port).size());
    const int expected = told > 0 ? told : known;
    if (modules < expected) {
        const std::string last =
            m_machine.machine().axis(ModuleIndex(static_cast<std::uint8_t>(modules - 1))).name;
        m_messages.report(texts::fewerThanExpected(modules, expected, QString::fromStdString(last)));
    } else if (found.absent.empty() && !found.unaddressed && !m_store.link().simulated) {
        rememberChain(m_settings, m_target->port, found.modules);
    }
}

void Composition::noteAddresses() {
    const LinkState& link = m_store.link();
    if (link.simulated)
        return;
    std::vector<bus::ModuleInfo> chain;
    for (const ModuleState& module : link.modules)
        chain.push_back(module.info);
    rememberChain(m_settings, m_target->port, chain);
}

void Composition::acceptChain() {
    const LinkState& link = m_store.link();
    std::vector<bus::ModuleInfo> there;
    std::vector<ModuleIdentity> expected;
    for (const ModuleState& module : link.modules)
        if (!isMissing(module)) {
            there.push_back(module.info);
            expected.push_back(module.info.identity);
        }
    const bool forgets = there.size() < link.modules.size() && !link.simulated;
    // The known chain is dropped only by reconnecting, and closing the connection stops motors.
    if (forgets && !link.readOnly && m_store.movingMotors() > 0)
        return m_messages.report(texts::chainNotAccepted());
    m_machine.acceptChain(expected);
    m_messages.end(texts::key::port());
    for (const ModuleState& module : link.modules)
        if (isMissing(module))
            m_messages.end(texts::key::silent(module.info.index));
    if (link.phase != LinkPhase::Connected || link.simulated)
        return;
    rememberChain(m_settings, m_target->port, there);
    if (forgets)
        connectTo(*m_target);
}

}  // namespace nmc
