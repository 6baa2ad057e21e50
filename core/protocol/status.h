// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "base/bytes.h"
#include "base/overloaded.h"
#include "protocol/moduletype.h"

namespace nmc {

/// The mask of Define Status and Read Status: which items follow the status byte.
class StatusItems {
public:
    constexpr StatusItems() = default;
    constexpr explicit StatusItems(std::uint8_t mask) : m_mask(mask) {}

    static constexpr std::uint8_t Position = 0x01;
    static constexpr std::uint8_t Analog = 0x02;
    static constexpr std::uint8_t Velocity = 0x04;    ///< PIC-SERVO
    static constexpr std::uint8_t TimerCount = 0x04;  ///< PIC-STEP
    static constexpr std::uint8_t Aux = 0x08;         ///< PIC-SERVO: auxiliary status byte
    static constexpr std::uint8_t Inputs = 0x08;      ///< PIC-STEP: inputs byte
    static constexpr std::uint8_t Home = 0x10;
    static constexpr std::uint8_t Identity = 0x20;       ///< the same on every chip
    static constexpr std::uint8_t PositionError = 0x40;  ///< PIC-SERVO CMC and SC
    static constexpr std::uint8_t PathPoints = 0x80;     ///< PIC-SERVO CMC and SC: points left in the buffer
    /// All items defined by both data sheets; bits 6 and 7 are "clear to zero".
    static constexpr std::uint8_t All = 0x3F;

    // PIC-I/O
    static constexpr std::uint8_t Pins = 0x01;
    static constexpr std::uint8_t Analog1 = 0x02;
    static constexpr std::uint8_t Analog2 = 0x04;
    static constexpr std::uint8_t Analog3 = 0x08;
    static constexpr std::uint8_t Counter = 0x10;
    static constexpr std::uint8_t LatchedPins = 0x40;
    static constexpr std::uint8_t LatchedCounter = 0x80;

