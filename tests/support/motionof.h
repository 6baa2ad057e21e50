// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>
#include <variant>

#include "model/intent/intent.h"

namespace nmc::test {

/// The motion that a Move or a LoadMove requests; throws if it is another motion, or `wanted` another intent.
template <typename Motion>
[[nodiscard]] Motion motionOf(const Intent& wanted) {
    using Chip = std::conditional_t<In<Motion, ServoMotion>, ServoMotion, StepperMotion>;
    const auto* load = std::get_if<intent::LoadMove>(&wanted);
    const MotionSpec& motion = load != nullptr ? load->motion : std::get<intent::Move>(wanted).motion;
    return std::get<Motion>(std::get<Chip>(motion));
}

}  // namespace nmc::test
