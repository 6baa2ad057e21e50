// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include <tl/expected.hpp>

#include "bus/types.h"
#include "model/modulestate.h"

namespace nmc {

/// What the operator asks of one servo. Values only; planning it is plan()'s business.
namespace intent {
struct Enable {};  ///< amplifier on, hold the present position
struct GoTo {
    Counts position;
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
};
struct RunAtVelocity {
    CountsPerTick velocity;
    CountsPerTickSquared acceleration;
    bool reverse = false;
};
struct StopSmoothly {};
struct StopAbruptly {};
struct MotorOff {};
struct ApplyGains {
    servo::SetGain gains;
};
struct ClearStickyBits {};
struct ResetPosition {};  ///< "zero here"
}  // namespace intent

using Intent = std::variant<intent::Enable, intent::GoTo, intent::RunAtVelocity, intent::StopSmoothly,
                            intent::StopAbruptly, intent::MotorOff, intent::ApplyGains,
                            intent::ClearStickyBits, intent::ResetPosition>;

/// Why something cannot be asked for now; the window's texts have a sentence for each.
enum class Refusal : std::uint8_t {
    NotConnected,
    NotAServo,
    Silent,
    NoPower,
    GainsUnknown,    ///< a servo with gains 0 or unknown would not hold
    ServoOff,        ///< enable first
    Moving,          ///< trapezoidal moves start from standstill only
    NoAcceleration,  ///< with acceleration 0 nothing would ever move or stop
    NoVelocity,
};

/// The commands for an intent, in order, or why not. The same rule enables and disables the controls:
/// what whyNot() refuses is greyed out and says so.
[[nodiscard]] tl::expected<std::vector<bus::Step>, Refusal> plan(const Intent& intent,
                                                                 const ModuleState& module);

/// The kinds of request a panel shows a control for; values that are still being typed do not matter here.
enum class Request : std::uint8_t {
    Enable,
    Move,
    Run,
    Hold,
    StopMotion,
    MotorOff,
    ApplyGains,
    ClearStickyBits,
    ResetPosition
};
[[nodiscard]] std::optional<Refusal> whyNot(Request request, const ModuleState& module);

}  // namespace nmc
