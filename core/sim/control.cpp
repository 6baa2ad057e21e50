// SPDX-License-Identifier: MIT
#include "sim/control.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "protocol/commandtable.h"
#include "sim/controlstate.h"
#include "sim/controlwords.h"
#include "sim/faultspec.h"

namespace nmc::sim {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string_view>;

constexpr std::string_view kVerbs =
    "allowed are state N, set N NAME VALUE, power-cycle N|all, break N, mend N, fault ..., fault clear, "
    "faults, foreign BYTES, stats, time";

Json error(const std::string& text) {
    return {{"error", text}};
}
Json ok() {
    return {{"ok", true}};
}

Words split(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r\n";
    Words words;
    for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

tl::expected<ModuleIndex, std::string> moduleNumber(const Chain& chain, std::string_view word) {
    const auto value = number<unsigned>(word);
    if (!value || *value < 1 || *value > chain.moduleCount())
        return tl::unexpected("no module " + quoted(word) + "; allowed is 1 to " +
                              std::to_string(chain.moduleCount()));
    return ModuleIndex(static_cast<std::uint8_t>(*value - 1));
}

// ---- set ----

/// Which chips have an input of that name.
enum class Chips : std::uint8_t { Both, Servo, Step };

/// A word that stands for a value, or for none.
struct Word {
    std::string_view text;
    std::optional<double> value;
};

struct InputRow {
    std::string_view name;
    Input input;
    Chips chips;
    std::string_view allowed;
    double min;  ///< of numbers; none are allowed when max < min
    double max;
    bool whole;
    std::array<Word, 2> words;
};

/// An end of the travel.
[[nodiscard]] constexpr InputRow travelRow(std::string_view name, Input input) {
    return {name, input, Chips::Both, "-1e12 to 1e12 counts or none", -1e12, 1e12, true, {Word{"none", {}}}};
}

// Bounds that keep the plant's arithmetic sound; a motor of this class is far inside them.
constexpr std::array kInputs{
    InputRow{"limit1", Input::Limit1, Chips::Both, "0 or 1", 0, 1, true, {}},
    InputRow{"limit2", Input::Limit2, Chips::Both, "0 or 1", 0, 1, true, {}},
    InputRow{"index", Input::Index, Chips::Servo, "0 or 1", 0, 1, true, {}},
    InputRow{"power", Input::Power, Chips::Both, "0 or 1", 0, 1, true, {}},
    InputRow{"analog", Input::Analog, Chips::Servo, "0 to 255 or auto", 0, 255, true, {Word{"auto", {}}}},
    InputRow{"analog", Input::Analog, Chips::Step, "0 to 255", 0, 255, true, {}},
    InputRow{"load", Input::Load, Chips::Servo, "-100 to 100 N·m", -100, 100, false, {}},
    InputRow{"inertia", Input::Inertia, Chips::Servo, "1e-6 to 100 kg·m²", 1e-6, 100, false, {}},
    InputRow{"friction", Input::Friction, Chips::Servo, "0 to 100 N·m", 0, 100, false, {}},
    travelRow("travel_min", Input::TravelMin),
    travelRow("travel_max", Input::TravelMax),
    InputRow{"limits",
             Input::Limits,
             Chips::Both,
             "auto or manual",
             0,
             -1,
             true,
             {Word{"auto", 1.0}, Word{"manual", 0.0}}},
    InputRow{"servo_overrun", Input::ServoOverrun, Chips::Servo, "1", 1, 1, true, {}},
    InputRow{"estop", Input::Estop, Chips::Step, "0 or 1", 0, 1, true, {}},
    InputRow{"in1", Input::In1, Chips::Step, "0 or 1", 0, 1, true, {}},
    InputRow{"in2", Input::In2, Chips::Step, "0 or 1", 0, 1, true, {}},
    InputRow{"home_switch", Input::HomeSwitch, Chips::Step, "0 or 1", 0, 1, true, {}},
    InputRow{"home_switch_at",
             Input::HomeSwitchAt,
             Chips::Step,
             "-1e12 to 1e12 counts or none",
             -1e12,
             1e12,
             true,
             {Word{"none", {}}}},
};

/// What a word on the line says; nothing when the row does not allow it.
std::optional<Word> valueOf(const InputRow& row, std::string_view text) {
    for (const Word& word : row.words)
        if (!text.empty() && word.text == text)
            return word;
    const auto value = number<double>(text);
    // Written so that NaN is refused.
    if (!value || !(*value >= row.min && *value <= row.max) || (row.whole && *value != std::floor(*value)))
        return std::nullopt;
    return Word{text, value};
}

/// What is around a module, of either kind.
struct Surroundings {
    double shaft = 0;
    bool limitsAutomatic = false;
    bool homeSwitchAutomatic = false;
};

Surroundings surroundings(const ModuleSnapshot& s) {
    if (s.step)
        return {static_cast<double>(s.step->shaft), s.step->limitsAutomatic,
                s.step->homeSwitchAt.has_value()};
    return {s.servo.shaftCounts, s.servo.limitsAutomatic, false};
}

/// What the module's present state forbids although the value is in range; empty when nothing does.
std::string conflict(const Surroundings& now, Input input, std::optional<double> value) {
    const auto shaft = [&now] { return "the shaft stands at " + std::to_string(now.shaft) + " counts"; };
    if ((input == Input::Limit1 || input == Input::Limit2) && now.limitsAutomatic)
        return "the limits follow the travel; allowed after limits manual";
    if (input == Input::HomeSwitch && now.homeSwitchAutomatic)
        return "the home switch follows the shaft; allowed after home_switch_at none";
    if (input == Input::TravelMin && value && *value > now.shaft)
        return shaft() + "; allowed is up to that, or none";
    if (input == Input::TravelMax && value && *value < now.shaft)
        return shaft() + "; allowed is from that on, or none";
    return {};
}

Json setInput(Chain& chain, ModuleIndex module, const InputRow& row, std::string_view text, TimePoint now) {
    const std::optional<Word> word = valueOf(row, text);
    if (!word)
        return error(std::string(row.name) + " cannot be " + quoted(text) + "; allowed is " +
                     std::string(row.allowed));
    const Surroundings around = surroundings(chain.snapshot(module, now));
    if (const std::string why = conflict(around, row.input, word->value); !why.empty())
        return error(why);
    chain.set(module, row.input, word->value, now);
    return ok();
}

Json set(Chain& chain, ModuleIndex module, std::string_view name, std::string_view text, TimePoint now) {
    const bool isStep = chain.identity(module).type == ModuleType::Step;
    std::string names;
    for (const InputRow& row : kInputs) {
        if (row.chips != Chips::Both && (row.chips == Chips::Step) != isStep)
            continue;
        if (row.name == name)
            return setInput(chain, module, row, text, now);
        names += std::string(names.empty() ? "" : ", ") + std::string(row.name);
    }
    return error((isStep ? "a stepper has no input " : "a servo has no input ") + quoted(name) +
                 "; allowed are " + names);
}

// ---- stats, time ----

Json moduleStatistics(const ModuleStatistics& m, std::size_t number) {
    Json executed = Json::object();
    for (const CommandRow& row : commandTable(m.type))
        if (const std::uint64_t count = m.executions(row.code); count > 0)
            executed[std::string(row.key)] = count;
    return {{"module", number},
            {"executed", executed},
            {"checksum_errors", m.checksumErrors},
            {"replies", m.replies},
            {"replies_dropped", m.repliesDropped},
            {"bytes_garbled", m.bytesGarbled}};
}

Json stats(Chain& chain, TimePoint now) {
    chain.advanceTo(now);
    const ChainStatistics s = chain.statistics();
    Json modules = Json::array();
    for (const ModuleStatistics& m : s.modules)
        modules.push_back(moduleStatistics(m, modules.size() + 1));
    Json violations = Json::array();
    for (const Violation& v : chain.violations().entries())
        violations.push_back({{"time", toSeconds(v.time.time_since_epoch())},
                              {"module", v.module + 1},
                              {"kind", toText(v.kind)},
                              {"bytes", toHex(v.bytes)}});
    return {{"time", toSeconds(s.time.time_since_epoch())},
            {"exchanges", s.exchanges},
            {"bytes_in", s.bytesIn},
            {"bytes_out", s.bytesOut},
            {"bytes_unheard", s.bytesUnheard},
            {"bytes_lost", s.bytesLost},
            {"modules", modules},
            {"violation_count", chain.violations().count()},
            {"violations", violations}};
}

Json time(TimePoint now, const Pace& pace) {
    const Duration since = now.time_since_epoch();
    return {{"time", toSeconds(since)},        {"ticks", since / kServoTick}, {"lag", pace.lagSeconds},
            {"late_p99", pace.lateP99Seconds}, {"received", pace.received},   {"sent", pace.sent}};
}

// ---- verbs ----

Json powerCycle(Chain& chain, std::string_view word, TimePoint now) {
    if (word == "all") {
        for (std::size_t i = 0; i < chain.moduleCount(); ++i)
            chain.powerCycle(ModuleIndex(static_cast<std::uint8_t>(i)), now);
        return ok();
    }
    const auto module = moduleNumber(chain, word);
    if (!module)
        return error(module.error() + " or all");
    chain.powerCycle(*module, now);
    return ok();
}

Json withModule(Chain& chain, const Words& words, TimePoint now) {
    const auto module = moduleNumber(chain, words[1]);
    if (!module)
        return error(module.error());
    if (words[0] == "state")
        return stateJson(chain.snapshot(*module, now), module->value() + 1U);
    if (words[0] == "set")
        return set(chain, *module, words[2], words[3], now);
    if (words[0] == "break")
        chain.breakAddressLine(*module, now);
    else
        chain.mendAddressLine(*module, now);
    return ok();
}

// ---- faults ----

Json inject(Chain& chain, const Words& words, TimePoint now) {
    if (words.size() == 2 && words[1] == "clear") {
        chain.clearFaults(now);
        return ok();
    }
    std::vector<ModuleIdentity> identities;
    for (std::size_t i = 0; i < chain.moduleCount(); ++i)
        identities.push_back(chain.identity(ModuleIndex(static_cast<std::uint8_t>(i))));
    const auto spec = parseFault(std::span(words).subspan(1), identities);
    if (!spec)
        return error(spec.error());
    const auto number = chain.inject(*spec, now);
    if (!number)
        return error(number.error());
    return {{"ok", true}, {"fault", *number}};
}

/// Another host's bytes, in hexadecimal.
Json foreign(Chain& chain, const Words& words, TimePoint now) {
    std::vector<std::uint8_t> bytes;
    for (const std::string_view word : std::span(words).subspan(1)) {
        const auto byte = hexByte(word);
        if (!byte)
            return error("no byte " + quoted(word) + "; allowed are bytes such as AA 02 0E 10");
        bytes.push_back(*byte);
    }
    if (bytes.empty())
        return error("no bytes; allowed are such as AA 02 0E 10");
    if (const auto sent = chain.foreignSends(bytes, now); !sent)
        return error(sent.error());
    return ok();
}

Json faults(Chain& chain, TimePoint now) {
    chain.advanceTo(now);
    Json list = Json::array();
    for (const FaultReport& fault : chain.faults())
        list.push_back({{"fault", fault.number},
                        {"text", fault.text},
                        {"struck", fault.struck},
                        {"active", fault.active}});
    return {{"faults", list}};
}

Json answer(Chain& chain, const Words& words, TimePoint now, const Pace& pace) {
    struct Verb {
        std::string_view name;
        std::size_t words;
        std::string_view usage;
    };
    static constexpr std::array kTable{
        Verb{"state", 2, "state N"},
        Verb{"set", 4, "set N NAME VALUE"},
        Verb{"power-cycle", 2, "power-cycle N|all"},
        Verb{"break", 2, "break N"},
        Verb{"mend", 2, "mend N"},
        Verb{"faults", 1, "faults"},
        Verb{"stats", 1, "stats"},
        Verb{"time", 1, "time"},
    };
    if (words.empty())
        return error("empty line; " + std::string(kVerbs));
    if (words[0] == "fault")
        return inject(chain, words, now);
    if (words[0] == "foreign")
        return foreign(chain, words, now);
    for (const Verb& verb : kTable) {
        if (words[0] != verb.name)
            continue;
        if (words.size() != verb.words)
            return error("wrong number of words for " + std::string(verb.name) + "; allowed is " +
                         std::string(verb.usage));
        if (verb.name == "stats")
            return stats(chain, now);
        if (verb.name == "faults")
            return faults(chain, now);
        if (verb.name == "time")
            return time(now, pace);
        if (verb.name == "power-cycle")
            return powerCycle(chain, words[1], now);
        return withModule(chain, words, now);
    }
    return error("unknown line " + quoted(words[0]) + "; " + std::string(kVerbs));
}

}  // namespace

std::string handleControlLine(Chain& chain, std::string_view line, TimePoint now, const Pace& pace) {
    // What comes in may be any bytes; what goes out is UTF-8.
    return answer(chain, split(line), now, pace).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace nmc::sim
