// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/strong.h"
#include "protocol/commandform.h"
#include "protocol/pathpoint.h"

/// Commands that the PIC-SERVO CMC (version 5) and SC (version 10) have beyond the first data sheet
/// (docs/family.md).
namespace nmc::servo {

/// Goal and maximum velocity of CMC and SC, 16.16 counts per tick.
inline constexpr ValueRange kLaterVelocityRange{0, 83'886'080};

/// Resets the position relative to home: position := position - home. CMC and SC only.
struct ResetRelativeToHome {
    static constexpr CommandCode kCode = CommandCode::ResetPosition;
    static void fields(auto& form, auto& /*c*/) { form.constant(0x03, 0x01, "relative to home"); }
    bool operator==(const ResetRelativeToHome&) const = default;
};

/// Sets the position to a value; the command position follows. SC only.
struct SetPosition {
    Counts position;
    static constexpr CommandCode kCode = CommandCode::ResetPosition;
    static void fields(auto& form, auto& c) {
        form.constant(0x03, 0x02);
        form.number("to position", c.position);
    }
    bool operator==(const SetPosition&) const = default;
};

/// The reaction of the module itself to a limit input: LIMIT1 stops forward motion, LIMIT2 reverse motion.
enum class LimitStop : std::uint8_t { None, MotorOff, Abruptly };

/// I/O Control of an SC. Every command applies every bit, and some of the bits can destroy an amplifier.
struct ScIoControl {
    LimitStop limitStop = LimitStop::None;  ///< must be None with step and direction
    bool threePhase = false;
    bool antiphase = false;
    bool fastPath = false;  ///< path points at 60 and 120 Hz instead of 30 and 60
    bool stepAndDirection = false;

    static constexpr CommandCode kCode = CommandCode::IoControl;
    static void fields(auto& form, auto& c) {
        form.choice(0x0C, c.limitStop,
                    {{LimitStop::None, 0x00},
                     {LimitStop::MotorOff, 0x04, "motor off on limit"},
                     {LimitStop::Abruptly, 0x08, "stop abruptly on limit"}});
        form.bit(4, c.threePhase, "3-phase");
        form.bit(5, c.antiphase, "antiphase");
        form.bit(6, c.fastPath, "fast path");
        form.bit(7, c.stepAndDirection, "step and direction");
        form.check(!c.stepAndDirection || c.limitStop == LimitStop::None);
        form.orElse("all off");
    }
    bool operator==(const ScIoControl&) const = default;
};

/// Adds up to seven points to the path buffer; a command without points starts the path. CMC and SC only.
class AddPathPoints {
public:
    static constexpr std::size_t kMaxPoints = 7;
    AddPathPoints() = default;
    /// Returns nothing for too many points, or if one of them cannot be sent (toPathWord).
    [[nodiscard]] static std::optional<AddPathPoints> of(std::span<const PathPoint> points, bool fastPath);

    /// The words as sent; their meaning depends on the fast path bit of I/O Control.
    [[nodiscard]] std::span<const std::uint16_t> words() const { return {m_words.data(), m_count}; }
    [[nodiscard]] bool startsPath() const { return m_count == 0; }

    static constexpr CommandCode kCode = CommandCode::AddPathPoints;
    static void fields(auto& form, auto& c) { form.pathPoints(c.m_words, c.m_count); }
    bool operator==(const AddPathPoints&) const = default;

private:
    std::array<std::uint16_t, kMaxPoints> m_words{};
    std::uint8_t m_count = 0;
};

/// Hard Reset with a control byte, which an SC saves across a power cycle together with its addresses,
/// velocity, acceleration and gains. SC only.
struct HardReset {
    bool save = false;  ///< false: erases what was saved
    bool restoreAddresses = false;
    bool amplifierOn = false;  ///< this and the next one only with restored addresses
    bool servoOn = false;
    bool stepAndDirection = false;
    bool limitProtection = false;
    bool threePhase = false;  ///< this and the next one also survive a soft reset
    bool antiphase = false;

    static constexpr CommandCode kCode = CommandCode::HardReset;
    static void fields(auto& form, auto& c) {
        form.bit(0, c.save);
        form.say(c.save ? "save configuration" : "erase configuration");
        form.bit(1, c.restoreAddresses, "restore addresses");
        form.bit(2, c.amplifierOn, "amplifier on");
        form.bit(3, c.servoOn, "servo on");
        form.bit(4, c.stepAndDirection, "step and direction");
        form.bit(5, c.limitProtection, "limit protection");
        form.bit(6, c.threePhase, "3-phase");
        form.bit(7, c.antiphase, "antiphase");
    }
    bool operator==(const HardReset&) const = default;
};

}  // namespace nmc::servo
