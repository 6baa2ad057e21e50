// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/recording/recording.h"

namespace nmc {

/// What `history` keeps one by one of [from, to] as a table that PlotJuggler and pandas read without help: no
/// comments, one column for the time and one for each signal of each module, in the module's unit.
///
///     time_s,module1_Left_arm/position_mm,module1_Left_arm/velocity_mm_per_s,...,module2/status
///     0.012000000,1.5,,1.51,0.01,0.3,120,-60,9,,,,,,,
///
/// Times are those of the long form (model/recording/recording.h). Without an `interval` there is a row for
/// each status reply, and the cells of the other modules are empty. With it there is a row every `interval`,
/// with what is on a straight line between two samples, and the bytes of the sample before; where samples are
/// missing the cells are empty. Its step is enlarged until there are at most kMaxWideRows.
///
/// Signals that no sample has (DerivedSignals) are made of all that `history` keeps. Such a value may be of a
/// moment between two replies: in either form a row has what is on a straight line between two values.
///
/// May take a second; time and memory grow with the samples.
[[nodiscard]] std::string wideRecordingOf(const RecordingHeader& header, const History& history,
                                          Duration interval = Duration::zero(),
                                          TimePoint from = TimePoint::min(), TimePoint to = TimePoint::max());

inline constexpr std::int64_t kMaxWideRows = 5'000'000;

}  // namespace nmc
