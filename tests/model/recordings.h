// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/recording/recordingreader.h"

namespace nmc::testing_support {

/// A recording that was written by hand from the format's description, without the meaning of the columns.
inline const std::string kRecordingHead =
    "# NMC Panel recording 1\n"
    "# program: NMC Panel 0.6.0\n"
    "# started: 2026-11-21T21:21:02.123+01:00\n"
    "# port: simulator\n"
    "# simulated: yes (no real motor moved)\n"
    "# module 1 type: 0 (PIC-SERVO)\n"
    "# module 1 version: 4\n"
    "# module 1 name: Left arm\n"
    "# module 1 unit: millimetres\n"
    "# module 1 counts per unit: 1024.5\n"
    "# module 1 analog unit: A\n"
    "# module 1 analog per count: 0.25\n"
    "# module 1 analog at zero: -1.5\n"
    "# module 2 type: 3 (PIC-STEP)\n"
    "# module 2 version: 1\n"
    "# module 2 unit: counts or steps\n"
    "# module 2 counts per unit: 1\n"
    "# module 2 analog unit: V\n"
    "# module 2 analog per count: 0.5\n"
    "# module 2 analog at zero: 0\n";
/// The columns before PIC-I/O modules were supported; such files can still be opened.
inline const std::string kRecordingColumnLine =
    "module,time_s,position,velocity_per_s,command,error,error_low,error_high,analog,status,aux,gap\n";
inline const std::string kRecordingRows =
    "1,-0.000000001,1024,,1024.5,0.5,0,1,17,9,4,0\n"
    "# gains of module 1 at 0.500000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 3\n"
    "2,0.600000001,-2147483648,-12.25,,,,,255,0,63,1\n"
    "# note at 0.750000000 s: the motors were told to stop\n";
/// The columns as they are written now.
inline const std::string kWrittenColumnLine =
    "module,time_s,position,velocity_per_s,command,error,error_low,error_high,analog,status,aux,gap,analog2,"
    "analog3,counted\n";
inline const std::string kWrittenRows =
    "1,-0.000000001,1024,,1024.5,0.5,0,1,17,9,4,0,,,\n"
    "# gains of module 1 at 0.500000000 s: kp 100 kd 1000 ki 0 il 0 ol 255 cl 0 el 2000 sr 1 db 3\n"
    "2,0.600000001,-2147483648,-12.25,,,,,255,0,63,1,,,\n"
    "# note at 0.750000000 s: the motors were told to stop\n";
inline const std::string kRecording = kRecordingHead + kRecordingColumnLine + kRecordingRows;

inline RecordingHeader recordingHeader() {
    return {"NMC Panel 0.6.0",
            "2026-11-21T21:21:02.123+01:00",
            TimePoint{},
            "simulator",
            true,
            {{ModuleIndex(0),
              {ModuleType::Servo, 4},
              "Left arm",
              {UnitKind::Millimetres, 1024.5},
              {0.25, -1.5, "A"}},
             {ModuleIndex(1), {ModuleType::Stepper, 1}, "", {}, {0.5, 0.0, "V"}}}};
}

/// Everything that a reader passes on.
struct ReadRecording {
    RecordingHeader header;
    std::vector<std::pair<ModuleIndex, ScopeSample>> samples;
    std::vector<GainsChange> gains;
    std::optional<RecordingProblem> problem;
};

/// Reads `text` in pieces of `piece` bytes.
inline ReadRecording readRecording(std::string_view text, std::size_t piece = 7) {
    ReadRecording read;
    RecordingReader reader(
        {[&](ModuleIndex module, const ScopeSample& sample) { read.samples.emplace_back(module, sample); },
         [&](const GainsChange& change) { read.gains.push_back(change); }});
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
        if (!reader.feed(text.substr(0, piece)))
            break;
    read.problem = reader.finish();
    read.header = reader.header();
    return read;
}

}  // namespace nmc::testing_support
