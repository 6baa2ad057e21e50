// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// One of our programs in its own process, which answers lines with lines. Uses only POSIX; throws on
/// failure.
class LineProcess {
public:
    /// `errors`: file for its standard error; if empty, it shares that of the test.
    explicit LineProcess(std::vector<std::string> words, const std::string& errors = {});
    /// Closes its input, and waits for it to end.
    ~LineProcess();
    LineProcess(const LineProcess&) = delete;
    LineProcess& operator=(const LineProcess&) = delete;

    void tell(const std::string& line);
    /// The next line of its output.
    std::string answer();
    /// Waits for it to end, and returns how it ended, as waitpid(2) does.
    int wait();
    [[nodiscard]] pid_t pid() const { return m_process; }

private:
    pid_t m_process = -1;
    bool m_ended = false;
    std::FILE* m_to = nullptr;
    std::FILE* m_from = nullptr;
};

}  // namespace nmc::testing_support
