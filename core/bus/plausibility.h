// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "bus/exchange.h"
#include "bus/rejection.h"
#include "bus/types.h"
#include "module/registers.h"

namespace nmc::bus {

/// Whether a reply of one module can be true, given what it said before and what was sent to it since
/// (link.md 2.4): the further nets behind an 8-bit sum. One object per module. Pure.
///
/// A reply that only contradicts what was known is not believed once; when the next one, after the link has
/// been checked, says the same, it is: another host may have moved or cleared something.
class Plausibility {
public:
    /// Largest speed of the encoder input, counts per tick: 500 000 edges/s (DS-V 3.2).
    static constexpr double kFastest = 256.0;
    /// Acceleration and speed to reckon with when nothing tells of more: a shaft that is turned by hand.
    /// Counts per tick squared, counts per tick.
    static constexpr double kGentle = 0.5;
    static constexpr double kByHand = 8.0;
    /// The same right after a command that may jerk the motor: that of a small motor at full voltage.
    static constexpr double kViolent = 8.0;
    /// How long a command may do that.
    static constexpr Duration kJerkTime = std::chrono::milliseconds(500);
    /// How far a servo may swing around where it should be, in counts.
    static constexpr double kSwing = 2000.0;
    /// How far a motor that stands still may be moved by a hand or its load before another reply has to say
    /// so too, in counts. Another module of its type can only be told from it by that.
    static constexpr double kNudge = 1024.0;
    /// Rounding, and a shaft that gives a little, in counts.
    static constexpr double kMargin = 16.0;
    /// Fastest stepper: 50 000 steps/s (DS-S 4.1), per tick.
    static constexpr double kFastestStepper = 25.6;

    explicit Plausibility(ModuleIdentity identity) : m_identity(identity) {}

    /// `command` goes out and will be latched at `latched`: what it may change is no contradiction. `sent`:
    /// after this command and all before it.
    void onSent(const ModuleCommand& command, const ServoRegisters& sent, TimePoint latched);

    /// Judges a reply whose sum is right. Nothing: it is believed, and later ones are judged by it.
    [[nodiscard]] std::optional<Rejection> check(const ReplyEnd& end);
    /// Since it was asked last, a position was believed that no motion leads to.
    [[nodiscard]] bool takeJump() { return std::exchange(m_jumped, false); }

private:
    /// What is remembered of the replies that were believed.
    struct Known {
        std::optional<std::uint8_t> status;
        std::optional<std::uint8_t> aux;
        std::optional<std::int32_t> home;
        std::optional<std::int32_t> position;
        std::optional<std::int16_t> velocity;
        bool allLow = false;  ///< PIC-I/O: its pins and A/D values are 0
        TimePoint from, to;   ///< the position was latched between these
        double spread = 0;    ///< of the velocities seen lately, counts per tick
        double fastest = 0;   ///< of them
        double swing = 0;     ///< speed that they did not tell of lately
    };
    /// Something a command may change without being contradicted: open until two replies that tell of it were
    /// latched well after the command.
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
    void jerk(TimePoint at, double reach);
    [[nodiscard]] double reachOf(const ServoRegisters& sent) const;
    [[nodiscard]] bool jerked(TimePoint at) const;
    [[nodiscard]] bool restsUncommanded(const Known& known, TimePoint at) const;
    [[nodiscard]] bool holds(const Known& known, const StatusReport& report) const;
    [[nodiscard]] double bend(TimePoint at, double most) const;
    [[nodiscard]] static double unexplained(const Known& known, const ReplyEnd& end);
    void take(Known& known, const ReplyEnd& end) const;

    ModuleIdentity m_identity;
    Known m_known;
    std::optional<Known> m_candidate;  ///< what a reply that contradicted said
    Rejection m_contradiction{};       ///< why it was rejected
    bool m_explained = false;          ///< somebody else may have set it going, as its own velocity tells
    bool m_jumped = false;             ///< true until takeJump()
    Allowance m_position;
    Allowance m_home;
    Allowance m_homing;
    Allowance m_sticky;
    Allowance m_motion;  ///< PIC-STEP: it may have started since the last reply
    /// A command may move the motor as fast as it can, but not farther than that.
    struct Jerk {
        TimePoint since;
        double reach = 0;  ///< counts
    };
    std::optional<Jerk> m_jerk;
    /// The last command that may move the motor, until a reply from behind it shows that it stands.
    std::optional<TimePoint> m_commandedAt;
    std::optional<std::uint16_t> m_errorLimit;  ///< EL as sent last
    bool m_mayRun = true;  ///< slower than its velocity item shows, until a stop or a move is sent
    std::optional<TimePoint> m_mayEnable;  ///< the last command that may have switched the servo on
    std::uint8_t m_divisor = 1;            ///< SR: velocities count per so many ticks (DS-V 5.2)
};

}  // namespace nmc::bus
