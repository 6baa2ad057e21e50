// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "protocol/describe.h"
#include "protocol/phrases.h"

namespace nmc {

using describe::Phrases;

namespace {

using BitNames = std::array<std::string_view, 8>;

/// The names of the bits that are set. Those of a PIC-STEP have spaces in them, so a plus stands between.
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

template <typename T>
std::string number(const std::optional<T>& item) {
    return std::to_string(item.value_or(T{}));
}

std::string ioValue(const StatusReport& report, std::uint8_t item) {
    switch (item) {
        case StatusItems::Pins:
            return describe::lineNames("IO", io::kPins, report.pins.value_or(0), "all low");
        case StatusItems::Analog1:
            return number(report.analogs[0]);
        case StatusItems::Analog2:
            return number(report.analogs[1]);
        case StatusItems::Analog3:
            return number(report.analogs[2]);
        case StatusItems::Counter:
            return number(report.counter);
        case StatusItems::LatchedPins:
            return describe::lineNames("IO", io::kPins, report.latchedPins.value_or(0), "all low");
        case StatusItems::LatchedCounter:
            return number(report.latchedCounter);
        default:
            return {};
    }
}

std::string motorValue(const ModuleIdentity& module, const StatusReport& report, std::uint8_t item) {
    switch (item) {
        case StatusItems::Position:
            return number(report.position);
        case StatusItems::Analog:
            return number(report.analog);
        case StatusItems::Velocity:  // and StatusItems::TimerCount
            return module.type == ModuleType::Stepper ? number(report.timerCount) : number(report.velocity);
        case StatusItems::Aux:  // and StatusItems::Inputs
            return bitNames(module.type, auxBitNames(module), report.aux.value_or(0));
        case StatusItems::Home:
            return number(report.home);
        case StatusItems::PositionError:
            return number(report.positionError);
        case StatusItems::PathPoints:
            return number(report.pathPoints);
        default:
            return {};
    }
}

std::string identity(const StatusReport& report) {
    const ModuleIdentity is = report.identity.value_or(ModuleIdentity{});
    return "type " + std::to_string(static_cast<int>(is.type)) + ", version " + std::to_string(is.version);
}

std::string describeReport(const ModuleIdentity& module, const StatusReport& report) {
    Phrases phrases;
    for (const StatusItemRow& row : statusItemTable(module)) {
        if (!report.items.has(row.bit))
            continue;
        if (row.bit == StatusItems::Identity)
            phrases.add(identity(report));
        else
            phrases.add(std::string(row.name) + ' ' +
                        (module.type == ModuleType::Io ? ioValue(report, row.bit)
                                                       : motorValue(module, report, row.bit)));
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
        reply.back() = sum;  // what it would say
    }
    if (const auto report = decodeStatus(module, items, reply))
        phrases.add(describeReport(module, *report));
    if (bytes.size() > length)
        phrases.add(describe::counted(bytes.size() - length, "byte") + " too many");
    return phrases.text();
}

}  // namespace nmc
