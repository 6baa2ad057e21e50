// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "protocol/describe.h"
#include "protocol/phrases.h"

namespace nmc {

using describe::Phrases;

namespace {

using BitNames = std::array<std::string_view, 8>;

/// Returns the names of the bits that are set. The names of a PIC-STEP's bits contain spaces, so they are
/// joined with plus signs.
std::string bitNames(ModuleType type, const BitNames& names, std::uint8_t bits) {
    Phrases phrases(type == ModuleType::Stepper ? " + " : " ");
    for (unsigned i = 0; i < names.size(); ++i)
        if ((bits & (1U << i)) != 0)
            phrases.add(names[i].empty() ? "bit" + std::to_string(i) : std::string(names[i]));
    return phrases.empty() ? "00" : phrases.text();
}

const BitNames& statusBitNames(ModuleType type) {
    switch (type) {
        case ModuleType::Stepper:
            return stepper::kStatusBitNames;
        case ModuleType::Io:
            return io::kStatusBitNames;
        case ModuleType::Servo:
        case ModuleType::Adc:
            break;
    }
    return servo::kStatusBitNames;
}

const BitNames& auxBitNames(const ModuleIdentity& module) {
    if (module.type == ModuleType::Stepper)
        return stepper::kInputBitNames;
    if (isSc(module))
        return servo::kScAuxBitNames;
    return hasPathBuffer(module) ? servo::kCmcAuxBitNames : servo::kAuxBitNames;
}

/// Items without named bits are shown as a number.
std::string valueOf(const ModuleIdentity& module, const StatusReport& report, std::uint8_t item) {
    const bool io = module.type == ModuleType::Io;
    if (!io && item == StatusItems::Aux)
        return bitNames(module.type, auxBitNames(module), report.aux.value_or(0));
    std::string text;
    const auto describe = [&](const auto& value) {
        using T = typename std::decay_t<decltype(value)>::value_type;
        if constexpr (std::is_same_v<T, ModuleIdentity>)
            text = "type " + std::to_string(static_cast<int>(value->type)) + ", version " +
                   std::to_string(value->version);
        else if (io && (item == StatusItems::Pins || item == StatusItems::LatchedPins))
            text = describe::lineNames("IO", io::kPins, static_cast<std::uint16_t>(*value), "all low");
        else
            text = std::to_string(*value);
    };
    visitItem(
        module, item,
        [&](const auto& value) {
            if (value)
                describe(value);
        },
        report);
    return text;
}

std::string describeReport(const ModuleIdentity& module, const StatusReport& report) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(module)) {
        if (!report.items.has(row.bit))
            continue;
        const std::string value = valueOf(module, report, row.bit);
        phrases.add(row.bit == StatusItems::Identity ? value : std::string(row.name) + ' ' + value);
    }
    const std::string bits = bitNames(module.type, statusBitNames(module.type), report.status);
    return phrases.add(report.status == 0 ? "status 00" : bits).text();
}

}  // namespace

std::string describeReply(const ModuleIdentity& module, StatusItems items, ByteSpan bytes) {
    if (bytes.empty())
        return {};
    const std::size_t length = replyLength(module, items);
    if (bytes.size() < length)
        return std::to_string(bytes.size()) + " of " + describe::counted(length, "byte");
    Phrases phrases("; ");
    std::vector<std::uint8_t> reply(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    if (const std::uint8_t sum = sum8(ByteSpan(reply).first(length - 1)); sum != reply.back()) {
        phrases.add("sum " + toHex(std::array{reply.back()}) + " instead of " + toHex(std::array{sum}));
        reply.back() = sum;  // so that the contents can still be shown
    }
    if (const auto report = decodeStatus(module, items, reply))
        phrases.add(describeReport(module, *report));
    if (bytes.size() > length)
        phrases.add(describe::counted(bytes.size() - length, "byte") + " too many");
    return phrases.text();
}

}  // namespace nmc
