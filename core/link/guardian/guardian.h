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

/// What a guardian needs besides the port.
struct GuardianPlace {
    std::string program;     ///< path of nmcguard
    std::string reportFile;  ///< absolute; see link/guardian/guardreport.h
};

/// The panel's end of its guardian: a process of its own, nmcguard, that stops the motors when the panel no
/// longer can: killed, crashed, or stuck. The modules have no watchdog, and a signal handler is beyond
/// SIGKILL, a stopped process and a core dump that takes its time.
///
/// It shares the open port and a little memory (guardmemory.h), in which the stop burst always lies ready. It
/// writes when this process has died and a burst is armed, and when the last beat is older than
/// BeatJudge::kLongest while anything moves; never while the panel lives and beats. It then waits for a quiet
/// line, sets the burst's rate, and sends the burst three times. A panel in a debugger whose bus loop goes on
/// has nothing to fear; one that is halted whole while a motor moves has it stopped, and is told when it goes
/// on. A crash that crashburst.h has dealt with is followed by the guardian as well: a stop that is repeated
/// is the same stop.
///
/// **The lock.** The port is shared by one open file description, and its flock belongs to that and not to a
/// process: it is held until the last of the two has closed it. So between the panel's death and the
/// guardian's end no other panel gets the port, though Qt's lock file, which names a dead process by then, is
/// free for the taking; nor does any other program that is not root, since TIOCEXCL stays in force as long.
/// Before it writes, the guardian asks for that flock once more, which changes nothing when it is held and
/// fails when another description has it: then it keeps silent.
///
/// Beyond it: a power cut, a cut cable, an adapter that hangs, and whoever kills both processes at once.
///
/// Bus thread only. arm() and beat() neither lock nor allocate.
class Guardian {
public:
    /// While anything moves beat() is due at least this often.
    static constexpr Duration kBeatEvery = std::chrono::milliseconds(50);

    /// Starts it for an open terminal, and waits until it is ready. Of this process it gets the terminal and
    /// nothing else: no other descriptor, no signal mask, no process group.
    [[nodiscard]] static tl::expected<Guardian, GuardianProblem> start(int port, const GuardianPlace& place);
    Guardian(Guardian&&) noexcept = default;
    Guardian& operator=(Guardian&&) = delete;
    /// end()
    ~Guardian();

    /// What to send from now on, and at which rate, nothing when empty; and whether anything moves. After
    /// each change of the three, before the command that changes it leaves. A burst that does not fit whole
    /// is refused, and nothing is armed.
    bool arm(ByteSpan burst, std::uint32_t baud, bool moving);
    /// The loop turns, and is about to use the port. When the guardian is just speaking, because this process
    /// stood still, returns when it has finished. True once after it stopped the motors: what is believed of
    /// them, and the port's rate, are no longer sure. Its report is taken back: it is told here.
    [[nodiscard]] bool beat(TimePoint now);
    /// A system call.
    [[nodiscard]] bool alive() const;
    [[nodiscard]] pid_t process() const { return m_process; }
    /// The port is about to be closed in order: returns when the guardian has let go of it.
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
    std::uint32_t m_stopsTold = 0;
};

}  // namespace nmc
