// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/port.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <stdexcept>

namespace nmc::testing_support {

Port::Port(const std::string& path) : m_fd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (m_fd < 0)
        throw std::runtime_error("no terminal " + path);
}

Port::~Port() {
    ::close(m_fd);
}

void Port::setRate(speed_t rate) {
    termios settings{};
    ::tcgetattr(m_fd, &settings);
    ::cfmakeraw(&settings);
    ::cfsetspeed(&settings, rate);
    if (::tcsetattr(m_fd, TCSADRAIN, &settings) != 0)
        throw std::runtime_error("tcsetattr");
}

void Port::setRateAnew(speed_t rate) {
    termios settings{};
    settings.c_cflag = CS8 | CREAD | CLOCAL;
    settings.c_cc[VMIN] = 1;
    ::cfsetspeed(&settings, rate);
    ::tcdrain(m_fd);
    if (::tcsetattr(m_fd, TCSANOW, &settings) != 0)
        throw std::runtime_error("tcsetattr");
}

speed_t Port::rate() const {
    termios settings{};
    ::tcgetattr(m_fd, &settings);
    return ::cfgetospeed(&settings);
}

void Port::write(const std::vector<std::uint8_t>& bytes) {
    if (::write(m_fd, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
        throw std::runtime_error("write");
}

std::vector<std::uint8_t> Port::read(std::size_t most, int ms) {
    pollfd readable{m_fd, POLLIN, 0};
    if (::poll(&readable, 1, ms) <= 0)
        return {};
    std::vector<std::uint8_t> bytes(most);
    const auto got = ::read(m_fd, bytes.data(), most);
    if (got <= 0)
        throw std::runtime_error("read");
    bytes.resize(static_cast<std::size_t>(got));
    return bytes;
}

void Port::flush() {
    ::tcflush(m_fd, TCIFLUSH);
}

}  // namespace nmc::testing_support
