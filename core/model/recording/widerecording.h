// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "model/recording/recording.h"

namespace nmc {

/// The samples that `history` keeps individually in [from, to], as a table that PlotJuggler and pandas read
/// without further help: one column for the time, and one for each signal of each module, in the module's
/// unit. This program cannot read it back (RecordingProblem::Kind::OtherForm).
///
///     time_s,module1_Left_arm/position_mm,...,module2/status,about/started_2026-11-21T21:21:02.123+01:00,...
///     0.012000000,1.5,,1.51,0.01,0.3,120,-60,9,,,,,,,,,,
///
/// PlotJuggler takes the first line as the names, whatever it begins with, and rejects rows with a different
/// number of cells. The description of the table (program, start, port, whether it is simulated) is therefore
/// in the names of empty columns after all others, which both programs ignore.
///
/// Times are those of the long form (model/recording/recording.h). Without an `interval`, there is a row for
/// each status reply, and the cells of the other modules are empty. With it, there is a row every `interval`,
/// with values interpolated linearly between two samples, and the bytes of the previous sample; where samples
/// are missing, the cells are empty. The interval is increased so that there are at most kMaxWideRows.
///
/// Signals that no sample contains (DerivedSignals) are computed from everything that `history` keeps. Such a
/// value may belong to a moment between two replies, so in either form a row contains the linear
/// interpolation between two values. The user's own are the last ones before the status.
///
/// May take a second; time and memory grow with the samples.
[[nodiscard]] std::string wideRecordingOf(const RecordingHeader& header, const History& history,
                                          Duration interval = Duration::zero(),
                                          TimePoint from = TimePoint::min(), TimePoint to = TimePoint::max());

inline constexpr std::int64_t kMaxWideRows = 5'000'000;
/// The beginning of every such table.
inline constexpr std::string_view kWideTime = "time_s";

}  // namespace nmc
