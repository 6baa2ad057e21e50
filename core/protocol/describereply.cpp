// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "protocol/describe.h"
#include "protocol/describeparts.h"

namespace nmc {

using describe::Phrases;

namespace {

using BitNames = std::array<std::string_view, 8>;

/// The names of the bits that are set. Those of a PIC-STEP have spaces in them, so a plus stands between.
std::string bitNames(ModuleType type, const BitNames& names, std::uint8_t bits) {
    Phrases phrases(type == ModuleType::Step ? " + " : " ");
    for (unsigned i = 0; i < names.size(); ++i)
        if ((bits & (1U << i)) != 0)
            phrases.add(names[i].empty() ? "bit" + std::to_string(i) : std::string(names[i]));
    return phrases.empty() ? "00" : phrases.text();
}

std::string value(ModuleType type, const StatusReport& report, std::uint8_t item) {
    const bool step = type == ModuleType::Step;
    switch (item) {
        case StatusItems::Position:
            return std::to_string(report.position.value_or(0));
        case StatusItems::Analog:
            return std::to_string(report.analog.value_or(0));
        case StatusItems::Velocity:  // and StatusItems::TimerCount
            return std::to_string(step ? int{report.timerCount.value_or(0)}
                                       : int{report.velocity.value_or(0)});
        case StatusItems::Aux:  // and StatusItems::Inputs
            return bitNames(type, step ? step::kInputBitNames : servo::kAuxBitNames, report.aux.value_or(0));
        case StatusItems::Home:
            return std::to_string(report.home.value_or(0));
        default:
            return {};
    }
}

std::string identity(const StatusReport& report) {
    const ModuleIdentity is = report.identity.value_or(ModuleIdentity{});
    return "type " + std::to_string(static_cast<int>(is.type)) + ", version " + std::to_string(is.version);
}

std::string describeReport(ModuleType type, const StatusReport& report) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(type)) {
        if (!report.items.has(row.bit))
            continue;
        if (row.bit == StatusItems::Identity)
            phrases.add(identity(report));
        else
            phrases.add(std::string(row.name) + ' ' + value(type, report, row.bit));
    }
    const bool step = type == ModuleType::Step;
    const std::string bits =
        bitNames(type, step ? step::kStatusBitNames : servo::kStatusBitNames, report.status);
    return phrases.add(report.status == 0 ? "status 00" : bits).text();
}

}  // namespace

std::string describeReply(ModuleType type, StatusItems items, ByteSpan bytes) {
    if (bytes.empty())
        return {};
    const std::size_t length = replyLength(type, items);
    if (bytes.size() < length)
        return std::to_string(bytes.size()) + " of " + describe::counted(length, "byte");
    Phrases phrases("; ");
    std::vector<std::uint8_t> reply(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
    if (const std::uint8_t sum = sum8(ByteSpan(reply).first(length - 1)); sum != reply.back()) {
        phrases.add("sum " + toHex(std::array{reply.back()}) + " instead of " + toHex(std::array{sum}));
        reply.back() = sum;  // what it would say
    }
    if (const auto report = decodeStatus(type, items, reply))
        phrases.add(describeReport(type, *report));
    if (bytes.size() > length)
        phrases.add(describe::counted(bytes.size() - length, "byte") + " too many");
    return phrases.text();
}

}  // namespace nmc
