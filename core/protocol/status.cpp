// SPDX-License-Identifier: MIT
#include "protocol/status.h"

namespace nmc {

namespace {

// Versions 1 to 4 have only the first six.
constexpr std::array kServoItems{
    StatusItemRow{StatusItems::Position, "position", 4, &StatusReport::position},
    StatusItemRow{StatusItems::Analog, "A/D value", 1, &StatusReport::analog},
    StatusItemRow{StatusItems::Velocity, "velocity", 2, &StatusReport::velocity},
    StatusItemRow{StatusItems::Aux, "auxiliary status", 1, &StatusReport::aux},
    StatusItemRow{StatusItems::Home, "home position", 4, &StatusReport::home},
    StatusItemRow{StatusItems::Identity, "type, version", 2, &StatusReport::identity},
    StatusItemRow{StatusItems::PositionError, "position error", 2, &StatusReport::positionError},
    StatusItemRow{StatusItems::PathPoints, "path points", 1, &StatusReport::pathPoints},
};
constexpr std::size_t kFirstServoItems = 6;

constexpr std::array kStepperItems{
    StatusItemRow{StatusItems::Position, "position", 4, &StatusReport::position},
    StatusItemRow{StatusItems::Analog, "A/D value", 1, &StatusReport::analog},
    StatusItemRow{StatusItems::TimerCount, "current timer count", 2, &StatusReport::timerCount},
    StatusItemRow{StatusItems::Inputs, "inputs", 1, &StatusReport::aux},
    StatusItemRow{StatusItems::Home, "home position", 4, &StatusReport::home},
    StatusItemRow{StatusItems::Identity, "type, version", 2, &StatusReport::identity},
};

constexpr std::array kIoItems{
    StatusItemRow{StatusItems::Pins, "inputs", 2, &StatusReport::pins},
    StatusItemRow{StatusItems::Analog1, "A/D value 1", 1, std::size_t{0}},
    StatusItemRow{StatusItems::Analog2, "A/D value 2", 1, std::size_t{1}},
    StatusItemRow{StatusItems::Analog3, "A/D value 3", 1, std::size_t{2}},
    StatusItemRow{StatusItems::Counter, "counter/timer", 4, &StatusReport::counter},
    StatusItemRow{StatusItems::Identity, "type, version", 2, &StatusReport::identity},
    StatusItemRow{StatusItems::LatchedPins, "latched inputs", 2, &StatusReport::latchedPins},
    StatusItemRow{StatusItems::LatchedCounter, "latched counter", 4, &StatusReport::latchedCounter},
};

void read(ByteSpan bytes, std::optional<ModuleIdentity>& identity) {
    identity = {static_cast<ModuleType>(bytes[0]), bytes[1]};
}

template <typename T>
void read(ByteSpan bytes, std::optional<T>& value) {
    value = readLittleEndian<T>(bytes);
}

/// The chip sends "the negative of the velocity" (DS-V 5.2). -(-32768) does not fit, but the chip
/// cannot reach that speed.
std::int16_t negated(std::int16_t sent) {
    return sent == INT16_MIN ? INT16_MAX : static_cast<std::int16_t>(-sent);
}

}  // namespace

std::span<const StatusItemRow> statusItemTable(const ModuleIdentity& module) {
    if (module.type == ModuleType::Stepper)
        return kStepperItems;
    if (module.type == ModuleType::Io)
        return kIoItems;
    // A module of another type is only asked for its type and version, which has the same bit in all modules.
    const std::span<const StatusItemRow> servo(kServoItems);
    return hasPathBuffer(module) ? servo : servo.first(kFirstServoItems);
}

StatusItems allItems(const ModuleIdentity& module) {
    StatusItems all;
    for (const StatusItemRow& row : statusItemTable(module))
        all = all | StatusItems(row.bit);
    return all;
}

std::size_t replyLength(const ModuleIdentity& module, StatusItems items) {
    std::size_t length = 2;
    for (const StatusItemRow& row : statusItemTable(module))
        if (items.has(row.bit))
            length += row.size;
    return length;
}

void merge(const ModuleIdentity& module, StatusReport& into, const StatusReport& from) {
    into.status = from.status;
    into.items = into.items | from.items;
    const auto take = [](auto& to, const auto& value) {
        if (value)
            to = value;
    };
    for (const StatusItemRow& row : statusItemTable(module))
        visitItem(row, take, into, from);
}

std::optional<StatusReport> decodeStatus(const ModuleIdentity& module, StatusItems items, ByteSpan reply) {
    if (reply.size() != replyLength(module, items) || sum8(reply.first(reply.size() - 1)) != reply.back())
        return std::nullopt;

    StatusReport report;
    report.items = items;
    report.status = reply[0];
    std::size_t at = 1;
    for (const StatusItemRow& row : statusItemTable(module)) {
        if (!items.has(row.bit))
            continue;
        const ByteSpan bytes = reply.subspan(at, row.size);
        visitItem(
            row, [bytes](auto& value) { read(bytes, value); }, report);
        at += row.size;
    }
    if (report.velocity && !hasPathBuffer(module))
        report.velocity = negated(*report.velocity);
    for (std::optional<std::uint16_t>* pins : {&report.pins, &report.latchedPins})
        if (*pins)
            *pins = static_cast<std::uint16_t>(**pins & 0x0FFFU);
    return report;
}

namespace servo {

AuxByte toAuxByte(std::uint8_t sc) {
    constexpr unsigned kIndex = 0x01, kAccel = 0x08, kSlew = 0x10;
    unsigned bits = sc ^ (kIndex | kAccel | kSlew);
    if ((sc & kAccel) != 0)
        bits &= ~kSlew;  // what has not begun is not done
    return {static_cast<std::uint8_t>(bits)};
}

}  // namespace servo

}  // namespace nmc
