// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "base/strong.h"
#include "protocol/commandform.h"
#include "protocol/iocommands.h"
#include "protocol/laterservocommands.h"
#include "protocol/moduletype.h"
#include "protocol/servocommands.h"
#include "protocol/status.h"
#include "protocol/steppercommands.h"

namespace nmc {

// Commands that mean the same on several chips (DS-V 5.2, DS-S 5.1). Each struct describes one command and
// lists its contents in fields() (commandform.h).

/// Sets the position to 0, and on a PIC-SERVO the command position as well. Not allowed during a trapezoidal
/// move; on a PIC-STEP, not during any motion.
struct ResetPosition {
    static constexpr CommandCode kCode = CommandCode::ResetPosition;
    static void fields(auto& form, auto& /*c*/) { form.ignoreRest(1); }
    bool operator==(const ResetPosition&) const = default;
};

/// Sets a new individual address and group; the first one after a reset lowers ADDR_OUT.
struct SetAddress {
    BusAddress address;
    BusAddress group{0xFF};  ///< 0x80..0xFF
    bool leader = false;     ///< on the wire, bit 7 of the group byte is cleared
    static constexpr CommandCode kCode = CommandCode::SetAddress;
    static void fields(auto& form, auto& c) {
        form.number("address", c.address);
        form.group(c.group, c.leader);
    }
    bool operator==(const SetAddress&) const = default;
};

/// Sets the items of every reply from now on, including the reply to this command.
struct DefineStatus {
    StatusItems items;
    static constexpr CommandCode kCode = CommandCode::DefineStatus;
    static void fields(auto& form, auto& c) { form.items(c.items); }
    bool operator==(const DefineStatus&) const = default;
};

/// Requests items for this one reply.
struct ReadStatus {
    StatusItems items;
    static constexpr CommandCode kCode = CommandCode::ReadStatus;
    static void fields(auto& form, auto& c) { form.items(c.items); }
    bool operator==(const ReadStatus&) const = default;
};

/// Runs the trajectory loaded last.
struct StartMotion : CommandWithoutData<CommandCode::StartMotion> {};

/// Sent to a group of all modules without a leader, because a reply would come at the new rate.
struct SetBaud {
    std::uint8_t brd = 0;
    static constexpr CommandCode kCode = CommandCode::SetBaud;
    static void fields(auto& form, auto& c) { form.rate(c.brd); }
    bool operator==(const SetBaud&) const = default;
};

/// Sets home := position.
struct SaveAsHome : CommandWithoutData<CommandCode::SaveAsHome> {};

/// Does nothing but request a reply with the defined items.
struct Nop : CommandWithoutData<CommandCode::Nop> {};

/// Returns the module to its power-up state; there is no reply. Chips without a saved configuration ignore a
/// control byte.
struct HardReset {
    static constexpr CommandCode kCode = CommandCode::HardReset;
    static void fields(auto& form, auto& /*c*/) { form.ignoreRest(1); }
    bool operator==(const HardReset&) const = default;
};

/// First the commands of all PIC-SERVO versions, then those that only later versions know; takes() in
/// takes.h checks whether a module knows one.
using ServoCommand =
    std::variant<ResetPosition, SetAddress, DefineStatus, ReadStatus, servo::LoadTrajectory, StartMotion,
                 servo::SetGain, servo::StopMotor, servo::IoControl, servo::SetHoming, SetBaud,
                 servo::ClearStickyBits, SaveAsHome, Nop, HardReset, servo::ResetRelativeToHome,
                 servo::SetPosition, servo::ScIoControl, servo::AddPathPoints, servo::HardReset>;

using StepperCommand =
    std::variant<ResetPosition, SetAddress, DefineStatus, ReadStatus, stepper::LoadTrajectory, StartMotion,
                 stepper::SetParameters, stepper::StopMotor, stepper::SetOutputs, stepper::SetHoming, SetBaud,
                 SaveAsHome, Nop, HardReset>;

using IoCommand = std::variant<io::SetDirection, SetAddress, DefineStatus, ReadStatus, io::SetPwm,
                               io::SynchOutput, io::SetOutput, io::SetSynchOutput, io::SetTimerMode, SetBaud,
                               io::SynchInput, Nop, HardReset>;

/// Decode the bytes as that version does, ignoring fields that only later versions read. An unknown version
/// is treated as one from the first data sheet. Nothing is returned for what is no command of the module.
[[nodiscard]] std::optional<ServoCommand> decodeServoCommand(const ModuleIdentity& module,
                                                             const Payload& payload);
[[nodiscard]] std::optional<StepperCommand> decodeStepCommand(const Payload& payload);
[[nodiscard]] std::optional<IoCommand> decodeIoCommand(const Payload& payload);

/// Calls the function with what one of these returns for a module of that type.
template <typename Function>
[[nodiscard]] auto withDecoded(const ModuleIdentity& module, const Payload& payload, const Function& use) {
    if (module.type == ModuleType::Stepper)
        return use(decodeStepCommand(payload));
    if (module.type == ModuleType::Io)
        return use(decodeIoCommand(payload));
    return use(decodeServoCommand(module, payload));
}

template <typename... Commands>
[[nodiscard]] Payload encode(const std::variant<Commands...>& command) {
    return std::visit([](const auto& c) { return encode(c); }, command);
}

}  // namespace nmc
