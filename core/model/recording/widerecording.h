// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "model/recording/recording.h"

namespace nmc {

/// What `history` keeps one by one of [from, to] as a table that PlotJuggler and pandas read without help:
/// one column for the time and one for each signal of each module, in the module's unit. It cannot be read
/// again here (RecordingProblem::Kind::OtherForm).
///
///     time_s,module1_Left_arm/position_mm,...,module2/status,about/started_2026-11-21T21:21:02.123+01:00,...
///     0.012000000,1.5,,1.51,0.01,0.3,120,-60,9,,,,,,,,,,
///
/// PlotJuggler takes the first line for the names, whatever it begins with, and refuses rows that have not as
/// many cells. So what the table is (program, start, port, whether it is simulated) stands in the names of
/// empty columns behind all others, which both programs pass over.
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
/// What every such table begins with.
inline constexpr std::string_view kWideTime = "time_s";

}  // namespace nmc
