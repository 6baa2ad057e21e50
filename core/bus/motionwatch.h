// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "base/time.h"
#include "bus/types.h"
#include "module/registers.h"

namespace nmc::bus {

/// Watches whether a PIC-SERVO does what was commanded, to detect a command corrupted in transmission in
/// spite of its sum, swapped encoder wires, and a frame that is repeated forever (faults.md F-06, F-12,
/// M-17). One object per module; informed of what is sent and received. Pure.
class MotionWatch {
public:
    /// Distance against the direction of a motion, in counts; a servo may yield by less when it starts under
    /// load.
    static constexpr std::int64_t kWrongWay = 400;
    /// Distance beyond the goal, in addition to a tenth of the move, that counts as overshoot.
    static constexpr std::int64_t kOvershoot = 400;
    /// Number of replies that repeat a position while the velocity is not 0.
    static constexpr unsigned kFrozen = 5;
    /// If the motor is at rest by its own account, they also must add up to more than this, in counts per
    /// tick: the noise of its encoder is a velocity as well, now forward and now reverse.
    static constexpr int kFrozenAtRest = 100;

    /// `sent`: the registers after this command and all before it.
    void onSent(const ModuleCommand& command, const ServoRegisters& sent);
    /// Takes a believed report of this time. `servoRate`: of the module, empty if unknown. Returns what is
    /// wrong with the motion, once.
    [[nodiscard]] std::optional<MotionSuspect::Reason> onReport(const StatusReport& report, TimePoint time,
                                                                std::optional<int> servoRate);

private:
    struct Sent;
    /// For a trapezoidal move: from its start to its goal.
    struct Corridor {
        std::int64_t from = 0;
        std::int64_t goal = 0;
    };
    /// For velocity mode: the farthest position in its direction.
    struct Heading {
        int direction = 1;
        bool underWay = false;  ///< it has been seen moving in that direction
        std::int64_t best = 0;
    };
    struct LayoutPosition {
        std::uint8_t items = 0;
        std::int32_t position = 0;
    };

    void started(const ServoRegisters& sent);
    void forget();
    [[nodiscard]] std::optional<MotionSuspect::Reason> leaves(std::int64_t position, int velocity);
    [[nodiscard]] bool frozen(const StatusReport& report, TimePoint time, std::optional<int> servoRate);

    std::optional<std::int64_t> m_position;  ///< exceeds 32 bits if the counter has wrapped
    std::int16_t m_velocity = 0;             ///< has no fraction: also 0 in slow motion
    bool m_done = true;                      ///< a trapezoidal move has ended
    std::optional<Corridor> m_corridor;
    std::optional<Heading> m_heading;
    std::array<LayoutPosition, 2> m_last{};  ///< of the last two replies with a velocity, newest first
    TimePoint m_lastTime{};                  ///< of the newest
    unsigned m_repeats = 0;
    int m_sum = 0;  ///< of the velocities of those replies
};

}  // namespace nmc::bus
