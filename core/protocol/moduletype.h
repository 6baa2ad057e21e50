// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace nmc {

/// The type byte of status item 5. Any other value is a module this program does not know.
enum class ModuleType : std::uint8_t { Servo = 0, Adc = 1, Io = 2, Step = 3 };

/// What a module says it is (status item 5).
struct ModuleIdentity {
    ModuleType type = ModuleType::Servo;
    std::uint8_t version = 0;
    bool operator==(const ModuleIdentity&) const = default;
};

}  // namespace nmc
