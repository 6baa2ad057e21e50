// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <variant>

#include "protocol/commands.h"

namespace nmc {

/// A command for any chip type.
using ModuleCommand = std::variant<ServoCommand, StepperCommand, IoCommand>;

/// Calls `function` with the command's struct, whatever the chip.
template <typename Function>
decltype(auto) visitCommand(Function&& function, const ModuleCommand& command) {
    return std::visit([&](const auto& chip) -> decltype(auto) { return std::visit(function, chip); },
                      command);
}

/// True if `command` is a `Command`, whatever the chip.
template <typename Command>
[[nodiscard]] bool is(const ModuleCommand& command) {
    return visitCommand([](const auto& own) { return std::is_same_v<std::decay_t<decltype(own)>, Command>; },
                        command);
}

[[nodiscard]] Payload payloadOf(const ModuleCommand& command);

}  // namespace nmc
