// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/lineprocess.h"

namespace nmc::testing_support {

/// The real nmcsim in its own process, with its control lines. Uses only POSIX; throws on failure.
class SimProcess {
public:
    /// `errors`: file for its standard error; if empty, it shares that of the test.
    explicit SimProcess(const std::string& chain, const std::vector<std::string>& options = {},
                        const std::string& errors = {});
    ~SimProcess();
    SimProcess(const SimProcess&) = delete;
    SimProcess& operator=(const SimProcess&) = delete;

    /// The terminal to open.
    [[nodiscard]] const std::string& terminal() const { return m_terminal; }
    nlohmann::json control(const std::string& line);
    nlohmann::json state(int module) { return control("state " + std::to_string(module)); }
    [[nodiscard]] pid_t pid() const { return m_process.pid(); }

private:
    LineProcess m_process;
    std::string m_terminal;
};

}  // namespace nmc::testing_support
