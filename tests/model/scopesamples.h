// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/time.h"
#include "model/scope/scopesample.h"

/// Samples with a time and a position, and times from milliseconds.
namespace nmc::testing_support {

[[nodiscard]] inline TimePoint atMs(double milliseconds) {
    return TimePoint(fromSeconds(milliseconds / 1e3));
}

[[nodiscard]] inline ScopeSample sampleAt(TimePoint time, std::int32_t position) {
    ScopeSample sample;
    sample.time = time;
    sample.position = position;
    return sample;
}
[[nodiscard]] inline ScopeSample sampleAt(double seconds, std::int32_t position) {
    return sampleAt(TimePoint(fromSeconds(seconds)), position);
}

}  // namespace nmc::testing_support
