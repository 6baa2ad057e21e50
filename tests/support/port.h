// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <termios.h>

#include <cstdint>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// A serial port as any host program opens one. Nothing but POSIX; throws when it fails.
class Port {
public:
    explicit Port(const std::string& path);
    ~Port();
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;

    /// Raw, at `rate`; what was written before has left.
    void setRate(speed_t rate);
    /// The same by settings made from nothing, every flag of them, as many programs do it.
    void setRateAnew(speed_t rate);
    [[nodiscard]] speed_t rate() const;
    void write(const std::vector<std::uint8_t>& bytes);
    /// What there is, at most `most` bytes; waits for the first up to `ms`.
    std::vector<std::uint8_t> read(std::size_t most, int ms);
    /// Throws away what has come and was not read.
    void flush();

private:
    int m_fd;
};

}  // namespace nmc::testing_support
