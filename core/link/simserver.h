// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "link/ptyserver.h"
#include "sim/chain.h"

namespace nmc {

/// Serves a simulated chain on a pseudo-terminal in real time, and answers control lines: what nmcsim does.
/// Runs in the calling thread until `quit` or until stopFd becomes readable. Without Qt.
class SimServer {
public:
    /// `speed` is simulated seconds per real second, above 0. `controlIn` is read for lines, `controlOut`
    /// gets one line of JSON for each.
    SimServer(sim::Chain chain, PtyServer terminal, double speed, int controlIn, int controlOut);

    void run(int stopFd);

private:
    [[nodiscard]] TimePoint simulatedNow() const;
    [[nodiscard]] TimePoint realTimeOf(TimePoint simulated) const;
    void serveHost();
    void deliver();
    /// Returns false when it was the last line.
    bool serveControl();
    bool answer(const std::string& line);

    sim::Chain m_chain;
    PtyServer m_terminal;
    double m_speed;
    int m_controlIn;
    int m_controlOut;
    std::string m_pendingLine;
    bool m_controlOpen = true;
    std::uint32_t m_hostBaud = 0;
    TimePoint m_started;
    double m_lag = 0;  ///< s, the largest since it was last asked for
};

}  // namespace nmc
