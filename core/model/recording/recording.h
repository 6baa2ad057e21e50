// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/strong.h"
#include "model/scope/history.h"
#include "model/settings/axisscale.h"
#include "model/settings/machine.h"
#include "protocol/moduletype.h"

/// What the scope writes down: one CSV file, to be read by this program (model/recording/recordingreader.h),
/// by a spreadsheet and by people. UTF-8, line feeds, the C locale whatever the user's:
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
///
/// A row is a sample, in order of arrival; an empty cell is not known. Numbers read back to the last bit.
/// What this program reads again of the comments has no comma of its own, so that no spreadsheet tears it.
namespace nmc {

struct RecordingModule {
    ModuleIndex index;
    ModuleIdentity identity;
    std::string name;  ///< UTF-8
    AxisUnit unit;
    AnalogScale analog;
    PinSettings pins{};  ///< PIC-I/O: names and scales; others of its settings are not kept

    bool operator==(const RecordingModule&) const = default;
};

struct RecordingHeader {
    std::string program;    ///< name and version
    std::string startedAt;  ///< ISO 8601 with the offset of the zone, of `zero`
    TimePoint zero;         ///< what times count from; TimePoint{} after reading
    std::string port;
    bool simulated = false;
    std::vector<RecordingModule> modules;

    bool operator==(const RecordingHeader&) const = default;
};

inline constexpr int kRecordingVersion = 1;
/// The first line but for the version.
inline constexpr std::string_view kRecordingMagic = "# NMC Panel recording ";
inline constexpr std::string_view kRecordingSuffix = "csv";

enum class RecordingColumn : std::uint8_t {
    Module,
    Time,
    Position,
    Velocity,
    Command,  ///< follows from position and error; only for other readers
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
/// By RecordingColumn.
inline constexpr std::array<std::string_view, 15> kRecordingColumns{
    "module", "time_s",    "position",   "velocity_per_s", "command",
    "error",  "error_low", "error_high", "analog",         "status",
    "aux",    "gap",       "analog2",    "analog3",        "counted"};

/// Key and value of what a file says of where its samples are from. The views live as long as `header`.
[[nodiscard]] std::array<std::pair<std::string_view, std::string_view>, 4> originOf(
    const RecordingHeader& header);
/// Comments that say where the samples of a file are from: program, start, port, and whether it is simulated.
void appendOrigin(std::string& out, const RecordingHeader& header);

/// Everything above the first row.
[[nodiscard]] std::string recordingHead(const RecordingHeader& header);

/// One row. `zero` as in the header; within ten years of it.
void appendRow(std::string& out, ModuleIndex module, const ScopeSample& sample, TimePoint zero);

/// A comment from where on these gains were in force.
void appendGains(std::string& out, const GainsChange& change, TimePoint zero);

/// A comment for people. Control characters become question marks, and long texts are cut.
void appendNote(std::string& out, std::string_view text, TimePoint time, TimePoint zero);

/// A whole recording: what `history` keeps one by one, in the order of time. May be made in any thread.
[[nodiscard]] std::string recordingOf(const RecordingHeader& header, const History& history);

}  // namespace nmc
