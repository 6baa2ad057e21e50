// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simprocess.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace nmc::testing_support {

SimProcess::SimProcess(const std::string& chain, const std::vector<std::string>& options,
                       const std::string& errors) {
    std::vector<std::string> words{NMCSIM_PATH, "--chain", chain};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);

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
    const std::string ready = answer();
    if (ready.rfind("ready ", 0) != 0)
        throw std::runtime_error("nmcsim said: " + ready);
    m_terminal = ready.substr(6);
}

SimProcess::~SimProcess() {
    std::fputs("quit\n", m_to);
    std::fclose(m_to);
    std::fclose(m_from);
    ::waitpid(m_process, nullptr, 0);
}

nlohmann::json SimProcess::control(const std::string& line) {
    std::fprintf(m_to, "%s\n", line.c_str());
    std::fflush(m_to);
    return nlohmann::json::parse(answer());
}

std::string SimProcess::answer() {
    std::string line;
    for (int c = 0; (c = std::fgetc(m_from)) != '\n';) {
        if (c == EOF)
            throw std::runtime_error("nmcsim has gone");
        line += static_cast<char>(c);
    }
    return line;
}

}  // namespace nmc::testing_support
