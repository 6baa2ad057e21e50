// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/terminalrig.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "tests/support/patience.h"

namespace nmc::conformance {

namespace {

using testing_support::kPatienceMs;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what);
}

std::vector<std::string> stepped(std::vector<std::string> options) {
    options.push_back("--stepped");
    return options;
}

}  // namespace

TerminalRig::TerminalRig(const std::string& chain, const std::vector<std::string>& options)
    : m_simulator(chain, stepped(options)),
      m_port(::open(m_simulator.terminal().c_str(), O_RDWR | O_NOCTTY)) {
    if (m_port < 0)
        fail("no terminal " + m_simulator.terminal());
    setBaud(19'200);
}

TerminalRig::~TerminalRig() {
    if (m_port >= 0)
        ::close(m_port);
}

void TerminalRig::setBaud(unsigned baud) {
    static const std::map<unsigned, speed_t> kSpeeds{{9'600, B9600},     {19'200, B19200},
                                                     {38'400, B38400},   {57'600, B57600},
                                                     {115'200, B115200}, {230'400, B230400}};
    // What has been sent leaves at the old rate.
    waitUntilHeard();
    termios settings{};
    ::tcgetattr(m_port, &settings);
    ::cfmakeraw(&settings);
    ::cfsetspeed(&settings, kSpeeds.at(baud));
    if (::tcsetattr(m_port, TCSANOW, &settings) != 0)
        fail("tcsetattr");
    // The simulator looks at the rate before it answers, so that what is sent next is sent at the new one.
    control("time");
}

void TerminalRig::send(const Bytes& bytes) {
    if (::write(m_port, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        fail("write");
    m_sent += bytes.size();
    waitUntilHeard();
}

/// The kernel hands the bytes over in a thread of its own.
void TerminalRig::waitUntilHeard() {
    while (control("time")["received"] != m_sent) {
    }
}

Bytes TerminalRig::wait(Duration time) {
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "advance %.9f", toSeconds(time));
    const std::uint64_t sent = control(line.data())["sent"];
    Bytes bytes(sent - m_received);
    for (std::size_t got = 0; got < bytes.size();) {
        pollfd readable{m_port, POLLIN, 0};
        if (::poll(&readable, 1, kPatienceMs) != 1)
            fail("the terminal lost bytes");
        const auto n = ::read(m_port, bytes.data() + got, bytes.size() - got);
        if (n <= 0)
            fail("read");
        got += static_cast<std::size_t>(n);
    }
    m_received = sent;
    return bytes;
}

}  // namespace nmc::conformance
