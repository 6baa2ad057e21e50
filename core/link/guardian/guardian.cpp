// SPDX-License-Identifier: MIT
#include "link/guardian/guardian.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

#include "link/clock.h"
#include "link/guardian/guard.h"

namespace nmc {

namespace {

constexpr Duration kStartPatience = std::chrono::seconds(5);
constexpr Duration kEndPatience = std::chrono::seconds(1);
/// Three bursts of the maximum size at the lowest rate are finished by then.
constexpr Duration kSpeechPatience = std::chrono::seconds(10);

/// Duplicates a descriptor to a number above those that the guardian uses.
Descriptor copyAbove(int fd) {
    return Descriptor(::fcntl(fd, F_DUPFD_CLOEXEC, int{GuardDescriptors::kCount}));
}

/// What the child inherits: posix_spawn needs both structures initialized and freed.
struct Birth {
    Birth() {
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawnattr_init(&attributes);
        sigset_t all;
        sigset_t none;
        ::sigfillset(&all);
        ::sigemptyset(&none);
        ::posix_spawnattr_setsigdefault(&attributes, &all);
        ::posix_spawnattr_setsigmask(&attributes, &none);
        ::posix_spawnattr_setflags(&attributes,
                                   POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSID);
        // A program that waits for the end of the panel's output must not wait for the guardian.
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
            ::posix_spawn_file_actions_addopen(&actions, standard, "/dev/null", O_RDWR, 0);
        ::posix_spawn_file_actions_addchdir_np(&actions, "/");
    }
    ~Birth() {
        ::posix_spawn_file_actions_destroy(&actions);
        ::posix_spawnattr_destroy(&attributes);
    }
    Birth(const Birth&) = delete;
    Birth& operator=(const Birth&) = delete;

    void give(const Descriptor& fd, int as) { ::posix_spawn_file_actions_adddup2(&actions, fd.get(), as); }

    posix_spawn_file_actions_t actions{};
    posix_spawnattr_t attributes{};
};

GuardianProblem problemOf(int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR:
            return GuardianProblem::Missing;
        case EACCES:
        case EPERM:
            return GuardianProblem::NotPermitted;
        case ENOEXEC:
            return GuardianProblem::WrongVersion;
        default:
            return GuardianProblem::Failed;
    }
}

tl::expected<pid_t, GuardianProblem> spawn(const GuardianPlace& place, int port, int memory, int channel) {
    // Not available on an old kernel. The C library's own pidfd_open(2) cannot be linked from C++ before
    // version 2.37.
    const Descriptor panel(static_cast<int>(::syscall(SYS_pidfd_open, ::getpid(), 0)));
    const std::array gifts{copyAbove(port), copyAbove(memory), copyAbove(channel),
                           panel.valid() ? copyAbove(panel.get()) : Descriptor()};
    Birth birth;
    int next = GuardDescriptors::kPort;
    for (const Descriptor& gift : gifts) {
        if (gift.valid())
            birth.give(gift, next++);
        else if (next < GuardDescriptors::kPanel)
            return tl::unexpected(GuardianProblem::Failed);
    }
    ::posix_spawn_file_actions_addclosefrom_np(&birth.actions, next);
    std::string program = place.program;
    std::string report = place.reportFile;
    std::array<char*, 3> arguments{program.data(), report.data(), nullptr};
    pid_t process = -1;
    const int error = ::posix_spawn(&process, place.program.c_str(), &birth.actions, &birth.attributes,
                                    arguments.data(), environ);
    if (error != 0)
        return tl::unexpected(problemOf(error));
    return process;
}

bool saysItIsReady(int channel) {
    std::array<pollfd, 1> answer{{{channel, POLLIN, 0}}};
    std::uint32_t version = 0;
    return pollUntil(answer, monotonicNow() + kStartPatience) > 0 &&
           ::recv(channel, &version, sizeof version, MSG_DONTWAIT) == sizeof version &&
           version == GuardMemory::kVersion;
}

}  // namespace

tl::expected<Guardian, GuardianProblem> Guardian::start(int port, const GuardianPlace& place) {
    auto memory = GuardMemory::create();
    std::array<int, 2> ends{-1, -1};
    if (!memory || ::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return tl::unexpected(GuardianProblem::Failed);
    Descriptor ours(ends[0]);
    Descriptor theirs(ends[1]);
    const auto process = spawn(place, port, memory->fd(), theirs.get());
    if (!process)
        return tl::unexpected(process.error());
    theirs.reset();
    const bool ready = saysItIsReady(ours.get());
    Guardian guardian(std::move(*memory), std::move(ours), *process, place.reportFile);
    if (!ready)
        return tl::unexpected(GuardianProblem::WrongVersion);
    guardian.m_beat.at = monotonicNow();
    return guardian;
}

Guardian::~Guardian() {
    end();
}

bool Guardian::arm(ByteSpan burst, std::uint32_t baud, bool moving) {
    const auto ready = StopBurst::of(burst, baud);
    m_memory.arm(ready.value_or(StopBurst{}));
    const bool wasMoving = std::exchange(m_beat.moving, moving);
    m_memory.setBeat(m_beat);
    if (moving && !wasMoving) {
        const char wake = 0;
        [[maybe_unused]] const auto sent =
            ::send(m_channel.get(), &wake, sizeof wake, MSG_DONTWAIT | MSG_NOSIGNAL);
    }
    return ready.has_value();
}

bool Guardian::beat(TimePoint now) {
    m_beat.at = now;
    m_memory.setBeat(m_beat);
    const TimePoint limit = now + kSpeechPatience;
    while (m_memory.guardianSpeaks() && alive() && monotonicNow() < limit)
        pollUntil({}, monotonicNow() + kLookEvery);
    const std::uint32_t stops = m_memory.stops();
    if (std::exchange(m_stopsReported, stops) == stops)
        return false;
    ::unlink(m_reportFile.c_str());
    return true;
}

bool Guardian::alive() const {
    char none = 0;
    return ::recv(m_channel.get(), &none, sizeof none, MSG_PEEK | MSG_DONTWAIT) < 0 && errno == EAGAIN;
}

void Guardian::end() {
    if (!m_channel.valid())
        return;
    m_memory.end();
    m_channel.reset();
    const TimePoint limit = monotonicNow() + kEndPatience;
    while (::waitpid(m_process, nullptr, WNOHANG) == 0) {
        if (monotonicNow() >= limit) {
            ::kill(m_process, SIGKILL);
            ::waitpid(m_process, nullptr, 0);
            return;
        }
        pollUntil({}, monotonicNow() + kLookEvery);
    }
}

}  // namespace nmc
