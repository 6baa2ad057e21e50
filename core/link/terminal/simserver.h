// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "link/terminal/lateness.h"
#include "link/terminal/ptyserver.h"
#include "link/terminal/rateorder.h"
#include "sim/chain.h"
#include "sim/control.h"

namespace nmc {

/// How simulated time passes.
struct Pacing {
    double speed = 1.0;    ///< simulated seconds per real second, above 0
    bool stepped = false;  ///< time stands still except for the control line `advance`
};

/// Serves a simulated chain on a pseudo-terminal and answers control lines; this is what nmcsim does. It runs
/// in the calling thread until `quit`, or until stopFd becomes readable. Free of Qt.
///
/// In stepped mode, the bytes that the host has written before `advance SECONDS` leave its port when that
/// begins, and what reaches the host during it is in the terminal when the line is answered: a test through a
/// real terminal that no scheduler can upset.
class SimServer {
public:
    /// Lines are read from `controlIn`, and each is answered by one line of JSON on `controlOut`. The chain
    /// continues from the time that it has reached.
    SimServer(sim::Chain chain, PtyServer terminal, const Pacing& pacing, int controlIn, int controlOut);

    void run(int stopFd);

private:
    /// The time at which simulated time should be.
    [[nodiscard]] TimePoint wantedNow() const;
    [[nodiscard]] TimePoint realTimeOf(TimePoint simulated) const;
    [[nodiscard]] std::optional<TimePoint> wakeUpAt() const;
    void catchUp();
    void serveHost();
    void drain();
    void deliver();
    /// Returns false when this was the last line.
    bool serveControl();
    bool answer(const std::string& line);
    /// Words have one blank between them.
    std::string answerTo(const std::string& words);
    std::string advance(const std::string& line);
    [[nodiscard]] sim::Pace pace() const;

    sim::Chain m_chain;
    PtyServer m_terminal;
    Pacing m_pacing;
    int m_controlIn;
    int m_controlOut;
    std::string m_pendingLine;
    bool m_controlOpen = true;
    std::uint32_t m_hostBaud = 0;
    RateOrder m_rateOrder;
    TimePoint m_started;
    TimePoint m_now;           ///< simulated time reached so far
    bool m_overslept = false;  ///< bytes from the host may have waited
    std::uint64_t m_received = 0;
    std::uint64_t m_sent = 0;
    Lateness m_lateness;  ///< delays of bytes to the host since the last query
    StallWatch m_stalls;
    LagReport m_lagReport;
};

}  // namespace nmc
