// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bus/types.h"
#include "module/registers.h"

namespace nmc::bus {

/// Watches whether a PIC-SERVO does what it was told: a command that was changed on its way in spite of its
/// sum, swapped encoder wires, a frame that is repeated for ever (faults.md F-06, F-12, M-17). One object per
/// module; told what goes out and what comes back. Pure.
class MotionWatch {
public:
    /// Against the direction of a motion, in counts; a servo gives that much when it starts under load.
    static constexpr std::int64_t kWrongWay = 400;
    /// Beyond the goal: this, and a tenth of the way, is overshoot.
    static constexpr std::int64_t kOvershoot = 400;
    /// Replies that repeat a position while the velocity is not 0.
    static constexpr unsigned kFrozen = 5;

    /// `sent`: after this command and all before it.
    void onSent(const ModuleCommand& command, const ServoRegisters& sent);
    /// A report that may be believed. What is wrong with the motion, once.
    [[nodiscard]] std::optional<MotionSuspect::Reason> onReport(const StatusReport& report);

private:
    struct Sent;
    /// A trapezoidal move: from where it started to its goal.
    struct Corridor {
        std::int64_t from = 0;
        std::int64_t goal = 0;
    };
    /// Velocity mode: the farthest it has come in its direction.
    struct Heading {
        int direction = 1;
        bool underWay = false;  ///< it has been seen to go that way
        std::int64_t best = 0;
    };
    struct LastOfLayout {
        std::uint8_t items = 0;
        std::int32_t position = 0;
    };

    void started(const ServoRegisters& sent);
    void forget();
    [[nodiscard]] std::optional<MotionSuspect::Reason> leaves(std::int64_t position, int velocity);
    [[nodiscard]] bool frozen(const StatusReport& report);

    std::optional<std::int64_t> m_position;  ///< beyond 32 bits where it has wrapped
    std::int16_t m_velocity = 0;
    std::optional<Corridor> m_corridor;
    std::optional<Heading> m_heading;
    std::array<LastOfLayout, 2> m_last{};
    unsigned m_repeats = 0;
};

}  // namespace nmc::bus
