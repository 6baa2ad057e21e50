// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "bus/exchange.h"
#include "bus/rejection.h"
#include "bus/types.h"
#include "module/registers.h"
#include "protocol/laterservocommands.h"

namespace nmc::bus {

/// Verifies whether a reply of one module is plausible, given its earlier replies and what was sent to it
/// since (link.md 2.4): additional nets behind the 8-bit sum. One object per module. Pure.
///
/// A reply that only contradicts earlier ones is not believed the first time; if the next one, after the link
/// has been checked, agrees with it, it is: another host may have moved or cleared something.
class Plausibility {
public:
    /// Maximum speed of the encoder input, in counts per tick: 500 000 edges/s (DS-V 3.2); with CMC and SC,
    /// their greatest velocity (docs/family.md).
    static constexpr double kFastest = 256.0;
    static constexpr double kFastestLater =
        static_cast<double>(servo::kLaterVelocityRange.max) / kFixedPointOne;
    /// Acceleration and speed to allow for without any evidence of more: a shaft that is turned by hand.
    /// Counts per tick squared, counts per tick.
    static constexpr double kGentle = 0.5;
    static constexpr double kByHand = 8.0;
    /// The acceleration to allow for right after a command that may jerk the motor: a small motor at full
    /// voltage.
    static constexpr double kViolent = 8.0;
    /// How long a command may have that effect.
    static constexpr Duration kJerkTime = std::chrono::milliseconds(500);
    /// How far a servo may swing about its position, in counts.
    static constexpr double kSwing = 2000.0;
    /// How far a motor at rest may be moved by hand or by its load before a second reply must confirm it, in
    /// counts. Only this distinguishes it from another module of its type.
    static constexpr double kNudge = 1024.0;
    /// Allowance for rounding and a slightly yielding shaft, in counts.
    static constexpr double kMargin = 16.0;
    /// Fastest stepper: 50 000 steps/s (DS-S 4.1), per tick.
    static constexpr double kFastestStepper = 25.6;

    explicit Plausibility(ModuleIdentity identity) : m_identity(identity) {}
    /// The module was found as another host left it.
    void attach() { m_divisor.reset(); }

    /// `command` is sent and will be latched at `latched`: what it may change is not a contradiction. `sent`:
    /// the registers after this command and all before it.
    void onSent(const ModuleCommand& command, const ServoRegisters& sent, TimePoint latched);
    /// The last command was answered as carried out.
    void onAnswered(const ModuleCommand& command);

    /// Verifies a reply whose sum is right. Returns nothing if it is believed; later replies are then
    /// compared with it.
    [[nodiscard]] std::optional<Rejection> check(const ReplyEnd& end);
    /// True if, since the last call, a position was believed to which no motion leads.
    [[nodiscard]] bool takeJump() { return std::exchange(m_jumped, false); }

private:
    /// The content of the believed replies.
    struct Known {
        std::optional<std::uint8_t> status;
        std::optional<std::uint8_t> aux;
        std::optional<std::int32_t> home;
        std::optional<std::int32_t> position;
        std::optional<std::int16_t> velocity;
        bool moved = false;   ///< PIC-STEP: it was moving with the position, or in a reply since
        bool allLow = false;  ///< PIC-I/O: its pins and A/D values are 0
        TimePoint from, to;   ///< the position was latched between these
        double spread = 0;    ///< of recent velocities, counts per tick
        double fastest = 0;   ///< magnitude of recent velocities, counts per tick
        double swing = 0;     ///< recent speed that the velocities did not explain
    };
    /// A value that a command may change without this being a contradiction: open until two replies that
    /// contain it were latched well after the command.
    struct Allowance {
        TimePoint since{};
        unsigned replies = 0;
        void open(TimePoint latched) { since = latched, replies = 2; }
        [[nodiscard]] bool isOpen() const { return replies > 0; }
        void onReply(TimePoint latched);
    };
    struct Sent;

    [[nodiscard]] std::optional<Rejection> structure(const ReplyEnd& end) const;
    [[nodiscard]] std::optional<Rejection> servoStructure(const StatusReport& report) const;
    [[nodiscard]] std::optional<Rejection> stepperStructure(const StatusReport& report) const;
    [[nodiscard]] std::optional<Rejection> against(const Known& known, const ReplyEnd& end) const;
    [[nodiscard]] bool repeatsZeros(const StatusReport& report) const;
    [[nodiscard]] bool onWithoutPower(const ReplyEnd& end) const;
    [[nodiscard]] bool stickyCleared(const Known& known, const StatusReport& report) const;
    [[nodiscard]] std::optional<Rejection> motion(const Known& known, const ReplyEnd& end) const;
    [[nodiscard]] std::optional<Rejection> servoMotion(const Known& known, const ReplyEnd& end,
                                                       bool rests) const;
    [[nodiscard]] bool explainedByItsSpeed(const ReplyEnd& end) const;
    [[nodiscard]] std::optional<Rejection> stepperMotion(const Known& known, const ReplyEnd& end) const;
    [[nodiscard]] double fastest() const { return hasPathBuffer(m_identity) ? kFastestLater : kFastest; }
    void jerk(TimePoint at, double reach);
    [[nodiscard]] double reachOf(const ServoRegisters& sent) const;
    [[nodiscard]] bool jerked(TimePoint at) const;
    [[nodiscard]] bool restsUncommanded(const Known& known, TimePoint at) const;
    [[nodiscard]] bool holds(const Known& known, const StatusReport& report) const;
    [[nodiscard]] double bend(TimePoint at, double most) const;
    [[nodiscard]] double unexplained(const Known& known, const ReplyEnd& end) const;
    void take(Known& known, const ReplyEnd& end) const;

    ModuleIdentity m_identity;
    Known m_known;
    std::optional<Known> m_candidate;  ///< content of a contradicting reply
    Rejection m_contradiction{};       ///< why that reply was implausible
    bool m_explained = false;  ///< the reply's own velocity suggests that another host started a motion
    bool m_jumped = false;     ///< true until takeJump()
    Allowance m_position;
    std::optional<std::int32_t> m_counter;  ///< what the last command sets the counter to, if that is known
    Allowance m_home;
    Allowance m_homing;
    Allowance m_sticky;
    Allowance m_motion;  ///< PIC-STEP: it may have started since the last reply
    /// A command may move the motor as fast as it can, but not farther than `reach`.
    struct Jerk {
        TimePoint since;
        double reach = 0;  ///< counts
    };
    std::optional<Jerk> m_jerk;
    /// The last command that may move the motor, until a later reply shows it at rest.
    std::optional<TimePoint> m_commandedAt;
    std::optional<std::uint16_t>
        m_errorLimit;      ///< the largest EL since the last answered one; empty if unknown
    bool m_mayRun = true;  ///< it may run below the velocity item's resolution, until a stop or move
    std::optional<TimePoint> m_mayEnable;  ///< the last command that may have switched the servo on
    /// SR, the largest since the last answered one: velocities are in counts per this many ticks (DS-V 5.2);
    /// empty if unknown.
    std::optional<std::uint8_t> m_divisor = 1;
};

}  // namespace nmc::bus
