// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simprocess.h"

#include <stdexcept>

namespace nmc::testing_support {

namespace {

std::vector<std::string> commandLine(const std::string& chain, const std::vector<std::string>& options) {
    std::vector<std::string> words{NMCSIM_PATH, "--chain", chain};
    words.insert(words.end(), options.begin(), options.end());
    return words;
}

}  // namespace

SimProcess::SimProcess(const std::string& chain, const std::vector<std::string>& options,
                       const std::string& errors)
    : m_process(commandLine(chain, options), errors) {
    const std::string ready = m_process.answer();
    if (ready.rfind("ready ", 0) != 0)
        throw std::runtime_error("nmcsim said: " + ready);
    m_terminal = ready.substr(6);
}

SimProcess::~SimProcess() {
    m_process.tell("quit");
}

nlohmann::json SimProcess::control(const std::string& line) {
    m_process.tell(line);
    return nlohmann::json::parse(m_process.answer());
}

}  // namespace nmc::testing_support
