// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/patience.h"
#include "tests/support/port.h"
#include "tests/support/simprocess.h"

namespace nmc::terminal {

using testing_support::kPatienceMs;
using testing_support::Port;
using testing_support::SimProcess;
using Bytes = std::vector<std::uint8_t>;

inline const Bytes kNop{0xAA, 0x01, 0x0E, 0x0F};
inline const Bytes kSetAddress{0xAA, 0x00, 0x21, 0x01, 0xFF, 0x21};
inline const Bytes kIdle{0x19, 0x19};
// Commands to all modules, which none of them answers.
inline const Bytes kNopToAll{0xAA, 0xFF, 0x0E, 0x0D};
inline const Bytes kResetAll{0xAA, 0xFF, 0x0F, 0x0E};
inline const Bytes kAllTo115200{0xAA, 0xFF, 0x1A, 10, 0x23};
inline const Bytes kAllTo19200{0xAA, 0xFF, 0x1A, 63, 0x58};

/// nmcsim with its time stepped, and a host that opens its terminal, writes, reads, hangs up and comes back.
class Host {
public:
    explicit Host(const std::vector<std::string>& options = {})
        : sim("servo", withStepped(options)), m_port(sim.terminal()) {}

    SimProcess sim;

    [[nodiscard]] speed_t rate() const { return m_port->rate(); }
    void setRate(speed_t rate) {
        m_port->setRate(rate);
        sim.control("time");  // the simulator looks at the rate before it answers
    }
    /// Does both without a pause: meanwhile the simulator may have noticed all, some or nothing of it.
    void writeAndSetRate(const Bytes& before, speed_t rate, const Bytes& behind) {
        if (!before.empty())
            m_port->write(before);
        if (buildsSettingsAnew)
            m_port->setRateAnew(rate);
        else
            m_port->setRate(rate);
        if (!behind.empty())
            m_port->write(behind);
        m_written += before.size() + behind.size();
        waitUntilHeard();
    }
    bool buildsSettingsAnew = false;
    void hangUp() { m_port.reset(); }
    void comeBack() { m_port.emplace(sim.terminal()); }

    /// Hands the bytes over to the simulator; they leave when time passes.
    void write(const Bytes& bytes) {
        m_port->write(bytes);
        m_written += bytes.size();
        waitUntilHeard();
    }
    void pass(double seconds) { sim.control("advance " + std::to_string(seconds)); }

    /// Sends a command and returns everything that is answered within a tenth of a second.
    Bytes answer(const Bytes& command) {
        const std::size_t before = sim.control("time")["sent"];
        write(command);
        pass(0.1);
        Bytes all;
        for (std::size_t coming = sim.control("time")["sent"].get<std::size_t>() - before; coming > 0;) {
            const Bytes more = m_port->read(coming, kPatienceMs);
            if (more.empty())
                throw std::runtime_error("the terminal lost bytes");
            all.insert(all.end(), more.begin(), more.end());
            coming -= more.size();
        }
        return all;
    }
    bool answers(const Bytes& command, const Bytes& wanted = kIdle) { return answer(command) == wanted; }
    /// Like answers(), but first discards everything unread.
    bool answersAfterAFlood(const Bytes& command, const Bytes& wanted = kIdle) {
        m_port->flush();
        return answers(command, wanted);
    }

    unsigned nops() { return sim.control("stats")["modules"][0]["executed"].value("nop", 0U); }
    /// Number of bytes that were received wrong.
    unsigned garbled() { return sim.control("stats")["modules"][0]["bytes_garbled"]; }

private:
    void waitUntilHeard() {
        while (sim.control("time")["received"] < m_written) {
        }
    }
    static std::vector<std::string> withStepped(std::vector<std::string> options) {
        options.emplace_back("--stepped");
        return options;
    }

    std::optional<Port> m_port;
    std::size_t m_written = 0;
};

}  // namespace nmc::terminal
