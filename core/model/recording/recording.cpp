// SPDX-License-Identifier: MIT
#include "model/recording/recording.h"

#include <algorithm>
#include <cmath>

#include "base/numbertext.h"
#include "base/text.h"
#include "model/recording/recordingcells.h"
#include "model/recording/recordingwords.h"
#include "protocol/servocommands.h"

namespace nmc {

namespace {

constexpr std::size_t kMaxText = 500;  ///< bytes of one value

constexpr std::string_view kMeaning =
    "#\n"
    "# One row per status reply in the order of arrival. An empty cell is not known.\n"
    "# module = 1 is the module farthest from the computer\n"
    "# time_s = seconds since the start when the module latched the reply\n"
    "# position = counts of a PIC-SERVO or steps of a PIC-STEP, 32 bits that wrap\n"
    "# velocity_per_s = counts or steps per second from the positions of the last 20 ms\n"
    "# command = where the module was commanded to be by that time (calculated) in counts or steps\n"
    "# error = command minus position (calculated) and the true error is from error_low to error_high\n"
    "# analog = the A/D byte, which stands for analog at zero + byte x analog per count\n"
    "# PIC-I/O: position = its counter or timer and analog2 and analog3 = its other A/D bytes\n"
    "# PIC-I/O: status = levels of IO1 (1) to IO8 (128) and aux = levels of IO9 (1) to IO12 (8)\n"
    "# PIC-I/O: counted = 1 where the reply had the counter, which otherwise stands as it was\n"
    "# status and aux = bytes as in the data sheet, decimal, aux of a PIC-STEP being its inputs\n"
    "# gap = 1 where replies of this module are missing before the row\n"
    "# Divide by counts per unit to get the unit of the module.\n"
    "#\n";

/// Appends a cell for each number; that of an unknown one is empty.
template <typename... Reals>
void appendReals(std::string& out, Reals... numbers) {
    ((out += ',', std::isfinite(numbers) ? appendNumber(out, numbers) : void()), ...);
}

void appendEntry(std::string& out, std::string_view key, std::string_view value) {
    if (!value.empty())
        out.append("# ").append(key).append(words::kBehindKey).append(oneLine(value, kMaxText)) += '\n';
}

/// An ADC is written as the bare number, like a type without a name.
std::string typeText(ModuleType type) {
    const std::string number = std::to_string(static_cast<int>(type));
    const std::string_view name = type == ModuleType::Adc ? std::string_view() : familyName(type);
    return name.empty() ? number : number + " (" + std::string(name) + ')';
}

void appendModule(std::string& out, const RecordingModule& module) {
    const std::string prefix = std::string(words::kModule) + std::to_string(module.index.value() + 1) + ' ';
    const auto entry = [&](std::string_view key, std::string_view value) {
        appendEntry(out, prefix + std::string(key), value);
    };
    entry(words::kType, typeText(module.identity.type));
    entry(words::kVersion, std::to_string(module.identity.version));
    entry(words::kName, module.name);
    entry(words::kUnit, words::kUnits[static_cast<std::size_t>(module.unit.kind)]);
    entry(words::kOwnSymbol, module.unit.ownSymbol);
    entry(words::kPerUnit, textOf(module.unit.countsPerUnit));
    entry(words::kAnalogUnit, module.analog.unit);
    entry(words::kAnalogPerCount, textOf(module.analog.perCount));
    entry(words::kAnalogAtZero, textOf(module.analog.atZero));
    const auto numbered = [](std::string_view word, std::size_t i, std::string_view key) {
        return std::string(word) + std::to_string(i + 1) + ' ' + std::string(key);
    };
    for (std::size_t i = 0; i < module.pins.pins.size(); ++i)
        entry(numbered(words::kPin, i, words::kName), module.pins.pins[i].name);
    for (std::size_t i = 0; i < module.pins.analog.size(); ++i) {
        const AnalogInput& input = module.pins.analog[i];
        entry(numbered(words::kAnalogInput, i, words::kName), input.name);
        entry(numbered(words::kAnalogInput, i, words::kInputUnit), input.scale.unit);
        entry(numbered(words::kAnalogInput, i, words::kInputPerCount), textOf(input.scale.perCount));
        entry(numbered(words::kAnalogInput, i, words::kInputAtZero), textOf(input.scale.atZero));
    }
}

void appendColumnNames(std::string& out) {
    for (const std::string_view name : kRecordingColumns)
        out.append(name) += name == kRecordingColumns.back() ? '\n' : ',';
}

void appendBytes(std::string& out, const ScopeSample& sample) {
    for (const int byte : {+sample.analog, +sample.status, +sample.aux}) {
        out += ',';
        appendNumber(out, byte);
    }
    out += sample.gapBefore ? ",1" : ",0";
}

/// Appends the rest of a PIC-I/O's row, from its position on.
void appendPins(std::string& out, const ScopeSample& sample) {
    appendNumber(out, static_cast<std::int32_t>(sample.counter()));
    out += ",,,,,";
    appendBytes(out, sample);
    appendReals(out, sample.error, sample.velocity);
    out += sample.counted ? ",1\n" : ",0\n";
}

}  // namespace

std::array<std::pair<std::string_view, std::string_view>, 4> originOf(const RecordingHeader& header) {
    return {{{words::kProgram, header.program},
             {words::kStarted, header.startedAt},
             {words::kPort, header.port},
             {words::kSimulated, header.simulated ? "yes (no real motor moved)" : "no"}}};
}

void appendOrigin(std::string& out, const RecordingHeader& header) {
    for (const auto& [key, value] : originOf(header))
        appendEntry(out, key, value);
}

std::string recordingHead(const RecordingHeader& header) {
    std::string out(kRecordingMagic);
    out += std::to_string(kRecordingVersion) + '\n';
    appendOrigin(out, header);
    for (const RecordingModule& module : header.modules)
        appendModule(out, module);
    out += kMeaning;
    appendColumnNames(out);
    return out;
}

void appendRow(std::string& out, ModuleIndex module, const ScopeSample& sample, TimePoint zero) {
    appendNumber(out, module.value() + 1);
    out += ',';
    out += cells::timeText(sample.time - zero);
    out += ',';
    if (sample.io)
        return appendPins(out, sample);
    appendNumber(out, sample.position);
    appendReals(out, sample.velocity, sample.command(), sample.error, sample.errorLow, sample.errorHigh);
    appendBytes(out, sample);
    out += ",,,\n";
}

void appendGains(std::string& out, const GainsChange& change, TimePoint zero) {
    if (!change.gains)
        return appendNote(out,
                          std::string(words::kGains) + std::to_string(change.module.value() + 1) +
                              std::string(words::kUnknown),
                          change.time, zero);
    out.append("# ").append(words::kGains);
    appendNumber(out, change.module.value() + 1);
    out += words::kAt;
    out += cells::timeText(change.time - zero);
    out += words::kSeconds;
    const auto append = [&out](std::string_view word, std::optional<int> value, ValueRange /*range*/) {
        if (!value || word == words::kNotRecorded)
            return;
        out.append(word) += ' ';
        appendNumber(out, *value);
        out += ' ';
    };
    servo::forEachGain(*change.gains, append);
    out.back() = '\n';
}

void appendNote(std::string& out, std::string_view text, TimePoint time, TimePoint zero) {
    out.append("# ").append(words::kNote).append(words::kAt);
    out += cells::timeText(time - zero);
    out.append(words::kSeconds).append(oneLine(text, kMaxText)) += '\n';
}

std::string recordingOf(const RecordingHeader& header, const History& history) {
    struct Next {
        ModuleIndex module;
        std::vector<ScopeSample> samples;
        std::size_t place = 0;
        [[nodiscard]] bool over() const { return place == samples.size(); }
        [[nodiscard]] TimePoint time() const { return samples[place].time; }
    };
    std::vector<Next> modules;
    for (std::size_t i = 0; i < history.modules(); ++i) {
        const ModuleIndex module(static_cast<std::uint8_t>(i));
        modules.push_back({module, history.module(module)->samples(TimePoint::min(), TimePoint::max())});
    }
    std::string out = recordingHead(header);
    auto gains = history.gains().begin();
    for (;;) {
        const auto next = std::ranges::min_element(modules, [](const Next& a, const Next& b) {
            return !a.over() && (b.over() || a.time() < b.time());
        });
        const bool over = next == modules.end() || next->over();
        for (; gains != history.gains().end() && (over || gains->time <= next->time()); ++gains)
            appendGains(out, *gains, header.zero);
        if (over)
            return out;
        appendRow(out, next->module, next->samples[next->place++], header.zero);
    }
}

}  // namespace nmc
