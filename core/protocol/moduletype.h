// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace nmc {

/// Longest chain on one RS-485 line (DS-V 6.1).
inline constexpr std::uint8_t kMaxModules = 32;

/// The type byte of status item 5. A module with any other value is unknown to this program.
enum class ModuleType : std::uint8_t { Servo = 0, Adc = 1, Io = 2, Stepper = 3 };

/// The name of the family's member; empty for any other type.
[[nodiscard]] constexpr std::string_view familyName(ModuleType type) {
    switch (type) {
        case ModuleType::Servo:
            return "PIC-SERVO";
        case ModuleType::Adc:
            return "PIC-ADC";
        case ModuleType::Io:
            return "PIC-I/O";
        case ModuleType::Stepper:
            return "PIC-STEP";
    }
    return {};
}

/// The type and version that a module reports (status item 5).
struct ModuleIdentity {
    ModuleType type = ModuleType::Servo;
    std::uint8_t version = 0;
    bool operator==(const ModuleIdentity&) const = default;
};

/// Stands for a module that has not reported its type and version.
inline constexpr ModuleIdentity kUnheardModule{static_cast<ModuleType>(0xFF), 0};

/// True for types that can be stopped with a command defined here. What other types do with the same bytes is
/// unknown.
[[nodiscard]] constexpr bool hasStop(ModuleType type) {
    return type == ModuleType::Servo || type == ModuleType::Stepper || type == ModuleType::Io;
}

/// True for members of the family whose data sheet this program follows: PIC-SERVO v1 to v4, PIC-STEP v1.
/// Other modules may interpret the same bytes differently (protocol.md 5).
[[nodiscard]] constexpr bool hasDataSheet(const ModuleIdentity& module) {
    return (module.type == ModuleType::Servo && module.version >= 1 && module.version <= 4) ||
           (module.type == ModuleType::Stepper && module.version == 1);
}

/// The first PIC-SERVO with a path buffer and a reported position error (PIC-SERVO CMC).
inline constexpr std::uint8_t kPathVersion = 5;
/// PIC-SERVO SC.
inline constexpr std::uint8_t kScVersion = 10;

[[nodiscard]] constexpr bool isSc(const ModuleIdentity& module) {
    return module.type == ModuleType::Servo && module.version == kScVersion;
}
/// True for a PIC-SERVO with items 6 and 7 and Add Path Points: CMC or SC.
[[nodiscard]] constexpr bool hasPathBuffer(const ModuleIdentity& module) {
    return isSc(module) || (module.type == ModuleType::Servo && module.version == kPathVersion);
}

/// True for members whose commands and status items are defined here: those with a data sheet, PIC-SERVO CMC
/// and SC, PIC-I/O (docs/family.md).
[[nodiscard]] constexpr bool isKnown(const ModuleIdentity& module) {
    return hasDataSheet(module) || hasPathBuffer(module) ||
           (module.type == ModuleType::Io && module.version == 1);
}

}  // namespace nmc
