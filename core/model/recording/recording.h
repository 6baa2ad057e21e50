// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/strong.h"
#include "model/scope/customsignal.h"
#include "model/scope/history.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"
#include "protocol/moduletype.h"

/// What the scope saves: a CSV file for this program (model/recording/recordingreader.h), for spreadsheets
/// and for people. UTF-8, line feeds, the C locale regardless of the user's:
///
///     # NMC Panel recording 1
///     # program: NMC Panel 0.6.0
///     # started: 2026-11-21T21:21:02.123+01:00
///     # port: simulator
///     # simulated: yes (no real motor moved)
///     # module 1 type: 0 (PIC-SERVO)
///     # module 1 version: 4
///     # module 1 name: Left arm
///     # module 1 unit: millimetres
///     # module 1 counts per unit: 1024.5
///     # module 1 analog unit: V
///     # module 1 analog per count: 0.0196
///     # module 1 analog at zero: 0
///     # ... what the columns mean ...
///     module,time_s,position,...,error_high,analog,status,aux,gap,analog2,analog3,counted
///     1,0.012000000,1024,,1024.5,0.5,0,1,17,9,4,0,,,
///     # gains of module 1 at 0.500000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 0
///     # note at 0.750000000 s: the motors were told to stop
///     # note at 0.900000000 s: gains of module 1 unknown
///
/// Each row is a sample, in order of arrival; an empty cell means unknown. Numbers read back exactly. Those
/// parts of the comments that this program reads back contain no commas of their own, so that no spreadsheet
/// splits them.
namespace nmc {

/// A signal that the user has defined.
struct RecordingTrace {
    std::string name, unit;  ///< UTF-8
    double step = 1;         ///< in its unit; the values of `signal` are multiples of it
    CustomSignal signal;
    bool operator==(const RecordingTrace&) const = default;
};

struct RecordingModule {
    ModuleIndex index;
    ModuleIdentity identity;
    std::string name;  ///< UTF-8
    AxisUnit unit;
    AnalogScale analog;
    PinSettings pins{};  ///< PIC-I/O: only the names and scales are kept
    /// Only in a table with one column per signal (model/recording/widerecording.h).
    std::vector<RecordingTrace> custom{};

    bool operator==(const RecordingModule&) const = default;
};

struct RecordingHeader {
    std::string program;    ///< name and version
    std::string startedAt;  ///< time of `zero`, ISO 8601 with the zone offset
    TimePoint zero;         ///< the origin of times; TimePoint{} after reading
    std::string port;
    bool simulated = false;
    std::vector<RecordingModule> modules;

    bool operator==(const RecordingHeader&) const = default;
};

inline constexpr int kRecordingVersion = 1;
/// The first line without the version.
inline constexpr std::string_view kRecordingMagic = "# NMC Panel recording ";
inline constexpr std::string_view kRecordingSuffix = "csv";

enum class RecordingColumn : std::uint8_t {
    Module,
    Time,
    Position,
    Velocity,
    Command,  ///< derived from position and error; only for other readers
    Error,
    ErrorLow,
    ErrorHigh,
    Analog,
    Status,
    Aux,
    Gap,
    // PIC-I/O only
    Analog2,
    Analog3,
    Counted,
};
/// Indexed by RecordingColumn.
inline constexpr std::array<std::string_view, 15> kRecordingColumns{
    "module", "time_s",    "position",   "velocity_per_s", "command",
    "error",  "error_low", "error_high", "analog",         "status",
    "aux",    "gap",       "analog2",    "analog3",        "counted"};

/// Keys and values that describe the origin of a file's samples. The views live as long as `header`.
[[nodiscard]] std::array<std::pair<std::string_view, std::string_view>, 4> originOf(
    const RecordingHeader& header);
/// Appends comments that describe the origin of a file's samples: program, start, port, and whether it is
/// simulated.
void appendOrigin(std::string& out, const RecordingHeader& header);

/// Everything above the first row.
[[nodiscard]] std::string recordingHead(const RecordingHeader& header);

/// Appends one row. `zero` is the one in the header; `sample` must be within ten years of it.
void appendRow(std::string& out, ModuleIndex module, const ScopeSample& sample, TimePoint zero);

/// Appends a comment with gains and the time from which they are in force.
void appendGains(std::string& out, const GainsChange& change, TimePoint zero);

/// Appends a comment for people. Control characters become question marks, and long texts are cut.
void appendNote(std::string& out, std::string_view text, TimePoint time, TimePoint zero);

/// A whole recording: the samples that `history` keeps individually, in order of time. Any thread may call
/// this.
[[nodiscard]] std::string recordingOf(const RecordingHeader& header, const History& history);

}  // namespace nmc
