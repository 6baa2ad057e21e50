// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <termios.h>

#include <cstdint>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// A serial port, opened as any host program does it. Uses only POSIX; throws on failure.
class Port {
public:
    explicit Port(const std::string& path);
    ~Port();
    Port(const Port&) = delete;
    Port& operator=(const Port&) = delete;

    /// Sets raw mode and `rate`, after what was written has left.
    void setRate(speed_t rate);
    /// Like setRate(), but with settings built from scratch, including every flag, as many programs do it.
    void setRateAnew(speed_t rate);
    [[nodiscard]] speed_t rate() const;
    void write(const std::vector<std::uint8_t>& bytes);
    /// Returns the bytes that are there, at most `most`; waits up to `ms` for the first.
    std::vector<std::uint8_t> read(std::size_t most, int ms);
    /// Discards what has arrived and was not read.
    void flush();

private:
    int m_fd;
};

}  // namespace nmc::testing_support
