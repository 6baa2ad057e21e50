// SPDX-License-Identifier: MIT
#include "protocol/status.h"

namespace nmc {

namespace {

// The first six are all that versions 1 to 4 have.
constexpr std::array kServoItems{
    StatusItemRow{StatusItems::Position, "position", 4},
    StatusItemRow{StatusItems::Analog, "A/D value", 1},
    StatusItemRow{StatusItems::Velocity, "velocity", 2},
    StatusItemRow{StatusItems::Aux, "auxiliary status", 1},
    StatusItemRow{StatusItems::Home, "home position", 4},
    StatusItemRow{StatusItems::Identity, "type, version", 2},
    StatusItemRow{StatusItems::PositionError, "position error", 2},
    StatusItemRow{StatusItems::PathPoints, "path points", 1},
};
constexpr std::size_t kFirstServoItems = 6;

constexpr std::array kStepperItems{
    StatusItemRow{StatusItems::Position, "position", 4},
    StatusItemRow{StatusItems::Analog, "A/D value", 1},
    StatusItemRow{StatusItems::TimerCount, "current timer count", 2},
    StatusItemRow{StatusItems::Inputs, "inputs", 1},
    StatusItemRow{StatusItems::Home, "home position", 4},
    StatusItemRow{StatusItems::Identity, "type, version", 2},
};

constexpr std::array kIoItems{
    StatusItemRow{StatusItems::Pins, "inputs", 2},
    StatusItemRow{StatusItems::Analog1, "A/D value 1", 1},
    StatusItemRow{StatusItems::Analog2, "A/D value 2", 1},
    StatusItemRow{StatusItems::Analog3, "A/D value 3", 1},
    StatusItemRow{StatusItems::Counter, "counter/timer", 4},
    StatusItemRow{StatusItems::Identity, "type, version", 2},
    StatusItemRow{StatusItems::LatchedPins, "latched inputs", 2},
    StatusItemRow{StatusItems::LatchedCounter, "latched counter", 4},
};

ModuleIdentity identityOf(ByteSpan bytes) {
    return {static_cast<ModuleType>(bytes[0]), bytes[1]};
}

void storeIo(StatusReport& report, std::uint8_t item, ByteSpan bytes) {
    constexpr std::uint16_t kPins = 0x0FFF;
    const auto pins = [bytes] {
        return static_cast<std::uint16_t>(readLittleEndian<std::uint16_t>(bytes) & kPins);
    };
    switch (item) {
        case StatusItems::Pins:
            report.pins = pins();
            break;
        case StatusItems::Analog1:
            report.analogs[0] = bytes[0];
            break;
        case StatusItems::Analog2:
            report.analogs[1] = bytes[0];
            break;
        case StatusItems::Analog3:
            report.analogs[2] = bytes[0];
            break;
        case StatusItems::Counter:
            report.counter = readLittleEndian<std::uint32_t>(bytes);
            break;
        case StatusItems::Identity:
            report.identity = identityOf(bytes);
            break;
        case StatusItems::LatchedPins:
            report.latchedPins = pins();
            break;
        case StatusItems::LatchedCounter:
            report.latchedCounter = readLittleEndian<std::uint32_t>(bytes);
            break;
        default:
            break;
    }
}

std::int16_t velocityOf(const ModuleIdentity& module, ByteSpan bytes) {
    const auto sent = readLittleEndian<std::int16_t>(bytes);
    if (hasPathBuffer(module))
        return sent;
    // DS-V 5.2: "the negative of the velocity". -(-32768) does not fit; the chip cannot get there.
    const int negated = -int{sent};
    return static_cast<std::int16_t>(negated > INT16_MAX ? INT16_MAX : negated);
}

void storeMotor(StatusReport& report, const ModuleIdentity& module, std::uint8_t item, ByteSpan bytes) {
    switch (item) {
        case StatusItems::Position:
            report.position = readLittleEndian<std::int32_t>(bytes);
            break;
        case StatusItems::Analog:
            report.analog = bytes[0];
            break;
        case StatusItems::Velocity:  // and StatusItems::TimerCount
            if (module.type == ModuleType::Stepper)
                report.timerCount = readLittleEndian<std::uint16_t>(bytes);
            else
                report.velocity = velocityOf(module, bytes);
            break;
        case StatusItems::Aux:  // and StatusItems::Inputs
            report.aux = bytes[0];
            break;
        case StatusItems::Home:
            report.home = readLittleEndian<std::int32_t>(bytes);
            break;
        case StatusItems::Identity:
            report.identity = identityOf(bytes);
            break;
        case StatusItems::PositionError:
            report.positionError = readLittleEndian<std::int16_t>(bytes);
            break;
        case StatusItems::PathPoints:
            report.pathPoints = bytes[0];
            break;
        default:
            break;
    }
}

}  // namespace

std::span<const StatusItemRow> statusItemTable(const ModuleIdentity& module) {
    switch (module.type) {
        case ModuleType::Stepper:
            return kStepperItems;
        case ModuleType::Io:
            return kIoItems;
        case ModuleType::Servo:
        case ModuleType::Adc:
            break;
    }
    // A module of another type is only ever asked for type and version, which sits at the same bit in all.
    const std::span<const StatusItemRow> servo(kServoItems);
    return hasPathBuffer(module) ? servo : servo.first(kFirstServoItems);
}

StatusItems allItems(const ModuleIdentity& module) {
    unsigned mask = 0;
    for (const StatusItemRow& row : statusItemTable(module))
        mask |= row.bit;
    return StatusItems(static_cast<std::uint8_t>(mask));
}

std::size_t replyLength(const ModuleIdentity& module, StatusItems items) {
    std::size_t length = 2;
    for (const StatusItemRow& row : statusItemTable(module))
        if (items.has(row.bit))
            length += row.size;
    return length;
}

tl::expected<StatusReport, StatusError> decodeStatus(const ModuleIdentity& module, StatusItems items,
                                                     ByteSpan reply) {
    if (reply.size() != replyLength(module, items))
        return tl::unexpected(StatusError::Length);
    if (sum8(reply.first(reply.size() - 1)) != reply.back())
        return tl::unexpected(StatusError::Checksum);

    StatusReport report;
    report.items = items;
    report.status = reply[0];
    std::size_t at = 1;
    for (const StatusItemRow& row : statusItemTable(module)) {
        if (!items.has(row.bit))
            continue;
        const ByteSpan bytes = reply.subspan(at, row.size);
        if (module.type == ModuleType::Io)
            storeIo(report, row.bit, bytes);
        else
            storeMotor(report, module, row.bit, bytes);
        at += row.size;
    }
    return report;
}

namespace servo {

AuxByte toAuxByte(ScAuxByte sc) {
    constexpr unsigned kIndex = 0x01, kAccelDone = 0x08, kSlewDone = 0x10;
    unsigned bits = sc.bits & ~(kIndex | kAccelDone | kSlewDone);
    bits |= sc.index() ? 0U : kIndex;
    bits |= sc.accelerating() ? 0U : kAccelDone;
    bits |= sc.accelerating() || sc.slewing() ? 0U : kSlewDone;
    return {static_cast<std::uint8_t>(bits)};
}

}  // namespace servo

}  // namespace nmc
