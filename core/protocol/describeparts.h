// SPDX-License-Identifier: MIT
#pragma once

// Parts of describe.cpp, and for it only: the commands that one chip has alone.

#include <string>
#include <string_view>

#include "protocol/iocommands.h"
#include "protocol/laterservocommands.h"
#include "protocol/servocommands.h"
#include "protocol/steppercommands.h"

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

/// "IO1 IO12" of the bits that are set.
[[nodiscard]] std::string pinNames(std::uint16_t pins, std::string_view none);

[[nodiscard]] std::string ownWords(const servo::LoadTrajectory& load);
[[nodiscard]] std::string ownWords(const servo::SetGain& gains);
[[nodiscard]] std::string ownWords(const servo::StopMotor& stop);
[[nodiscard]] std::string ownWords(const servo::IoControl& io);
[[nodiscard]] std::string ownWords(const servo::SetHoming& homing);
[[nodiscard]] std::string ownWords(const servo::ResetRelativeToHome& reset);
[[nodiscard]] std::string ownWords(const servo::SetPosition& set);
[[nodiscard]] std::string ownWords(const servo::ScIoControl& io);
[[nodiscard]] std::string ownWords(const servo::HardReset& reset);
[[nodiscard]] std::string ownWords(const servo::AddPathPoints& add);

[[nodiscard]] std::string ownWords(const stepper::LoadTrajectory& load);
[[nodiscard]] std::string ownWords(const stepper::SetParameters& parameters);
[[nodiscard]] std::string ownWords(const stepper::StopMotor& stop);
[[nodiscard]] std::string ownWords(const stepper::SetOutputs& outputs);
[[nodiscard]] std::string ownWords(const stepper::SetHoming& homing);

[[nodiscard]] std::string ownWords(const io::SetDirection& set);
[[nodiscard]] std::string ownWords(const io::SetPwm& set);
[[nodiscard]] std::string ownWords(const io::SetOutput& set);
[[nodiscard]] std::string ownWords(const io::SetSynchOutput& set);
[[nodiscard]] std::string ownWords(const io::SetTimerMode& set);

}  // namespace nmc::describe