    [[nodiscard]] constexpr std::uint8_t mask() const { return m_mask; }
    [[nodiscard]] constexpr bool has(std::uint8_t item) const { return (m_mask & item) != 0; }
    [[nodiscard]] constexpr StatusItems operator|(StatusItems more) const {
        return StatusItems(static_cast<std::uint8_t>(m_mask | more.m_mask));
    }
    constexpr bool operator==(const StatusItems&) const = default;

private:
    std::uint8_t m_mask = 0;
};

/// Every item of the module.
[[nodiscard]] StatusItems allItems(const ModuleIdentity& module);

/// Bytes in a whole reply, 2..19: status byte, items, checksum.
[[nodiscard]] std::size_t replyLength(const ModuleIdentity& module, StatusItems items);
inline constexpr std::size_t kMaxReply = 19;

/// PIC-SERVO status byte (DS-V 5.3).
namespace servo {
struct StatusByte {
    std::uint8_t bits = 0;
    [[nodiscard]] constexpr bool moveDone() const { return (bits & 0x01U) != 0; }
    [[nodiscard]] constexpr bool overcurrent() const { return (bits & 0x04U) != 0; }
    [[nodiscard]] constexpr bool powerOn() const { return (bits & 0x08U) != 0; }
    [[nodiscard]] constexpr bool positionError() const { return (bits & 0x10U) != 0; }
    [[nodiscard]] constexpr bool limit1() const { return (bits & 0x20U) != 0; }
    [[nodiscard]] constexpr bool limit2() const { return (bits & 0x40U) != 0; }
    [[nodiscard]] constexpr bool homeInProgress() const { return (bits & 0x80U) != 0; }
};
/// Auxiliary status byte of a PIC-SERVO up to version 5 (DS-V 5.3); that of an SC differs in three bits.
struct AuxByte {
    std::uint8_t bits = 0;
    [[nodiscard]] constexpr bool indexComplement() const { return (bits & 0x01U) != 0; }
    [[nodiscard]] constexpr bool positionWrap() const { return (bits & 0x02U) != 0; }
    [[nodiscard]] constexpr bool servoOn() const { return (bits & 0x04U) != 0; }
    [[nodiscard]] constexpr bool accelDone() const { return (bits & 0x08U) != 0; }
    [[nodiscard]] constexpr bool slewDone() const { return (bits & 0x10U) != 0; }
    [[nodiscard]] constexpr bool servoOverrun() const { return (bits & 0x20U) != 0; }
    [[nodiscard]] constexpr bool pathMode() const { return (bits & 0x40U) != 0; }  ///< CMC only
    bool operator==(const AuxByte&) const = default;
};
/// Converts the auxiliary status byte of a PIC-SERVO SC to the terms of the first data sheet, so that code
/// above the wire need not know both. An SC's index bit is the pin itself, its bit 3 is set while the motor
/// accelerates, and its bit 4 at constant speed or at rest.
[[nodiscard]] AuxByte toAuxByte(std::uint8_t sc);
/// The data sheet's bit names, bit 0 first; empty where undefined.
inline constexpr std::array<std::string_view, 8> kStatusBitNames{
    "move_done", "cksum_error", "overcurrent", "power_on",
    "pos_error", "limit1",      "limit2",      "home_in_progress"};
inline constexpr std::array<std::string_view, 8> kAuxBitNames{
    "index", "pos_wrap", "servo_on", "accel_done", "slew_done", "servo_overrun", "", ""};
inline constexpr std::array<std::string_view, 8> kCmcAuxBitNames{
    "index", "pos_wrap", "servo_on", "accel_done", "slew_done", "servo_overrun", "path_mode", ""};
inline constexpr std::array<std::string_view, 8> kScAuxBitNames{
    "index", "pos_wrap", "servo_on", "accel", "slew", "servo_overrun", "path_mode", ""};
}  // namespace servo

/// PIC-STEP status byte (DS-S 5.2).
namespace stepper {
struct StatusByte {
    std::uint8_t bits = 0;
    [[nodiscard]] constexpr bool moving() const { return (bits & 0x01U) != 0; }
    [[nodiscard]] constexpr bool amplifierEnabled() const { return (bits & 0x04U) != 0; }
    [[nodiscard]] constexpr bool powerOn() const { return (bits & 0x08U) != 0; }
    [[nodiscard]] constexpr bool atSpeed() const { return (bits & 0x10U) != 0; }
    [[nodiscard]] constexpr bool velocityMode() const { return (bits & 0x20U) != 0; }
    [[nodiscard]] constexpr bool trapezoidalMode() const { return (bits & 0x40U) != 0; }
    [[nodiscard]] constexpr bool homing() const { return (bits & 0x80U) != 0; }
};
/// PIC-STEP inputs byte (DS-S 5.2).
struct InputsByte {
    std::uint8_t bits = 0;
    [[nodiscard]] constexpr bool estop() const { return (bits & 0x01U) != 0; }
    [[nodiscard]] constexpr bool in1() const { return (bits & 0x02U) != 0; }
    [[nodiscard]] constexpr bool in2() const { return (bits & 0x04U) != 0; }
    [[nodiscard]] constexpr bool limit1() const { return (bits & 0x08U) != 0; }
    [[nodiscard]] constexpr bool limit2() const { return (bits & 0x10U) != 0; }
    [[nodiscard]] constexpr bool homeSwitch() const { return (bits & 0x20U) != 0; }
};
inline constexpr std::array<std::string_view, 8> kStatusBitNames{"moving",
                                                                 "communication error",
                                                                 "amplifier enabled",
                                                                 "power",
                                                                 "at commanded speed",
                                                                 "velocity profile mode",
                                                                 "trapezoidal mode",
                                                                 "homing"};
inline constexpr std::array<std::string_view, 8> kInputBitNames{"E-stop", "IN1",         "IN2", "limit1",
                                                                "limit2", "home switch", "",    ""};
}  // namespace stepper

/// PIC-I/O status byte (docs/family.md).
namespace io {
inline constexpr std::array<std::string_view, 8> kStatusBitNames{"", "cksum_error", "", "", "", "", "", ""};
}  // namespace io

/// One decoded reply. Items that were not requested are empty.
struct StatusReport {
    StatusItems items;
    std::uint8_t status = 0;
    std::optional<std::int32_t> position;  ///< counts or steps
    std::optional<std::uint8_t> analog;    ///< A/D, 255 = 5 V
    std::optional<std::int16_t> velocity;  ///< PIC-SERVO, counts/tick; up to v4 the wire carries its negative
    std::optional<std::uint16_t> timerCount;  ///< PIC-STEP, current initial timer count
    std::optional<std::uint8_t> aux;          ///< PIC-SERVO auxiliary status or PIC-STEP inputs
    std::optional<std::int32_t> home;
    std::optional<ModuleIdentity> identity;
    std::optional<std::int16_t> positionError;  ///< CMC and SC, counts: command position - position
    std::optional<std::uint8_t> pathPoints;     ///< CMC and SC: points left in the path buffer

