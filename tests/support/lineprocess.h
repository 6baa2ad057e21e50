// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace nmc::testing_support {

/// A program of ours in a process of its own that answers lines with lines. Nothing but POSIX; throws when it
/// fails.
class LineProcess {
public:
    /// `errors`: a file for what it says on standard error; empty: with ours.
    explicit LineProcess(std::vector<std::string> words, const std::string& errors = {});
    /// Closes its input, and waits for its end.
    ~LineProcess();
    LineProcess(const LineProcess&) = delete;
    LineProcess& operator=(const LineProcess&) = delete;

    void tell(const std::string& line);
    /// The next line of its output.
    std::string answer();
    /// Waits for its end, and tells how it ended, as waitpid(2) does.
    int wait();
    [[nodiscard]] pid_t pid() const { return m_process; }

private:
    pid_t m_process = -1;
    bool m_ended = false;
    std::FILE* m_to = nullptr;
    std::FILE* m_from = nullptr;
};

}  // namespace nmc::testing_support
