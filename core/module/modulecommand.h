// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <variant>

#include "base/overloaded.h"
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

/// The command if it is a `Command`, whatever the chip; otherwise null.
template <typename Command>
[[nodiscard]] const Command* getIf(const ModuleCommand& command) {
    return visitCommand(
        []<typename Own>(const Own& own) -> const Command* {
            if constexpr (std::is_same_v<Own, Command>)
                return &own;
            else
                return nullptr;
        },
        command);
}
template <typename Command>
[[nodiscard]] bool is(const ModuleCommand& command) {
    return getIf<Command>(command) != nullptr;
}

/// The command in the form for a chip: several chips have some commands in common.
template <typename Command>
[[nodiscard]] ModuleCommand forChip([[maybe_unused]] ModuleType chip, const Command& command) {
    if constexpr (In<Command, StepperCommand>)
        if (chip == ModuleType::Stepper)
            return StepperCommand(command);
    if constexpr (In<Command, IoCommand>)
        if (chip == ModuleType::Io)
            return IoCommand(command);
    if constexpr (In<Command, ServoCommand>)
        return ServoCommand(command);
    else if constexpr (In<Command, StepperCommand>)
        return StepperCommand(command);
    else
        return IoCommand(command);
}
[[nodiscard]] inline ModuleCommand forChip(ModuleType /*chip*/, const ModuleCommand& command) {
    return command;
}

[[nodiscard]] inline Payload payloadOf(const ModuleCommand& command) {
    return visitCommand([](const auto& own) { return encode(own); }, command);
}

}  // namespace nmc
