// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "model/intent/responsetaken.h"
#include "model/response/responsemetrics.h"

namespace nmc {

/// When a move counts as settled: the motor is within `counts` of its goal for at least `dwell` seconds.
struct SettleWindow {
    double counts = 5.0;
    double dwell = 0.05;
};

/// The figures that characterize a profiled move. Errors are command position minus position.
struct MoveMetrics {
    double moveTime = 0.0;  ///< s, duration of the commanded profile, known to a servo tick
    Figure settling;        ///< s, from the end of the profile until the motor has settled, without the dwell
    Figure peak;            ///< counts, the largest error, without its sign
    Figure rms;             ///< counts, over the duration of the profile
    Figure slew;            ///< counts, mean over the second half of the time at constant velocity
};

/// `points` must be in order of time and have an error. `timeDoubt`: s, possible error of the time between
/// two points. Doubts are as in ResponseMetrics; that of an error is half a count, and more at a servo rate
/// below the highest, where it is not known in which tick the chip moves the command. The end of the profile
/// is known to a servo tick, which is part of the doubt of the settling time.
[[nodiscard]] MoveMetrics measureMove(std::span<const ResponsePoint> points, const ResponseTaken& taken,
                                      const SettleWindow& window, double timeDoubt);

}  // namespace nmc
