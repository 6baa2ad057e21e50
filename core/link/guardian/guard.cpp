// SPDX-License-Identifier: MIT
#include "link/guardian/guard.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/socket.h>

#include <array>
#include <csignal>
#include <utility>

#include "link/clock.h"
#include "link/guardian/beatmonitor.h"
#include "link/guardian/guardmemory.h"
#include "link/guardian/guardreport.h"
#include "link/threadpriority.h"

namespace nmc {

namespace {

using Fds = GuardDescriptors;

/// The nulls of the first burst at the latest complete a packet that was cut short; whatever noise damages in
/// the second burst is repeated by the third.
constexpr int kTimes = 3;
/// After a packet, and before the next: one servo tick (DS-V 4.1), plus time for an adapter to pass it on.
constexpr Duration kPause = std::chrono::milliseconds(2);
constexpr Duration kQuiet = std::chrono::milliseconds(3);
/// A line that is never quiet must not delay the stop longer than this: a command interrupts the modules'
/// replies.
constexpr Duration kQuietLimit = std::chrono::milliseconds(60);

void pause(Duration time) {
    pollUntil({}, monotonicNow() + time);
}

/// True when this open file description holds the port's lock, or has just reacquired it; false when another
/// description holds it. The description is the one shared with the panel, so the lock outlives the panel.
bool lockIsOurs() {
    return ::flock(Fds::kPort, LOCK_EX | LOCK_NB) == 0;
}

/// Waits until nothing has been received and nothing was left to send for a while. Output that is then still
/// queued would only be in the way, so it is flushed.
void waitForQuiet() {
    const TimePoint limit = monotonicNow() + kQuietLimit;
    std::pair<int, int> before{-1, -1};
    TimePoint since = monotonicNow();
    while (true) {
        std::pair<int, int> pending{0, 0};  // in, out
        ::ioctl(Fds::kPort, FIONREAD, &pending.first);
        ::ioctl(Fds::kPort, TIOCOUTQ, &pending.second);
        const TimePoint now = monotonicNow();
        if (std::exchange(before, pending) != pending || pending.second != 0)
            since = now;
        if (now - since >= kQuiet)
            return;
        if (now >= limit)
            break;
        pause(kLookEvery);
    }
    constexpr int kOutput = 1;  // TCOFLUSH
    ::ioctl(Fds::kPort, TCFLSH, kOutput);
}

class Guard {
public:
    Guard(GuardMemory memory, std::string reportFile)
        : m_memory(std::move(memory)),
          m_reportFile(std::move(reportFile)),
          m_panelFd(::fcntl(Fds::kPanel, F_GETFD) >= 0 ? int{Fds::kPanel} : -1) {}

    GuardEnd run() {
        while (true) {
            std::array<pollfd, 3> fds{{{Fds::kPort, 0, 0}, {m_channelFd, POLLIN, 0}, {m_panelFd, POLLIN, 0}}};
            pollUntil(fds, m_monitor.lookBy(m_memory.beat()));
            if (m_memory.ended())
                return GuardEnd::PanelEnded;
            if (fds[0].revents != 0)
                return GuardEnd::PortVanished;
            const bool closed = fds[1].revents != 0 && !takeWakes();
            if (fds[2].revents != 0 || (closed && m_panelFd < 0)) {
                outlive();
                return GuardEnd::Outlived;
            }
            if (closed)
                m_channelFd = -1;  // the panel is dying; only the end of its process counts
            if (const Beat beat = m_memory.beat(); m_monitor.expired(beat, monotonicNow()))
                standIn(beat);
        }
    }

private:
    /// Returns false at the end of the channel.
    [[nodiscard]] static bool takeWakes() {
        std::array<char, 64> wakes{};
        ssize_t got = 0;
        while ((got = ::recv(Fds::kChannel, wakes.data(), wakes.size(), MSG_DONTWAIT)) > 0) {
        }
        return got < 0;
    }

    /// The panel no longer exists. While our copy of its lock remains, no other program can use this port.
    void outlive() {
        stopMotors(std::nullopt);
        // Leaves the port as a close by the panel would.
        ::ioctl(Fds::kPort, TIOCNXCL);
    }

    /// The panel exists but does nothing. It may resume at any instant: once it sees that the guardian has
    /// the line, it waits; if it resumed earlier, its beat is new and the line belongs to it.
    void standIn(const Beat& stale) {
        m_memory.setGuardianSpeaks(true);
        if (stopMotors(stale))
            m_memory.noteStop();
        m_memory.setGuardianSpeaks(false);
    }

    bool stopMotors(std::optional<Beat> stale) {
        const StopBurst burst = m_memory.burst();
        if (burst.size == 0 || !lockIsOurs())
            return false;
        waitForQuiet();
        if (stale && m_memory.beat() != *stale)
            return false;
        bool said = false;
        for (int i = 0; i < kTimes; ++i) {
            said = sendBurst(Fds::kPort, burst) || said;
            pause(kPause);
        }
        if (said)
            writeGuardReport(m_reportFile, burst);
        return said;
    }

    GuardMemory m_memory;
    std::string m_reportFile;
    BeatMonitor m_monitor;
    int m_channelFd = Fds::kChannel;
    int m_panelFd;
};

}  // namespace

GuardEnd runGuard(const std::string& reportFile) {
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP, SIGTTIN, SIGTTOU})
        std::signal(number, SIG_IGN);
    auto memory = GuardMemory::attach(Fds::kMemory);
    const std::uint32_t version = GuardMemory::kVersion;
    if (!memory || ::send(Fds::kChannel, &version, sizeof version, MSG_NOSIGNAL) != sizeof version)
        return GuardEnd::NotStarted;
    // Both are useful but not required, as not every user may have them.
    ::mlockall(MCL_CURRENT | MCL_FUTURE);
    preferThisThread();
    return Guard(std::move(*memory), reportFile).run();
}

}  // namespace nmc
