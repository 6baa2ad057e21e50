// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headlessline.h"

#include <algorithm>

#include "app/guardianplace.h"
#include "app/news.h"
#include "link/clock.h"
#include "widgets/common/texts.h"

namespace nmc {

HeadlessLine::HeadlessLine(QSettings& settings, const Machine& machine)
    : m_guardian(guardianPlace(settings)), m_connection(settings, m_store, m_worker, m_commander, m_ports) {
    m_worker.addGuard(m_guardian);
    m_store.setMachine(machine);
    connect(&m_store, &BusStore::happened, this, &HeadlessLine::take);
    connect(&m_store, &BusStore::linkChanged, this, &HeadlessLine::reportStanding);
    connect(&m_store, &BusStore::linkChanged, this, &HeadlessLine::announce);
    m_sleep.follow(m_store);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_worker, &BusWorker::stopAll);
    connect(&m_sleep, &SleepInhibitor::stopWanted, &m_commander, &Commander::endRuns);
    connect(&m_connection, &Connection::ended, this, &HeadlessLine::ended);
    connect(&m_connection, &Connection::reported, this, &HeadlessLine::reported);
    connect(&m_ports, &PortController::reported, this, &HeadlessLine::reported);
    connect(&m_api, &ApiController::reported, this, &HeadlessLine::reported);
    connect(this, &HeadlessLine::reported, &m_api, &ApiController::publish);
    m_api.grantUnasked();
}

void HeadlessLine::open(const ConnectTarget& target) {
    m_connection.open(target);
    m_api.letIn(true);
}

void HeadlessLine::take(const StoreEvent& event) {
    if (m_commander.take(event))
        return;
    for (const News& news : newsOf(event, m_store.link()))
        emit reported(news.message);
    m_connection.take(event);
    const auto* closed = std::get_if<PortClosed>(&event);
    if (std::holds_alternative<bus::ChainFound>(event)) {
        m_found = true;
        announce();
    } else if (closed != nullptr || std::holds_alternative<bus::ConnectFailed>(event)) {
        m_found = false;
        if (closed == nullptr || closed->error)  // or this program has closed it
            emit lost();
    }
}

void HeadlessLine::announce() {
    const auto hasReported = [](const ModuleState& module) {
        return module.latest || module.silent || !module.isKnown();
    };
    if (!m_found || !std::ranges::all_of(m_store.link().modules, hasReported))
        return;
    m_found = false;
    emit connected();
}

void HeadlessLine::reportStanding() {
    const auto runs = [this](ModuleIndex module) { return m_commander.procedures().running(module); };
    std::set<QString> standing;
    for (const Message& message : texts::standing(m_store.link(), monotonicNow(), runs))
        if (standing.insert(message.key); !m_standing.contains(message.key))
            emit reported(message);
    m_standing = std::move(standing);
}

}  // namespace nmc
