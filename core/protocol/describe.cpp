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

using Module = const ModuleIdentity&;

std::string itemNames(Module module, StatusItems items) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(module))
        phrases.addIf(items.has(row.bit), row.name);
    // Bits that the chip has no item for are "clear to zero".
    const auto beyond = static_cast<std::uint8_t>(items.mask() & ~allItems(module).mask());
    if (beyond != 0)
        phrases.add("undefined " + toHex(std::array{beyond}));
    return phrases.empty() ? "status byte only" : phrases.text();
}

// What follows the name of the command; empty when the name says it all.

std::string meaning(const SetAddress& c, Module) {
    return Phrases()
        .add("address " + std::to_string(c.address.value()))
        .add("group " + toHex(std::array{c.group.value()}))
        .add(c.leader ? "leader" : "member")
        .text();
}
std::string meaning(const DefineStatus& c, Module module) {
    return itemNames(module, c.items);
}
std::string meaning(const ReadStatus& c, Module module) {
    return itemNames(module, c.items);
}
std::string meaning(const SetBaud& c, Module) {
    for (const BaudRow& row : kBaudRows)
        if (c.brd == row.brd || c.brd == row.dataSheetBrd)
            return "code " + std::to_string(c.brd) + ", " + std::to_string(row.nominal) + " Bd";
    return "code " + std::to_string(c.brd) + ", " + std::to_string(std::lround(realRate(c.brd))) + " Bd";
}
/// A command that one chip has alone has its words in describeparts.h, or its name says it all.
template <typename Command>
std::string meaning(const Command& c, Module) {
    if constexpr (requires { ownWords(c); })
        return ownWords(c);
    return {};
}

template <typename... Commands>
std::string sentence(Module module, const std::variant<Commands...>& command) {
    const auto row = findCommand(module, encode(command).code);
    const std::string name(row ? row->name : "");
    const std::string text = std::visit([&module](const auto& c) { return meaning(c, module); }, command);
    return text.empty() ? name : name + ": " + text;
}

template <typename Command>
std::optional<std::string> sentenceOf(Module module, const tl::expected<Command, CommandError>& command) {
    return command ? std::optional(sentence(module, *command)) : std::nullopt;
}

std::optional<std::string> sentenceOf(Module module, const Payload& payload) {
    switch (module.type) {
        case ModuleType::Stepper:
            return sentenceOf(module, decodeStepCommand(payload));
        case ModuleType::Io:
            return sentenceOf(module, decodeIoCommand(payload));
        case ModuleType::Servo:
        case ModuleType::Adc:
            break;
    }
    return sentenceOf(module, decodeServoCommand(module, payload));
}

constexpr ModuleIdentity kFirstServo{ModuleType::Servo, servo::kDeadbandVersion};

std::string describePayload(Module addressee, const Payload& payload) {
    // A module that is not known is only ever sent what all have in common.
    const ModuleIdentity module = isKnown(addressee) ? addressee : kFirstServo;
    const auto row = findCommand(module, payload.code);
    const std::string data = payload.data.empty() ? "no data" : toHex(payload.data);
    if (!row)
        return "command " + std::to_string(static_cast<int>(payload.code)) +
               ", which the chip does not have: " + data;
    const auto text = sentenceOf(module, payload);
    return text ? *text : std::string(row->name) + ", not as the data sheet has it: " + data;
}

/// Takes the packet that the bytes begin with, as far as it goes.
ByteSpan firstPacket(ByteSpan bytes) {
    if (bytes.size() < 3)
        return bytes;
    const std::size_t length = (bytes[2] >> 4U) + std::size_t{4};
    return bytes.first(std::min(length, bytes.size()));
}

std::string describePacket(Module module, ByteSpan packet) {
    const auto frame = parsePacket(packet);
    if (frame)
        return describePayload(module, frame->payload);
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

std::string describeCommand(const ModuleIdentity& module, ByteSpan bytes) {
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
            parts.add(describePacket(module, packet));
            bytes = bytes.subspan(packet.size());
        }
    }
    return parts.text();
}

std::string describeCommand(const ServoCommand& command) {
    // The SC has every command and every status item.
    return sentence({ModuleType::Servo, kScVersion}, command);
}

std::string describeCommand(const StepperCommand& command) {
    return sentence({ModuleType::Stepper, 1}, command);
}

std::string describeCommand(const IoCommand& command) {
    return sentence({ModuleType::Io, 1}, command);
}

}  // namespace nmc
