// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef NMC_LENT_LINE
#include "tests/conformance/lentwire.h"
#else
#include "tests/support/patience.h"
#include "tests/support/port.h"
#include "tests/support/simprocess.h"
#endif

/// Common parts of the host programs that are used in the field.
namespace nmc::field {

using Bytes = std::vector<std::uint8_t>;

/// Seconds on nmcsim's clock: the longest packet and its reply at 19 200 Bd, and a servo tick.
inline constexpr double kExchange = 0.05;
/// The number of exchanges in which a motor has to reach its goal.
inline constexpr int kPatience = 400;
inline constexpr unsigned kEveryone = 0xFF;

[[nodiscard]] inline Bytes operator+(Bytes left, const Bytes& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

#ifndef NMC_LENT_LINE
using Sim = testing_support::SimProcess;

/// nmcsim's terminal, as a host uses it. Time is stepped, so that answers do not depend on how busy this
/// computer is.
class Wire {
public:
    explicit Wire(Sim& sim) : m_sim(sim), m_port(sim.terminal()) { setRate(B19200); }

    void setRate(speed_t rate) {
        m_port.setRate(rate);
        m_sim.control("time");  // it looks at the rate before it answers
    }
    /// Sends `bytes` and returns everything that arrives within `seconds`.
    Bytes exchange(const Bytes& bytes, double seconds = kExchange) {
        m_port.write(bytes);
        m_sent += bytes.size();
        while (m_sim.control("time")["received"] < m_sent) {
        }
        const std::size_t sent = m_sim.control("advance " + std::to_string(seconds))["sent"];
        Bytes answer;
        while (answer.size() < sent - m_received) {
            // The kernel hands the bytes over in a thread of its own.
            const Bytes more = m_port.read(sent - m_received - answer.size(), testing_support::kPatienceMs);
            if (more.empty())
                throw std::runtime_error("the terminal lost bytes");
            answer = answer + more;
        }
        m_received = sent;
        return answer;
    }
    [[nodiscard]] std::size_t sent() const { return m_sent; }
    [[nodiscard]] std::size_t received() const { return m_received; }

private:
    Sim& m_sim;
    testing_support::Port m_port;
    std::size_t m_sent = 0;
    std::size_t m_received = 0;
};

#endif

}  // namespace nmc::field
