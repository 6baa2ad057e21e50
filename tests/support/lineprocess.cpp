// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/lineprocess.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <utility>

namespace nmc::testing_support {

LineProcess::LineProcess(std::vector<std::string> words, const std::string& errors) {
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    std::signal(SIGPIPE, SIG_IGN);  // the program may end before it has read everything

    std::array<int, 2> in{};
    std::array<int, 2> out{};
    if (::pipe2(in.data(), O_CLOEXEC) != 0 || ::pipe2(out.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe");
    m_process = ::fork();
    if (m_process == 0) {
        ::dup2(in[0], STDIN_FILENO);
        ::dup2(out[1], STDOUT_FILENO);
        if (!errors.empty())
            ::dup2(::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, S_IRUSR | S_IWUSR), STDERR_FILENO);
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
    ::close(in[0]);
    ::close(out[1]);
    m_to = ::fdopen(in[1], "w");
    m_from = ::fdopen(out[0], "r");
}

LineProcess::~LineProcess() {
    std::fclose(m_to);
    std::fclose(m_from);
    wait();
}

void LineProcess::tell(const std::string& line) {
    std::fprintf(m_to, "%s\n", line.c_str());
    std::fflush(m_to);
}

std::string LineProcess::answer() {
    std::string line;
    for (int c = 0; (c = std::fgetc(m_from)) != '\n';) {
        if (c == EOF)
            throw std::runtime_error("the program has gone");
        line += static_cast<char>(c);
    }
    return line;
}

int LineProcess::wait() {
    int status = 0;
    if (!std::exchange(m_ended, true))
        ::waitpid(m_process, &status, 0);
    return status;
}

}  // namespace nmc::testing_support
