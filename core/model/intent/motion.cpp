// SPDX-License-Identifier: MIT
#include "model/intent/motion.h"

#include "base/overloaded.h"

namespace nmc {

MotionSpec moveTo(std::int32_t position, const Pace& pace) {
    return std::visit(
        Overloaded{
            [&](const ServoPace& servo) -> MotionSpec {
                return servomotion::Trapezoid{Counts(position), servo.velocity, servo.acceleration};
            },
            [&](const bus::StepperPace& stepper) -> MotionSpec {
                return steppermotion::Trapezoid{position, false, stepper.speed, stepper.accelerationTime};
            },
        },
        pace);
}

std::optional<std::int64_t> goalOf(const MotionSpec& motion, std::int32_t from) {
    const auto goal = [from](const auto& move) -> std::optional<std::int64_t> {
        if constexpr (requires { move.relative; })
            return move.relative ? std::int64_t{from} + move.position : std::int64_t{move.position};
        else if constexpr (requires { move.position; })
            return move.position.value();
        else
            return std::nullopt;
    };
    return std::visit([&](const auto& chip) { return std::visit(goal, chip); }, motion);
}

MotionSpec endingAt(std::int32_t position, MotionSpec motion) {
    const auto end = [position](auto& move) {
        if constexpr (requires { move.relative; }) {
            move.position = position;
            move.relative = false;
        } else if constexpr (requires { move.position; }) {
            move.position = Counts(position);
        }
    };
    std::visit([&](auto& chip) { std::visit(end, chip); }, motion);
    return motion;
}

}  // namespace nmc
