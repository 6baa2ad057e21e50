// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <termios.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/chainspec.h"
#include "sim/control.h"
#include "tests/support/virtualbus.h"

/// In place of nmcsim's terminal: the line of a panel that is connected to the simulated chain and has lent
/// it, in virtual time (docs/lending.md).
namespace nmc::field {

class Sim {
public:
    explicit Sim(const std::string& chain, const std::vector<std::string>& /*options*/ = {})
        : bus(sim::parseChain(chain).value()) {
        EXPECT_TRUE(bus.connect());
        bus.runFor(std::chrono::milliseconds(200));  // all are known to be at rest
        EXPECT_TRUE(bus.engine.lend());
        bus.runFor(std::chrono::milliseconds(100));
        control("stats clear");
        bus.heard.clear();
    }
    /// The panel has seen the same chain as the program, and has sent nothing.
    ~Sim() {
        EXPECT_EQ(sentByProgram, onTheLine());
        EXPECT_EQ(bus.count<bus::OperationFinished>(), 0U);
    }
    Sim(const Sim&) = delete;
    Sim& operator=(const Sim&) = delete;

    nlohmann::json control(const std::string& line) {
        return nlohmann::json::parse(sim::handleControlLine(bus.chain, line, bus.now));
    }
    nlohmann::json state(int module) { return control("state " + std::to_string(module)); }

    test::VirtualBus bus;
    std::vector<std::uint8_t> sentByProgram;

private:
    std::vector<std::uint8_t> onTheLine() {
        std::vector<std::uint8_t> all;
        for (const auto& sent : bus.sent)
            all.insert(all.end(), sent.bytes.begin(), sent.bytes.end());
        return {all.end() - static_cast<std::ptrdiff_t>(sentByProgram.size()), all.end()};
    }
};

class Wire {
public:
    explicit Wire(Sim& sim) : m_sim(sim) { setRate(B19200); }

    void setRate(speed_t rate) {
        static const std::map<speed_t, std::uint32_t> kRates{
            {B19200, 19'200}, {B57600, 57'600}, {B115200, 115'200}};
        m_sim.bus.engine.onProgramRate(kRates.at(rate));
        m_sim.bus.runFor({});
    }
    std::vector<std::uint8_t> exchange(const std::vector<std::uint8_t>& bytes, double seconds = 0.05) {
        m_sent += bytes.size();
        m_sim.sentByProgram.insert(m_sim.sentByProgram.end(), bytes.begin(), bytes.end());
        m_sim.bus.engine.onProgram(bytes, m_sim.bus.now);
        m_sim.bus.runFor(fromSeconds(seconds));
        m_received += m_sim.bus.heard.size();
        return std::exchange(m_sim.bus.heard, {});
    }
    [[nodiscard]] std::size_t sent() const { return m_sent; }
    [[nodiscard]] std::size_t received() const { return m_received; }

private:
    Sim& m_sim;
    std::size_t m_sent = 0;
    std::size_t m_received = 0;
};

}  // namespace nmc::field
