// SPDX-License-Identifier: MIT
#include "link/connection/busworker.h"

#include <utility>

namespace nmc {

BusWorker::BusWorker(QObject* parent) : QObject(parent) {
    m_beatTimer.setInterval(std::chrono::duration_cast<std::chrono::milliseconds>(Heartbeat::kInterval));
    connect(&m_beatTimer, &QTimer::timeout, this, [this] { m_loop.beat(); });
}

void BusWorker::open(TransportFactory factory, bus::EngineConfig config) {
    m_loop.open(std::move(factory), config);
    m_beatTimer.start();
}

void BusWorker::connectAgain() {
    m_loop.search(RequestBox::Search::Again);
}

void BusWorker::restart() {
    m_loop.search(RequestBox::Search::Restart);
}

void BusWorker::submit(bus::Operation operation) {
    m_loop.ask(std::move(operation));
}

void BusWorker::submit(bus::GroupOperation operation) {
    m_loop.ask(operation);
}

void BusWorker::changeRate(std::uint32_t baud) {
    m_loop.ask(ChangeRate{baud});
}

void BusWorker::control(std::string line) {
    m_loop.ask(ControlLine{std::move(line)});
}

void BusWorker::hold(const bus::HoldToMove& hold) {
    m_loop.hold(hold);
}

void BusWorker::release() {
    m_loop.release();
}

std::vector<WorkerEvent> BusWorker::takeEvents() {
    std::vector<WorkerEvent> events = m_loop.takeEvents();
    if (!m_loop.isOpen())
        m_beatTimer.stop();
    return events;
}

}  // namespace nmc
