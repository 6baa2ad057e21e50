// SPDX-License-Identifier: MIT
#include "link/connection/busworker.h"

#include <utility>

#include "link/connection/linklog.h"

namespace nmc {

BusWorker::BusWorker(QObject* parent) : QObject(parent) {
    m_beatTimer.setInterval(std::chrono::duration_cast<std::chrono::milliseconds>(Heartbeat::kInterval));
    connect(&m_beatTimer, &QTimer::timeout, this, [this] { m_loop.beat(); });
}

void BusWorker::open(TransportFactory factory, bus::EngineConfig config) {
    qCDebug(linkLog) << "connecting, wanted rate" << config.baud;
    m_loop.open(std::move(factory), config);
    m_beatTimer.start();
}

void BusWorker::connectAgain() {
    qCDebug(requestLog) << "find the chain again";
    change([](auto& pending) { pending.search = RequestBox::Search::Again; });
}

void BusWorker::restart() {
    qCDebug(requestLog) << "restart the network";
    change([](auto& pending) { pending.search = RequestBox::Search::Restart; });
}

void BusWorker::ask(BusRequest request) {
    qCDebug(requestLog).noquote() << logLine(request).c_str();
    m_loop.ask(std::move(request));
}

void BusWorker::hold(const bus::HoldToMove& hold) {
    qCDebug(requestLog) << "hold to move, module" << hold.module.value() + 1;
    change([&](auto& pending) { pending.held = hold; });
}

void BusWorker::release() {
    qCDebug(requestLog) << "release";
    change([](auto& pending) { pending.release(); });
}

void BusWorker::lend(std::string path) {
    qCDebug(requestLog) << "lend the line at" << path.c_str();
    change([&](auto& pending) { pending.lendAt = std::move(path); });
}

void BusWorker::letThrough() {
    qCDebug(requestLog) << "let the program through";
    change([](auto& pending) { pending.letThrough = true; });
}

void BusWorker::endLending() {
    qCDebug(requestLog) << "end lending";
    change([](auto& pending) { pending.stopLending(); });
}

std::vector<WorkerEvent> BusWorker::takeEvents() {
    std::vector<WorkerEvent> events = m_loop.takeEvents();
    if (linkLog().isDebugEnabled())
        log(events);
    if (!m_loop.isOpen())
        m_beatTimer.stop();
    return events;
}

void BusWorker::log(const std::vector<WorkerEvent>& events) {
    for (const WorkerEvent& event : events)
        if (const std::string line = logLine(event); !line.empty())
            qCDebug(linkLog).noquote() << line.c_str();
    if (const std::size_t dropped = m_loop.droppedSamples();
        dropped != std::exchange(m_droppedSamples, dropped))
        qCDebug(linkLog) << "samples dropped so far:" << dropped;
}

}  // namespace nmc
