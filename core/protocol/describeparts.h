// SPDX-License-Identifier: MIT
#pragma once

// Parts of describe.cpp, and for it only: the commands that one chip has alone.

#include <string>
#include <string_view>

#include "protocol/servocommands.h"
#include "protocol/stepcommands.h"

namespace nmc::describe {

/// Words with a separator between them.
class Phrases {
public:
    explicit Phrases(std::string_view separator = ", ") : m_separator(separator) {}

    Phrases& add(std::string_view phrase);
    Phrases& addIf(bool condition, std::string_view phrase) { return condition ? add(phrase) : *this; }
    [[nodiscard]] bool empty() const { return m_text.empty(); }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    std::string m_text;
    std::string_view m_separator;
};

/// "1 null", "16 nulls"
[[nodiscard]] std::string counted(std::size_t count, std::string_view thing);

[[nodiscard]] std::string servoTrajectory(const servo::LoadTrajectory& load);
[[nodiscard]] std::string servoGains(const servo::SetGain& gains);
[[nodiscard]] std::string servoStop(const servo::StopMotor& stop);
[[nodiscard]] std::string servoIo(const servo::IoControl& io);
[[nodiscard]] std::string servoHoming(const servo::SetHoming& homing);

[[nodiscard]] std::string stepTrajectory(const step::LoadTrajectory& load);
[[nodiscard]] std::string stepParameters(const step::SetParameters& parameters);
[[nodiscard]] std::string stepStop(const step::StopMotor& stop);
[[nodiscard]] std::string stepOutputs(const step::SetOutputs& outputs);
[[nodiscard]] std::string stepHoming(const step::SetHoming& homing);

}  // namespace nmc::describe
