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
    qCDebug(requestLog) << "find the chain anew";
    m_loop.requestBox().search(RequestBox::Search::Again);
}

void BusWorker::restart() {
    qCDebug(requestLog) << "restart the network";
    m_loop.requestBox().search(RequestBox::Search::Restart);
}

void BusWorker::submit(bus::Operation operation) {
    qCDebug(requestLog).noquote() << logLine(operation).c_str();
    m_loop.ask(std::move(operation));
}

void BusWorker::submit(bus::GroupOperation operation) {
    qCDebug(requestLog).noquote() << logLine(operation).c_str();
    m_loop.ask(operation);
}

void BusWorker::changeRate(std::uint32_t baud) {
    qCDebug(requestLog) << "change the rate to" << baud;
    m_loop.ask(ChangeRate{baud});
}

void BusWorker::readdress(ModuleIndex module) {
    qCDebug(requestLog) << "readdress module" << module.value() + 1;
    m_loop.ask(Readdress{module});
}

void BusWorker::resetModule(ModuleIndex module, const std::optional<servo::HardReset>& configuration) {
    qCDebug(requestLog) << "reset module" << module.value() + 1;
    m_loop.ask(ResetModule{module, configuration});
}

void BusWorker::changeAddress(ModuleIndex module, BusAddress address) {
    qCDebug(requestLog) << "change the address of module" << module.value() + 1 << "to" << address.value();
    m_loop.ask(Readdress{module, address});
}

void BusWorker::control(std::string line) {
    qCDebug(requestLog).noquote() << "simulator:" << line.c_str();
    m_loop.ask(ControlLine{std::move(line)});
}

void BusWorker::hold(const bus::HoldToMove& hold) {
    qCDebug(requestLog) << "hold to move, module" << hold.module.value() + 1;
    m_loop.requestBox().hold(hold);
}

void BusWorker::release() {
    qCDebug(requestLog) << "release";
    m_loop.requestBox().release();
}

void BusWorker::lend(std::string path) {
    qCDebug(requestLog) << "lend the line at" << path.c_str();
    m_loop.requestBox().lend(std::move(path));
}

void BusWorker::letThrough() {
    qCDebug(requestLog) << "let the program through";
    m_loop.requestBox().letThrough();
}

void BusWorker::endLending() {
    qCDebug(requestLog) << "end lending";
    m_loop.requestBox().endLending();
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
