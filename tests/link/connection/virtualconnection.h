// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include "tests/link/connection.h"
#include "tests/support/virtualchain.h"

namespace nmc::testing_support {

/// A worker and a store at a chain in virtual time, which passes while a test waits.
class VirtualConnection : public Connection {
public:
    explicit VirtualConnection(VirtualChain& chain) : m_chain(chain) {}
    /// The worker would wait for its bus thread, for which time passes only while a test waits here.
    ~VirtualConnection() override {
        worker().close();
        while (m_chain.open())
            freeze(kFrame);
    }

    /// Opens the chain like the built-in simulator, without an adapter that would delay anything.
    void open(std::uint32_t baud = 19'200) {
        bus::EngineConfig config;
        config.baud = baud;
        open(config);
    }
    void open(bus::EngineConfig config) {
        config.adapterLatency = Duration::zero();
        Connection::open(m_chain.transport(), config);
    }
    /// Lets time pass on the bus only: no event of this thread is handled.
    void freeze(Duration time) { m_chain.run(time); }

protected:
    bool wait(const std::function<bool()>& predicate) override {
        for (Duration waited{}; !predicate(); waited += kFrame) {
            if (waited > kPatience)
                return false;
            freeze(kFrame);
            QCoreApplication::processEvents();
        }
        return true;
    }

private:
    static constexpr Duration kFrame = std::chrono::milliseconds(10);
    static constexpr Duration kPatience = std::chrono::seconds(20);

    VirtualChain& m_chain;
};

}  // namespace nmc::testing_support
