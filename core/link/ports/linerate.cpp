// SPDX-License-Identifier: MIT
#include "link/ports/linerate.h"

// This is the kernel's header: termios.h of the C library has named rates only, and the two cannot be
// included together.
#include <asm/termbits.h>
#include <sys/ioctl.h>

#include <cstdlib>

namespace nmc {

std::optional<std::uint32_t> lineRate(int fd) {
    termios2 settings{};
    if (::ioctl(fd, TCGETS2, &settings) != 0)
        return std::nullopt;
    return settings.c_ospeed;
}

bool setLineRate(int fd, std::uint32_t baud) {
    termios2 settings{};
    if (::ioctl(fd, TCGETS2, &settings) != 0)
        return false;
    settings.c_cflag &= ~static_cast<tcflag_t>(CBAUD | CBAUD << IBSHIFT);
    settings.c_cflag |= BOTHER;
    settings.c_ispeed = settings.c_ospeed = baud;
    return ::ioctl(fd, TCSETS2, &settings) == 0;
}

bool rateIsGoodEnough(std::uint32_t wanted, std::uint32_t real) {
    constexpr std::int64_t kPercent = 2;
    return std::abs(std::int64_t{real} - wanted) * 100 <= std::int64_t{wanted} * kPercent;
}

}  // namespace nmc
