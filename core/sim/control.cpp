// SPDX-License-Identifier: MIT
#include "sim/control.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "protocol/baud.h"
#include "protocol/commandtable.h"
#include "sim/controlwords.h"
#include "sim/familystate.h"
#include "sim/faultspec.h"

namespace nmc::sim {

namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string_view>;
using WordSpan = std::span<const std::string_view>;

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

// ---- state ----

Json gainsJson(const Gains& g) {
    return {{"kp", g.kp}, {"kd", g.kd}, {"ki", g.ki}, {"il", g.il}, {"ol", g.ol},
            {"cl", g.cl}, {"el", g.el}, {"sr", g.sr}, {"db", g.db}};
}

/// A number, or null where there is none.
template <typename T>
Json orNull(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json servoJson(const ServoSnapshot& servo) {
    return {{"position", servo.position},
            {"shaft", servo.shaftCounts},
            {"command_position", servo.commandPosition},
            {"position_error", servo.positionError},
            {"velocity", servo.velocity},
            {"command_velocity", servo.commandVelocity},
            {"pwm", servo.pwm},
            {"current_limit_adjustment", servo.currentLimitAdjustment},
            {"current", servo.amperes},
            {"analog", servo.analog},
            {"analog_input", orNull(servo.analogInput)},
            {"servo_on", servo.servoOn},
            {"amp_enabled", servo.ampEnabled},
            {"power", servo.power},
            {"mode", toText(servo.mode)},
            {"home", servo.home},
            {"limit1", servo.limit1},
            {"limit2", servo.limit2},
            {"index", servo.index},
            {"load", servo.loadNm},
            {"inertia", servo.inertiaKgM2},
            {"friction", servo.frictionNm},
            {"travel_min", orNull(servo.travelMin)},
            {"travel_max", orNull(servo.travelMax)},
            {"limits", servo.limitsAutomatic ? "auto" : "manual"},
            {"gains", gainsJson(servo.gains)}};
}

Json pinsJson(const StepPins& pins) {
    return {{"estop", pins.estop},   {"in1", pins.in1},       {"in2", pins.in2},
            {"limit1", pins.limit1}, {"limit2", pins.limit2}, {"home_switch", pins.homeSwitch}};
}

Json stepJson(const StepSnapshot& step) {
    return {{"position", step.position},
            {"shaft", step.shaft},
            {"step_rate", step.stepRate},
            {"speed", step.speed},
            {"timer_count", step.timerCount},
            {"moving", step.moving},
            {"reverse", step.reverse},
            {"mode", toText(step.mode)},
            {"amp_enabled", step.ampEnabled},
            {"power", step.inputs.power},
            {"analog", step.inputs.analog},
            {"homing", step.homing},
            {"home", step.home},
            {"inputs", pinsJson(step.inputs)},
            {"travel_min", orNull(step.travelMin)},
            {"travel_max", orNull(step.travelMax)},
            {"limits", step.limitsAutomatic ? "auto" : "manual"},
            {"home_switch_at", orNull(step.homeSwitchAt)},
            {"outputs", step.outputs},
            {"current_limit", step.currentLimit}};
}

Json state(Chain& chain, ModuleIndex module, TimePoint now) {
    const ModuleSnapshot s = chain.snapshot(module, now);
    Json json{{"module", module.value() + 1},
              {"type", s.step ? "step"
                       : s.io ? "io"
                              : "servo"},
              {"version", s.identity.version},
              {"address", s.address},
              {"group", s.group},
              {"leader", s.leader},
              {"baud", std::lround(realRate(s.brd))},
              {"listening", s.listening},
              {"addr_broken", s.addressLineBroken},
              {"time", toSeconds(s.time.time_since_epoch())},
              {"tick", s.tick}};
    json.update(s.step ? stepJson(*s.step) : s.io ? ioJson(*s.io) : servoJson(s.servo));
    if (s.servo.later)
        json.update(laterServoJson(s.identity, s.servo));
    return json;
}

// ---- set ----

/// Which chips have an input of that name; Both: servos and steppers.
enum class Chips : std::uint8_t { Both, Servo, Step, Sc, Io };

bool includes(Chips chips, const ModuleIdentity& module) {
    switch (chips) {
        case Chips::Both:
            return module.type != ModuleType::Io;
        case Chips::Servo:
            return module.type == ModuleType::Servo;
        case Chips::Step:
            return module.type == ModuleType::Step;
        case Chips::Sc:
            return isSc(module);
        case Chips::Io:
            return module.type == ModuleType::Io;
    }
    return false;
}

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
    unsigned count = 0;  ///< there are so many, and a number stands before the value
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
    InputRow{"steps", Input::Steps, Chips::Sc, "-32768 to 32767", -32768, 32767, true, {}},
    InputRow{"vsense", Input::VoltSense, Chips::Sc, "0 to 5 V", 0, 5, false, {}},
    InputRow{"in", Input::Pin, Chips::Io, "0 or 1", 0, 1, true, {}, 12},
    InputRow{"analog", Input::Analog, Chips::Io, "0 to 255", 0, 255, true, {}, 3},
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

/// `words`: the value, with a number before it where there are several.
Json setInput(Chain& chain, ModuleIndex module, const InputRow& row, WordSpan words, TimePoint now) {
    const std::string name(row.name);
    if (words.size() != (row.count == 0 ? 1U : 2U))
        return error("wrong number of words for set; allowed is set N " +
                     (row.count == 0 ? "NAME VALUE" : name + " K VALUE"));
    const unsigned which = row.count == 0 ? 0 : number<unsigned>(words[0]).value_or(0);
    if (which > row.count || (row.count > 0 && which == 0))
        return error("no " + name + ' ' + quoted(words[0]) + "; allowed is 1 to " +
                     std::to_string(row.count));
    const std::string_view text = words.back();
    const std::optional<Word> word = valueOf(row, text);
    if (!word)
        return error(name + " cannot be " + quoted(text) + "; allowed is " + std::string(row.allowed));
    const Surroundings around = surroundings(chain.snapshot(module, now));
    if (const std::string why = conflict(around, row.input, word->value); !why.empty())
        return error(why);
    chain.set(module, row.input, word->value, now, which);
    return ok();
}

/// `words`: name and value.
Json set(Chain& chain, ModuleIndex module, WordSpan words, TimePoint now) {
    const ModuleIdentity identity = chain.identity(module);
    std::string names;
    for (const InputRow& row : kInputs) {
        if (!includes(row.chips, identity))
            continue;
        if (row.name == words[0])
            return setInput(chain, module, row, words.subspan(1), now);
        names += std::string(names.empty() ? "" : ", ") + std::string(row.name);
    }
    const std::string_view who = identity.type == ModuleType::Step ? "a stepper"
                                 : identity.type == ModuleType::Io ? "a PIC-I/O"
                                                                   : "a servo";
    return error(std::string(who) + " has no input " + quoted(words[0]) + "; allowed are " + names);
}

// ---- stats, time ----

Json moduleStatistics(const ModuleStatistics& m, std::size_t number) {
    Json executed = Json::object();
    for (const CommandRow& row : commandTable(m.identity))
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
        return state(chain, *module, now);
    if (words[0] == "set")
        return set(chain, *module, WordSpan(words).subspan(2), now);
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
        std::size_t optional = 0;  ///< so many words more
    };
    static constexpr std::array kTable{
        Verb{"state", 2, "state N"},
        Verb{"set", 4, "set N NAME VALUE", 1},
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
        if (words.size() < verb.words || words.size() > verb.words + verb.optional)
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
