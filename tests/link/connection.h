// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSignalSpy>
#include <functional>
#include <memory>
#include <vector>

#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "link/connection/serialtransport.h"
#include "tests/support/eventually.h"
#include "tests/support/gains.h"

namespace nmc::testing_support {

/// A worker and a store like those of the panel, and the events that the store emitted.
class Connection {
public:
    Connection() {
        QObject::connect(&m_store, &BusStore::happened,
                         [this](const StoreEvent& event) { m_news.push_back(event); });
    }
    virtual ~Connection() = default;

    void open(BusWorker::TransportFactory factory, std::uint32_t baud = 19'200) {
        bus::EngineConfig config;
        config.baud = baud;
        open(std::move(factory), config);
    }
    void open(BusWorker::TransportFactory factory, const bus::EngineConfig& config) {
        m_store.begin(QStringLiteral("test"), false, config.baud);
        m_worker.open(std::move(factory), config);
    }
    void openSerial(const QString& port, std::uint32_t baud = 19'200) {
        open([port] { return std::make_unique<SerialTransport>(port); }, baud);
    }

    template <typename Event>
    [[nodiscard]] const Event* news() const {
        for (const StoreEvent& event : m_news)
            if (const auto* found = std::get_if<Event>(&event))
                return found;
        return nullptr;
    }
    template <typename Event>
    [[nodiscard]] int count() const {
        int number = 0;
        for (const StoreEvent& event : m_news)
            number += std::holds_alternative<Event>(event) ? 1 : 0;
        return number;
    }
    template <typename Event, typename Look>
    void forEach(Look look) const {
        for (const StoreEvent& event : m_news)
            if (const auto* found = std::get_if<Event>(&event))
                look(*found);
    }
    void forgetNews() { m_news.clear(); }

    template <typename Predicate>
    bool waitUntil(Predicate predicate) {
        return wait(predicate);
    }
    template <typename Event>
    bool waitFor() {
        return waitUntil([this] { return news<Event>() != nullptr; });
    }

    void submit(std::vector<bus::Order> steps) {
        m_worker.ask(bus::Operation{bus::OperationId(++m_lastId), std::move(steps)});
    }
    /// Sends the steps, waits, and returns how they ended.
    bus::Outcome carryOut(std::vector<bus::Order> steps) {
        m_news.clear();
        submit(std::move(steps));
        return waitFor<bus::OperationFinished>() ? news<bus::OperationFinished>()->outcome
                                                 : bus::Outcome::Cancelled;
    }

    BusWorker& worker() { return m_worker; }
    BusStore& store() { return m_store; }
    const ModuleState& module(std::uint8_t index) { return *m_store.module(ModuleIndex(index)); }

protected:
    /// Returns false if the predicate never holds.
    virtual bool wait(const std::function<bool()>& predicate) { return eventually(predicate); }

private:
    BusWorker m_worker;
    BusStore m_store{m_worker};
    std::vector<StoreEvent> m_news;
    std::uint32_t m_lastId = 0;
};

inline bus::Order step(std::uint8_t module, ServoCommand command) {
    return {ModuleIndex(module), std::move(command)};
}

/// The gains and the enabling of every end-to-end test.
inline std::vector<bus::Order> gainsAndEnable(std::uint8_t module) {
    return {step(module, testing_support::kGains),
            step(module, servo::StopMotor{true, servo::StopManner::Abruptly, {}})};
}

inline std::vector<bus::Order> move(std::uint8_t module, std::int32_t goal) {
    servo::LoadTrajectory load;
    load.position = Counts(goal);
    load.velocity = CountsPerTick(8 << 16);
    load.acceleration = CountsPerTickSquared(1'311);  // 0.02 counts/tick^2
    return {step(module, load), step(module, StartMotion{})};
}

}  // namespace nmc::testing_support
