// SPDX-License-Identifier: MIT
#include "model/recording/recordingcomments.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/recording/recordingwords.h"
#include "protocol/iocommands.h"
#include "protocol/servocommands.h"

namespace nmc::comments {

namespace {

constexpr cells::Bounds kAnyReal{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

/// Removes and returns the text before the mark, and removes the mark; returns everything if there is none.
std::string_view upTo(std::string_view mark, std::string_view& text) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const std::string_view before = text.substr(0, end);
    text.remove_prefix(std::min(end + mark.size(), text.size()));
    return before;
}
std::string_view nextWord(std::string_view& text) {
    return upTo(" ", text);
}

bool skip(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix))
        return false;
    text.remove_prefix(prefix.size());
    return true;
}

std::optional<ModuleIndex> moduleOf(std::string_view number) {
    const auto value = cells::whole(number, kModules);
    if (!value)
        return std::nullopt;
    return ModuleIndex(static_cast<std::uint8_t>(*value - 1));
}

RecordingModule& moduleIn(RecordingHeader& header, ModuleIndex index) {
    for (RecordingModule& known : header.modules)
        if (known.index == index)
            return known;
    RecordingModule& added = header.modules.emplace_back();
    added.index = index;
    added.analog.unit.clear();  // what is not in the file is empty, not the default
    return added;
}

/// A numeric entry of a module.
struct NumberEntry {
    std::string_view field;
    std::string_view text;

    template <typename Byte>
    std::optional<RecordingProblem> byteInto(Byte& byte) const {
        std::string_view rest = text;
        const auto number = cells::whole(nextWord(rest), kBytes);
        if (!number)
            return problemOf(number.error(), field, text, kBytes);
        byte = static_cast<Byte>(*number);
        return std::nullopt;
    }
    std::optional<RecordingProblem> realInto(double& real, cells::Bounds bounds) const {
        const auto number = cells::real(text, bounds);
        if (!number)
            return problemOf(number.error(), field, text, bounds);
        real = *number;
        return std::nullopt;
    }
};

/// Returns true when the key was one of the texts.
bool takeText(std::string_view key, std::string_view value, RecordingModule& module) {
    for (const auto& [name, text] :
         {std::pair{words::kName, &module.name}, std::pair{words::kOwnSymbol, &module.unit.ownSymbol},
          std::pair{words::kAnalogUnit, &module.analog.unit}})
        if (key == name) {
            *text = value;
            return true;
        }
    return false;
}

/// Removes the number before a key and returns it counted from 0; nothing if there is none. In the file it
/// counts from 1.
std::optional<std::size_t> numberBefore(std::string_view& key, double most) {
    std::string_view rest = key;
    const auto number = cells::whole(nextWord(rest), {1, most});
    if (!number)
        return std::nullopt;
    key = rest;
    return static_cast<std::size_t>(*number - 1);
}

/// Takes an entry about the pins of a PIC-I/O. Returns true when the key was one of these.
bool takePinEntry(std::string_view key, const NumberEntry& entry, PinSettings& pins,
                  std::optional<RecordingProblem>& problem) {
    if (skip(key, words::kPin)) {
        const auto pin = numberBefore(key, io::kPins);
        if (!pin || key != words::kName)
            return false;
        PinSettings::in(pins.pins, *pin).name = entry.text;
        return true;
    }
    if (!skip(key, words::kAnalogInput))
        return false;
    const auto input = numberBefore(key, 3);
    if (!input)
        return false;
    const std::size_t known = pins.analog.size();
    AnalogInput& analog = PinSettings::in(pins.analog, *input);
    for (std::size_t i = known; i < pins.analog.size(); ++i)
        pins.analog[i].scale.unit.clear();  // what is not in the file is empty, not the default
    if (key == words::kName)
        analog.name = entry.text;
    else if (key == words::kInputUnit)
        analog.scale.unit = entry.text;
    else if (key == words::kInputPerCount)
        problem = entry.realInto(analog.scale.perCount, kAnyReal);
    else if (key == words::kInputAtZero)
        problem = entry.realInto(analog.scale.atZero, kAnyReal);
    else
        return false;
    return true;
}

