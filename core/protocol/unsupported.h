// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "protocol/commands.h"
#include "protocol/moduletype.h"

namespace nmc {

/// Why a command cannot be sent to a module (docs/family.md).
enum class Unsupported : std::uint8_t {
    UnknownModule,       ///< not isKnown()
    OtherChip,           ///< the command belongs to another type
    StatusItem,          ///< the command requests an item that the version does not send
    StopHere,            ///< version 2 and later
    AutoStop,            ///< a stop when home is found: version 3 and later
    Deadband,            ///< version 4 and later
    RelativeReset,       ///< CMC and SC
    RelativeMove,        ///< CMC and SC
    PathPoints,          ///< CMC and SC
    AdvancedFeatures,    ///< not before CMC
    FirstIoControl,      ///< versions 1 to 5
    IoFastPath,          ///< the bit in the first I/O Control: CMC only
    SetPosition,         ///< SC only
    StepMultiplier,      ///< SC only
    ScIoControl,         ///< SC only
    SavedConfiguration,  ///< SC only
    OutOfRange,          ///< a value beyond the version's range, or two that exclude each other
};

/// The reason why the module cannot take the command as it stands, or nothing when it can. The chip would
/// ignore such a command or take it for another.
[[nodiscard]] std::optional<Unsupported> unsupported(const ModuleIdentity& module,
                                                     const ServoCommand& command);
[[nodiscard]] std::optional<Unsupported> unsupported(const ModuleIdentity& module,
                                                     const StepperCommand& command);
[[nodiscard]] std::optional<Unsupported> unsupported(const ModuleIdentity& module, const IoCommand& command);

/// True when the module knows the command.
template <typename Command>
[[nodiscard]] bool takes(const ModuleIdentity& module, const Command& command) {
    return !unsupported(module, command);
}

/// A short sentence without a full stop, for logs and command lines.
[[nodiscard]] std::string_view toText(Unsupported reason);

}  // namespace nmc
