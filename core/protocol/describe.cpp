// SPDX-License-Identifier: MIT
#include "protocol/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "protocol/baud.h"
#include "protocol/commands.h"
#include "protocol/commandtable.h"
#include "protocol/describeparts.h"
#include "protocol/frame.h"

namespace nmc {

using namespace describe;

namespace {

std::string itemNames(ModuleType type, StatusItems items) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(type))
        phrases.addIf(items.has(row.bit), row.name);
    // Bits 6 and 7 are "clear to zero".
    const auto beyond = static_cast<std::uint8_t>(items.mask() & ~StatusItems::All);
    if (beyond != 0)
        phrases.add("undefined " + toHex(std::array{beyond}));
    return phrases.empty() ? "status byte only" : phrases.text();
}

// What follows the name of the command; empty when the name says it all.

std::string meaning(const SetAddress& c, ModuleType) {
    return Phrases()
        .add("address " + std::to_string(c.address.value()))
        .add("group " + toHex(std::array{c.group.value()}))
        .add(c.leader ? "leader" : "member")
        .text();
}
std::string meaning(const DefineStatus& c, ModuleType type) {
    return itemNames(type, c.items);
}
std::string meaning(const ReadStatus& c, ModuleType type) {
    return itemNames(type, c.items);
}
std::string meaning(const SetBaud& c, ModuleType) {
    for (const BaudRow& row : kBaudRows)
        if (c.brd == row.brd || c.brd == row.dataSheetBrd)
            return "code " + std::to_string(c.brd) + ", " + std::to_string(row.nominal) + " Bd";
    return "code " + std::to_string(c.brd) + ", " + std::to_string(std::lround(realRate(c.brd))) + " Bd";
}
std::string meaning(const ResetPosition&, ModuleType) {
    return {};
}
std::string meaning(const StartMotion&, ModuleType) {
    return {};
}
std::string meaning(const SaveAsHome&, ModuleType) {
    return {};
}
std::string meaning(const Nop&, ModuleType) {
    return {};
}
std::string meaning(const HardReset&, ModuleType) {
    return {};
}
std::string meaning(const servo::ClearStickyBits&, ModuleType) {
    return {};
}
std::string meaning(const servo::LoadTrajectory& c, ModuleType) {
    return servoTrajectory(c);
}
std::string meaning(const servo::SetGain& c, ModuleType) {
    return servoGains(c);
}
std::string meaning(const servo::StopMotor& c, ModuleType) {
    return servoStop(c);
}
std::string meaning(const servo::IoControl& c, ModuleType) {
    return servoIo(c);
}
std::string meaning(const servo::SetHoming& c, ModuleType) {
    return servoHoming(c);
}
std::string meaning(const step::LoadTrajectory& c, ModuleType) {
    return stepTrajectory(c);
}
std::string meaning(const step::SetParameters& c, ModuleType) {
    return stepParameters(c);
}
std::string meaning(const step::StopMotor& c, ModuleType) {
    return stepStop(c);
}
std::string meaning(const step::SetOutputs& c, ModuleType) {
    return stepOutputs(c);
}
std::string meaning(const step::SetHoming& c, ModuleType) {
    return stepHoming(c);
}

template <typename Command>
std::optional<std::string> meaningOf(const tl::expected<Command, CommandError>& command, ModuleType type) {
    if (!command)
        return std::nullopt;
    return std::visit([type](const auto& c) { return meaning(c, type); }, *command);
}

std::string describePayload(ModuleType type, const Payload& payload) {
    // A module of another type is only ever sent what all types have in common.
    const ModuleType chip = type == ModuleType::Step ? ModuleType::Step : ModuleType::Servo;
    const auto row = findCommand(chip, payload.code);
    const std::string data = payload.data.empty() ? "no data" : toHex(payload.data);
    if (!row)
        return "command " + std::to_string(static_cast<int>(payload.code)) +
               ", which the chip does not have: " + data;
    const auto text = chip == ModuleType::Step ? meaningOf(decodeStepCommand(payload), chip)
                                               : meaningOf(decodeServoCommand(payload), chip);
    const std::string name(row->name);
    if (!text)
        return name + ", not as the data sheet has it: " + data;
    return text->empty() ? name : name + ": " + *text;
}

/// Takes the packet that the bytes begin with, as far as it goes.
ByteSpan firstPacket(ByteSpan bytes) {
    if (bytes.size() < 3)
        return bytes;
    const std::size_t length = (bytes[2] >> 4U) + std::size_t{4};
    return bytes.first(std::min(length, bytes.size()));
}

std::string describePacket(ModuleType type, ByteSpan packet) {
    const auto frame = parsePacket(packet);
    if (frame)
        return describePayload(type, frame->payload);
    switch (frame.error()) {
        case FrameError::TooShort:
        case FrameError::LengthMismatch:
            return "cut packet";
        case FrameError::Checksum:
            return "packet with a wrong sum";
        case FrameError::NoHeader:
            break;
    }
    return "no packet";
}

}  // namespace

std::string describeCommand(ModuleType type, ByteSpan bytes) {
    Phrases parts("; ");
    while (!bytes.empty()) {
        // Whatever stands in front of a header is skipped by the modules.
        const auto header = std::find(bytes.begin(), bytes.end(), kHeader);
        const auto before = static_cast<std::size_t>(header - bytes.begin());
        if (before > 0) {
            const ByteSpan skipped = bytes.first(before);
            const bool nulls =
                std::all_of(skipped.begin(), skipped.end(), [](std::uint8_t b) { return b == 0; });
            parts.add(counted(before, nulls ? "null" : "byte") + (nulls ? "" : " outside a packet"));
            bytes = bytes.subspan(before);
        } else {
            const ByteSpan packet = firstPacket(bytes);
            parts.add(describePacket(type, packet));
            bytes = bytes.subspan(packet.size());
        }
    }
    return parts.text();
}

}  // namespace nmc