std::optional<RecordingProblem> takeModuleEntry(std::string_view key, std::string_view value,
                                                RecordingHeader& header) {
    const std::string_view field = key;
    skip(key, words::kModule);
    const auto index = moduleOf(nextWord(key));
    if (!index)
        return std::nullopt;
    RecordingModule& module = moduleIn(header, *index);
    const NumberEntry number{field, value};
    if (key == words::kType)
        return number.byteInto(module.identity.type);
    if (key == words::kVersion)
        return number.byteInto(module.identity.version);
    if (key == words::kPerUnit)
        return number.realInto(module.unit.countsPerUnit, {kMinCountsPerUnit, kMaxCountsPerUnit, true});
    if (key == words::kAnalogPerCount)
        return number.realInto(module.analog.perCount, kAnyReal);
    if (key == words::kAnalogAtZero)
        return number.realInto(module.analog.atZero, kAnyReal);
    std::optional<RecordingProblem> problem;
    if (takePinEntry(key, number, module.pins, problem))
        return problem;
    const auto unit = std::find(words::kUnits.begin(), words::kUnits.end(), value);
    if (!takeText(key, value, module) && key == words::kUnit && unit != words::kUnits.end())
        module.unit.kind = static_cast<UnitKind>(unit - words::kUnits.begin());
    return std::nullopt;
}

std::optional<servo::SetGain> gainValues(std::string_view text) {
    servo::SetGain gains;
    bool good = true;
    const auto read = [&](std::string_view word, auto& value, ValueRange range) {
        if (word == words::kNotRecorded || (word == words::kDeadband && text.empty()))
            return;
        good = good && nextWord(text) == word;
        const auto number =
            cells::whole(nextWord(text), {static_cast<double>(range.min), static_cast<double>(range.max)});
        good = good && number;
        if (good)
            value = static_cast<std::decay_t<decltype(value)>>(*number);
    };
    servo::forEachGain(gains, read);
    if (!good || !text.empty())
        return std::nullopt;
    return gains;
}

}  // namespace

std::string shown(std::string_view text) {
    constexpr std::size_t kMax = 40;
    std::string cut(text.substr(0, kMax));
    std::ranges::replace_if(
        cut, [](char c) { return c < 0x20 || c > 0x7E; }, '?');
    return cut;
}

RecordingProblem problemOf(cells::Fault fault, std::string_view field, std::string_view found,
                           cells::Bounds bounds) {
    if (fault == cells::Fault::NotANumber)
        return {.kind = RecordingProblem::Kind::NotANumber, .field = shown(field), .found = shown(found)};
    return {.kind = RecordingProblem::Kind::OutOfRange,
            .field = shown(field),
            .found = shown(found),
            .min = bounds.min,
            .max = bounds.max};
}

std::optional<RecordingProblem> takeHeadEntry(std::string_view text, RecordingHeader& header) {
    const std::size_t colon = text.find(words::kBehindKey);
    if (colon == std::string_view::npos)
        return std::nullopt;
    const std::string_view key = text.substr(0, colon);
    const std::string_view value = text.substr(colon + words::kBehindKey.size());
    if (key.starts_with(words::kModule))
        return takeModuleEntry(key, value, header);
    if (key == words::kProgram)
        header.program = value;
    else if (key == words::kStarted)
        header.startedAt = value;
    else if (key == words::kPort)
        header.port = value;
    else if (key == words::kSimulated)
        header.simulated = value.starts_with("yes");
    return std::nullopt;
}

/// Reads the note that the gains of a module are no longer known.
static std::optional<GainsChange> lostGainsOf(std::string_view text) {
    if (!skip(text, words::kAt) || !text.ends_with(words::kUnknown))
        return std::nullopt;
    text.remove_suffix(words::kUnknown.size());
    const auto time = cells::time(upTo(words::kSeconds, text));
    const auto module = skip(text, words::kGains) ? moduleOf(text) : std::nullopt;
    if (!time || !module)
        return std::nullopt;
    return GainsChange{*module, TimePoint(*time), std::nullopt};
}

std::optional<GainsChange> gainsOf(std::string_view text) {
    if (skip(text, words::kNote))
        return lostGainsOf(text);
    if (!skip(text, words::kGains))
        return std::nullopt;
    const auto module = moduleOf(upTo(words::kAt, text));
    const auto time = cells::time(upTo(words::kSeconds, text));
    const auto gains = gainValues(text);
    if (!module || !time || !gains)
        return std::nullopt;
    return GainsChange{*module, TimePoint(*time), *gains};
}

}  // namespace nmc::comments
