// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/conformance/terminalrig.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <map>
#include <stdexcept>

namespace nmc::conformance {

namespace {

constexpr int kPatienceMs = 10'000;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what);
}

}  // namespace

TerminalRig::TerminalRig(const std::string& chain, const std::vector<std::string>& options) {
    std::vector<std::string> words{NMCSIM_PATH, "--stepped", "--chain", chain};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);

    std::array<int, 2> in{};
    std::array<int, 2> out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0)
        fail("no pipe");
    m_process = ::fork();
    if (m_process == 0) {
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    m_toSimulator = ::fdopen(in[1], "w");
    m_fromSimulator = ::fdopen(out[0], "r");
    const std::string ready = answer();
    if (ready.rfind("ready ", 0) != 0)
        fail("nmcsim said: " + ready);
    m_port = ::open(ready.substr(6).c_str(), O_RDWR | O_NOCTTY);
    if (m_port < 0)
        fail("no terminal " + ready);
    setBaud(19'200);
}

TerminalRig::~TerminalRig() {
    if (m_port >= 0)
        ::close(m_port);
    std::fputs("quit\n", m_toSimulator);
    std::fclose(m_toSimulator);
    std::fclose(m_fromSimulator);
    ::waitpid(m_process, nullptr, 0);
}

void TerminalRig::setBaud(unsigned baud) {
    static const std::map<unsigned, speed_t> kSpeeds{
        {9'600, B9600}, {19'200, B19200}, {38'400, B38400}, {57'600, B57600}, {115'200, B115200}};
    // What has been sent leaves at the old rate.
    waitUntilHeard();
    termios settings{};
    ::tcgetattr(m_port, &settings);
    ::cfmakeraw(&settings);
    ::cfsetspeed(&settings, kSpeeds.at(baud));
    if (::tcsetattr(m_port, TCSANOW, &settings) != 0)
        fail("tcsetattr");
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

nlohmann::json TerminalRig::control(const std::string& line) {
    std::fprintf(m_toSimulator, "%s\n", line.c_str());
    std::fflush(m_toSimulator);
    return nlohmann::json::parse(answer());
}

std::string TerminalRig::answer() {
    std::string line;
    for (int c = 0; (c = std::fgetc(m_fromSimulator)) != '\n';) {
        if (c == EOF)
            fail("nmcsim has gone");
        line += static_cast<char>(c);
    }
    return line;
}

}  // namespace nmc::conformance
