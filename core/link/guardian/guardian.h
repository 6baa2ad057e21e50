// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include "base/bytes.h"
#include "base/time.h"
#include "link/guardian/descriptor.h"
#include "link/guardian/guardianproblem.h"
#include "link/guardian/guardmemory.h"

namespace nmc {

/// The paths that a guardian needs besides the port.
struct GuardianPlace {
    std::string program;     ///< path of the nmcguard program
    std::string reportFile;  ///< absolute; see link/guardian/guardreport.h
};

/// The panel's side of its guardian: a separate process, nmcguard, that stops the motors when the panel no
/// longer can because it was killed, crashed, or hangs. The modules have no watchdog, and a signal handler
/// cannot handle SIGKILL, a stopped process, or a core dump that takes its time.
///
/// The guardian shares the open port and a small memory (guardmemory.h), which always holds the current stop
/// burst. It writes when this process has died while a burst is armed, and when the last beat is older than
/// BeatMonitor::kLongest while anything moves; never while the panel is alive and beats. It then waits for a
/// quiet line, sets the burst's rate, and sends the burst three times. A panel in a debugger whose bus loop
/// keeps running is not affected; if the whole panel is halted while a motor moves, the motor is stopped, and
/// the panel is informed when it continues. The guardian also acts after a crash that crashburst.h has
/// handled: repeating a stop does no harm.
///
/// **The lock.** The two processes share one open file description of the port, and the flock belongs to the
/// description, not to a process: it is held until both have closed it. Between the panel's death and the
/// guardian's end, no other panel can therefore open the port, although Qt's lock file, which names a dead
/// process by then, could be taken over; nor can any other program that is not root, because TIOCEXCL stays
/// in force as long. Before it writes, the guardian requests that flock again, which changes nothing when it
/// is held and fails when another description has it: in that case it sends nothing.
///
/// Not covered: a power cut, a cut cable, an adapter that hangs, and the killing of both processes at once.
///
/// Bus thread only. arm() and beat() neither lock nor allocate.
class Guardian {
public:
    /// Starts the guardian for an open terminal and waits until it is ready. It inherits only the terminal
    /// from this process: no other descriptor, no signal mask, no process group.
    [[nodiscard]] static tl::expected<Guardian, GuardianProblem> start(int port, const GuardianPlace& place);
    Guardian(Guardian&&) noexcept = default;
    Guardian& operator=(Guardian&&) = delete;
    /// Calls end().
    ~Guardian();

    /// Sets what to send from now on and at which rate (an empty burst: nothing), and whether anything moves.
    /// Called after each change of the three, before the command that causes the change is sent. A burst that
    /// does not fit as a whole is refused, and nothing is armed.
    bool arm(ByteSpan burst, std::uint32_t baud, bool moving);
    /// Reports that the loop is running and about to use the port; called at least every
    /// LoopGuard::kBeatEvery while anything moves. If the guardian is sending at that moment, because this
    /// process stood still, waits until it has finished. Returns true once after the guardian has stopped the
    /// motors: their assumed state and the port's rate are no longer certain. The guardian's report file is
    /// removed, because its content is returned here.
    [[nodiscard]] bool beat(TimePoint now);
    /// Checks the guardian with one system call.
    [[nodiscard]] bool alive() const;
    [[nodiscard]] pid_t process() const { return m_process; }
    /// Called when the port is about to be closed normally; returns when the guardian has released it.
    void end();

private:
    Guardian(GuardMemory memory, Descriptor channel, pid_t process, std::string reportFile)
        : m_memory(std::move(memory)),
          m_channel(std::move(channel)),
          m_process(process),
          m_reportFile(std::move(reportFile)) {}

    GuardMemory m_memory;
    Descriptor m_channel;
    pid_t m_process;
    std::string m_reportFile;
    Beat m_beat;
    std::uint32_t m_stopsReported = 0;
};

}  // namespace nmc