    // PIC-I/O
    std::optional<std::uint16_t> pins;                   ///< bit 0 is IO1, bit 11 IO12
    std::array<std::optional<std::uint8_t>, 3> analogs;  ///< A/D 1 to 3, 255 = 5 V
    std::optional<std::uint32_t> counter;                ///< or timer
    std::optional<std::uint16_t> latchedPins;            ///< latched by Synch Input
    std::optional<std::uint32_t> latchedCounter;

    [[nodiscard]] servo::StatusByte servoStatus() const { return {status}; }
    [[nodiscard]] stepper::StatusByte stepperStatus() const { return {status}; }
    /// CMC and SC: what the servo holds or follows; empty if the reply does not show it.
    [[nodiscard]] std::optional<std::int32_t> commandPosition() const {
        if (!position || !positionError)
            return std::nullopt;
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(*position) +
                                         static_cast<std::uint32_t>(*positionError));
    }
    /// Bit 1 means the same on all chips: the module refused the command (NAK) and did not carry it out.
    [[nodiscard]] bool commandRefused() const { return (status & 0x02U) != 0; }
    bool operator==(const StatusReport&) const = default;
};

template <typename T>
using ReportMember = std::optional<T> StatusReport::*;

struct StatusItemRow {
    std::uint8_t bit;
    std::string_view name;
    std::uint8_t size;  ///< bytes
    /// The member that holds the item, or its index in StatusReport::analogs.
    std::variant<ReportMember<std::uint8_t>, ReportMember<std::int16_t>, ReportMember<std::uint16_t>,
                 ReportMember<std::int32_t>, ReportMember<std::uint32_t>, ReportMember<ModuleIdentity>,
                 std::size_t>
        place;
};

/// The items of a module in the order in which they are sent (DS-V 5.2, DS-S 5.1 Define Status).
[[nodiscard]] std::span<const StatusItemRow> statusItemTable(const ModuleIdentity& module);

/// Calls `function` with the member of each report that holds this item. The reports are StatusReports, const
/// or not.
template <typename Function, typename... Reports>
void visitItem(const StatusItemRow& row, Function function, Reports&... reports) {
    std::visit(Overloaded{[&](std::size_t analog) { function(reports.analogs[analog]...); },
                          [&](auto member) { function((reports.*member)...); }},
               row.place);
}

/// Copies every item that `from` carries; items that it does not carry keep their last value.
void merge(const ModuleIdentity& module, StatusReport& into, const StatusReport& from);

/// Decodes a whole reply; returns nothing if its length or its sum is wrong. The host must know the layout
/// beforehand, because a reply has neither header nor length.
[[nodiscard]] std::optional<StatusReport> decodeStatus(const ModuleIdentity& module, StatusItems items,
                                                       ByteSpan reply);

}  // namespace nmc
