// SPDX-License-Identifier: GPL-3.0-or-later
// A panel reduced to its port and its guardian, which carries out commands line by line:
//   guardhost TERMINAL NMCGUARD REPORT
// While it is "steady", its beats are an hour ahead, so that the guardian does not act because the computer
// gave this program no time; while it is "timely", they are those of a panel. It does without Qt, so that the
// guardian's tests can, too, and is so small that it can be cut off at any byte.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "link/clock.h"
#include "link/guardian/guardian.h"
#include "link/ports/linerate.h"

namespace {

using namespace nmc;

std::vector<std::uint8_t> bytesIn(std::istream& words) {
    std::vector<std::uint8_t> bytes;
    unsigned byte = 0;
    while (words >> std::hex >> byte)
        bytes.push_back(static_cast<std::uint8_t>(byte));
    return bytes;
}

/// How far ahead a beat is that no pause of this process makes too old.
constexpr Duration kSteady = std::chrono::hours(1);

class Host {
public:
    Host(const char* terminal, GuardianPlace place)
        : m_port(::open(terminal, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)), m_place(std::move(place)) {}

    /// Takes the port as SerialTransport does.
    [[nodiscard]] bool hasPort() const {
        return m_port >= 0 && ::flock(m_port, LOCK_EX | LOCK_NB) == 0 && ::ioctl(m_port, TIOCEXCL) == 0;
    }
    void run() {
        std::string pending;
        std::array<char, 256> buffer{};
        while (true) {
            if (m_guardian && m_beating)
                beat();
            std::array<pollfd, 1> input{{{STDIN_FILENO, POLLIN, 0}}};
            if (pollUntil(input, monotonicNow() + std::chrono::milliseconds(10)) <= 0)
                continue;
            const auto got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
            if (got <= 0)
                return;
            pending.append(buffer.data(), static_cast<std::size_t>(got));
            for (std::size_t end = 0; (end = pending.find('\n')) != std::string::npos;) {
                std::istringstream words(pending.substr(0, end));
                pending.erase(0, end + 1);
                std::cout << obey(words) << std::endl;
            }
        }
    }

private:
    void beat() {
        m_stopped = m_guardian->beat(monotonicNow() + (m_steady ? kSteady : Duration::zero())) || m_stopped;
    }

    std::string arm() { return m_guardian->arm(m_burst, m_baud, m_beating) ? "ok" : "refused"; }

    std::string obey(std::istringstream& words) {
        std::string verb;
        words >> verb;
        if (verb == "start") {
            auto guardian = Guardian::start(m_port, m_place);
            if (!guardian)
                return "problem " + std::to_string(static_cast<int>(guardian.error()));
            m_guardian.emplace(std::move(*guardian));
            return std::to_string(m_guardian->process());
        }
        if (verb == "arm") {
            words >> m_baud;
            m_burst = bytesIn(words);
            return arm();
        }
        if (verb == "move" || verb == "rest") {
            m_beating = verb == "move";
            beat();
            return arm();
        }
        if (verb == "steady" || verb == "timely") {
            m_steady = verb == "steady";
            beat();
            // The beginning of a motion wakes the guardian, which otherwise sleeps until the beat before is
            // too old.
            m_guardian->arm(m_burst, m_baud, false);
            return arm();
        }
        if (verb == "neglect")
            m_beating = false;
        if (verb == "write") {
            const auto bytes = bytesIn(words);
            return std::to_string(::write(m_port, bytes.data(), bytes.size()));
        }
        if (verb == "rate") {
            std::uint32_t baud = 0;
            words >> baud;
            setLineRate(m_port, baud);
        }
        if (verb == "stopped?") {
            beat();
            return std::exchange(m_stopped, false) ? "yes" : "no";
        }
        if (verb == "alive?")
            return m_guardian->alive() ? "yes" : "no";
        if (verb == "unlock")
            ::flock(m_port, LOCK_UN);
        if (verb == "end")
            m_guardian.reset();
        if (verb == "abort")
            std::abort();
        return "ok";
    }

    int m_port;
    GuardianPlace m_place;
    std::optional<Guardian> m_guardian;
    std::vector<std::uint8_t> m_burst;
    std::uint32_t m_baud = 0;
    bool m_beating = false;
    bool m_steady = false;
    bool m_stopped = false;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4)
        return 2;
    // The guardian must inherit neither this descriptor, as any other program would, nor the signal mask.
    [[maybe_unused]] const int leak = ::open("/dev/null", O_RDONLY);
    sigset_t mask;
    ::sigemptyset(&mask);
    ::sigaddset(&mask, SIGUSR1);
    ::sigprocmask(SIG_BLOCK, &mask, nullptr);
    Host host(argv[1], {argv[2], argv[3]});
    if (!host.hasPort()) {
        std::cout << "busy" << std::endl;
        return 3;
    }
    std::cout << "ready" << std::endl;
    host.run();
    return 0;
}
