// SPDX-License-Identifier: MIT
#include "link/connection/wakeup.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

namespace nmc {

Wakeup::Wakeup() : m_fd(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (!m_fd.valid())
        throw std::system_error(errno, std::generic_category(), "eventfd");
}

void Wakeup::wake() const {
    const std::uint64_t one = 1;
    // write() fails only when 2^64 - 2 wakes are pending, and then the reader is awake already.
    [[maybe_unused]] const auto written = ::write(fd(), &one, sizeof one);
}

void Wakeup::reset() const {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto got = ::read(fd(), &count, sizeof count);
}

}  // namespace nmc
