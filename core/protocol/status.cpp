// SPDX-License-Identifier: MIT
#include "protocol/status.h"

namespace nmc {

namespace {

constexpr std::array kServoItems{
    StatusItemRow{StatusItems::Position, "position", 4},
    StatusItemRow{StatusItems::Analog, "A/D value", 1},
    StatusItemRow{StatusItems::Velocity, "velocity", 2},
    StatusItemRow{StatusItems::Aux, "auxiliary status", 1},
    StatusItemRow{StatusItems::Home, "home position", 4},
    StatusItemRow{StatusItems::Identity, "type, version", 2},
};

constexpr std::array kStepItems{
    StatusItemRow{StatusItems::Position, "position", 4},
    StatusItemRow{StatusItems::Analog, "A/D value", 1},
    StatusItemRow{StatusItems::TimerCount, "current timer count", 2},
    StatusItemRow{StatusItems::Inputs, "inputs", 1},
    StatusItemRow{StatusItems::Home, "home position", 4},
    StatusItemRow{StatusItems::Identity, "type, version", 2},
};

void store(StatusReport& report, ModuleType type, std::uint8_t item, ByteSpan bytes) {
    switch (item) {
        case StatusItems::Position:
            report.position = readLittleEndian<std::int32_t>(bytes);
            break;
        case StatusItems::Analog:
            report.analog = bytes[0];
            break;
        case StatusItems::Velocity:  // and StatusItems::TimerCount
            if (type == ModuleType::Step) {
                report.timerCount = readLittleEndian<std::uint16_t>(bytes);
            } else {
                // DS-V 5.2: "the negative of the velocity". -(-32768) does not fit; the chip cannot get
                // there.
                const int negated = -int{readLittleEndian<std::int16_t>(bytes)};
                report.velocity = static_cast<std::int16_t>(negated > INT16_MAX ? INT16_MAX : negated);
            }
            break;
        case StatusItems::Aux:  // and StatusItems::Inputs
            report.aux = bytes[0];
            break;
        case StatusItems::Home:
            report.home = readLittleEndian<std::int32_t>(bytes);
            break;
        case StatusItems::Identity:
            report.identity = ModuleIdentity{static_cast<ModuleType>(bytes[0]), bytes[1]};
            break;
        default:
            break;
    }
}

}  // namespace

std::span<const StatusItemRow> statusItemTable(ModuleType type) {
    // A module of another type is only ever asked for type and version, which sits at the same bit in all.
    return type == ModuleType::Step ? std::span<const StatusItemRow>(kStepItems) : kServoItems;
}

std::size_t replyLength(ModuleType type, StatusItems items) {
    std::size_t length = 2;
    for (const StatusItemRow& row : statusItemTable(type))
        if (items.has(row.bit))
            length += row.size;
    return length;
}

tl::expected<StatusReport, StatusError> decodeStatus(ModuleType type, StatusItems items, ByteSpan reply) {
    if (reply.size() != replyLength(type, items))
        return tl::unexpected(StatusError::Length);
    if (sum8(reply.first(reply.size() - 1)) != reply.back())
        return tl::unexpected(StatusError::Checksum);

    StatusReport report;
    report.items = items;
    report.status = reply[0];
    std::size_t at = 1;
    for (const StatusItemRow& row : statusItemTable(type)) {
        if (!items.has(row.bit))
            continue;
        store(report, type, row.bit, reply.subspan(at, row.size));
        at += row.size;
    }
    return report;
}

}  // namespace nmc
