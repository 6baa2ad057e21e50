// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "link/terminal/lateness.h"
#include "link/terminal/ptyserver.h"
#include "sim/chain.h"
#include "sim/control.h"
#include "sim/receiver.h"

namespace nmc {

/// What makes simulated time pass.
struct Pacing {
    double speed = 1.0;    ///< simulated seconds per real second, above 0
    bool stepped = false;  ///< time stands still but for the control line `advance`
};

/// Serves a simulated chain on a pseudo-terminal, and answers control lines: what nmcsim does. Runs in the
/// calling thread until `quit` or until stopFd becomes readable. Without Qt.
///
/// Stepped, the bytes that the host has written before `advance SECONDS` leave its port when that begins, and
/// what reaches the host during it is in the terminal when it is answered: a test through a real terminal
/// that no scheduler can upset.
class SimServer {
public:
    /// `controlIn` is read for lines, `controlOut` gets one line of JSON for each. The chain goes on from the
    /// time that it has reached.
    SimServer(sim::Chain chain, PtyServer terminal, const Pacing& pacing, int controlIn, int controlOut);

    void run(int stopFd);

private:
    /// What simulated time should be.
    [[nodiscard]] TimePoint wantedNow() const;
    [[nodiscard]] TimePoint realTimeOf(TimePoint simulated) const;
    [[nodiscard]] std::optional<TimePoint> wakeUpAt() const;
    void catchUp();
    void serveHost();
    void drain();
    [[nodiscard]] std::size_t beforeNewRate(const HostActs& acts);
    /// Number of `bytes` up to the end of the last Set Baud or Hard Reset among them; 0 without one.
    std::size_t endOfLastRateCommand(ByteSpan bytes);
    void deliver();
    /// Returns false when it was the last line.
    bool serveControl();
    bool answer(const std::string& line);
    std::string answerTo(const std::string& line);
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
    sim::Receiver m_monitor;  ///< hears the host, whatever the rates
    /// Its last command was Set Baud or Hard Reset, and it has set no rate since.
    bool m_sentRateCommand = false;
    TimePoint m_started;
    TimePoint m_now;           ///< simulated time that has been reached
    bool m_overslept = false;  ///< what the host wrote may have waited
    std::uint64_t m_received = 0;
    std::uint64_t m_sent = 0;
    Lateness m_lateness;  ///< of the bytes to the host, since last asked
    StallWatch m_stalls;
    LagReport m_lagReport;
};

}  // namespace nmc
