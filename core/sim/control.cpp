// SPDX-License-Identifier: MIT
#include "sim/control.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "protocol/commandtable.h"
#include "sim/controlinputs.h"
#include "sim/controlstate.h"
#include "sim/controlwords.h"
#include "sim/faultspec.h"

namespace nmc::sim {

namespace {

using Json = nlohmann::ordered_json;
using WordList = std::vector<std::string_view>;

/// A control line, the chain it is for, the time, and what the caller knows about the pace.
struct Asked {
    Chain& chain;
    const WordList& words;
    TimePoint now;
    const std::optional<Pace>& pace;
};

Json error(const std::string& text) {
    return {{"error", text}};
}
Json ok() {
    return {{"ok", true}};
}
Json okOr(const tl::expected<void, std::string>& done) {
    return done ? ok() : error(done.error());
}

WordList split(std::string_view line) {
    constexpr std::string_view kBlanks = " \t\r\n";
    WordList words;
    for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

tl::expected<ModuleIndex, std::string> moduleNumber(const Chain& chain, std::string_view word) {
    const auto value = numberIn<unsigned>(word);
    if (!value || *value < 1 || *value > chain.moduleCount())
        return tl::unexpected("no module " + quoted(word) + "; allowed is 1 to " +
                              std::to_string(chain.moduleCount()));
    return ModuleIndex(static_cast<std::uint8_t>(*value - 1));
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

Json violationList(const std::vector<Violation>& entries) {
    Json list = Json::array();
    for (const Violation& v : entries)
        list.push_back({{"time", toSeconds(v.time.time_since_epoch())},
                        {"module", v.module + 1},
                        {"kind", toText(v.kind)},
                        {"bytes", toHex(v.bytes)}});
    return list;
}

void addStalls(Json& json, const std::optional<Pace>& pace) {
    if (!pace)
        return;
    json["stalls"] = pace->stalls;
    json["longest_stall"] = pace->longestStallSeconds;
}

Json stats(const Asked& asked) {
    Chain& chain = asked.chain;
    if (asked.words.size() > 1) {
        if (asked.words[1] != "clear")
            return error("cannot read " + quoted(asked.words[1]) + "; allowed are stats, stats clear");
        chain.clearStatistics(asked.now);
        return ok();
    }
    chain.advanceTo(asked.now);
    const ChainStatistics s = chain.statistics();
    Json modules = Json::array();
    for (const ModuleStatistics& m : s.modules)
        modules.push_back(moduleStatistics(m, modules.size() + 1));
    Json json = {{"time", toSeconds(s.time.time_since_epoch())},
                 {"exchanges", s.exchanges},
                 {"bytes_in", s.bytesIn},
                 {"bytes_out", s.bytesOut},
                 {"bytes_unheard", s.bytesUnheard},
                 {"bytes_lost", s.bytesLost},
                 {"modules", modules}};
    addStalls(json, asked.pace);
    json["violation_count"] = chain.violations().count();
    json["violations"] = violationList(chain.violations().entries());
    json["remarks"] = violationList(chain.violations().remarks());
    return json;
}

Json time(const Asked& asked) {
    const Duration since = asked.now.time_since_epoch();
    Json json = {{"time", toSeconds(since)}, {"ticks", since / kServoTick}};
    if (const auto& pace = asked.pace) {
        json["lag"] = pace->lagSeconds;
        json["late_p99"] = pace->lateP99Seconds;
        json["received"] = pace->received;
        json["sent"] = pace->sent;
    }
    addStalls(json, asked.pace);
    return json;
}

// ---- modules ----

/// Calls `act` with the module that the second word names.
template <typename F>
Json withModule(const Asked& asked, F act) {
    const auto module = moduleNumber(asked.chain, asked.words[1]);
    return module ? act(*module) : error(module.error());
}

Json state(const Asked& asked) {
    return withModule(asked, [&asked](ModuleIndex module) {
        return stateJson(asked.chain.snapshot(module, asked.now), module.value() + 1U);
    });
}

Json set(const Asked& asked) {
    return withModule(asked, [&asked](ModuleIndex module) {
        return okOr(setInput(asked.chain, module, std::span(asked.words).subspan(2), asked.now));
    });
}

Json powerCycle(const Asked& asked) {
    if (asked.words[1] == "all") {
        for (std::size_t i = 0; i < asked.chain.moduleCount(); ++i)
            asked.chain.powerCycle(ModuleIndex(static_cast<std::uint8_t>(i)), asked.now);
        return ok();
    }
    const auto module = moduleNumber(asked.chain, asked.words[1]);
    if (!module)
        return error(module.error() + " or all");
    asked.chain.powerCycle(*module, asked.now);
    return ok();
}

template <void (Chain::*Change)(ModuleIndex, TimePoint)>
Json changeLine(const Asked& asked) {
    return withModule(asked, [&asked](ModuleIndex module) {
        (asked.chain.*Change)(module, asked.now);
        return ok();
    });
}

// ---- faults ----

Json inject(const Asked& asked) {
    const auto& [chain, words, now, pace] = asked;
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

/// Sends bytes given in hexadecimal as another host.
Json foreign(const Asked& asked) {
    std::vector<std::uint8_t> bytes;
    for (const std::string_view word : std::span(asked.words).subspan(1)) {
        const auto byte = hexByte(word);
        if (!byte)
            return error("no byte " + quoted(word) + "; allowed are bytes such as AA 02 0E 10");
        bytes.push_back(*byte);
    }
    if (bytes.empty())
        return error("no bytes; allowed are such as AA 02 0E 10");
    return okOr(asked.chain.foreignSends(bytes, asked.now));
}

Json faults(const Asked& asked) {
    asked.chain.advanceTo(asked.now);
    Json list = Json::array();
    for (const FaultReport& fault : asked.chain.faults())
        list.push_back({{"fault", fault.number},
                        {"text", fault.text},
                        {"struck", fault.struck},
                        {"active", fault.active}});
    return {{"faults", list}};
}

// ---- verbs ----

Json help(const Asked& asked);

struct Verb {
    std::string_view name;
    std::size_t leastWords;
    std::size_t mostWords;
    Json (*answer)(const Asked&);
    std::string_view usage;
    std::string_view does;
};

constexpr std::size_t kMany = SIZE_MAX;
constexpr std::array kVerbs{
    Verb{"state", 2, 2, state, "state N", "the true state of module N"},
    Verb{"set", 4, 5, set, "set N NAME VALUE", "sets a pin, the load or the environment of module N"},
    Verb{"power-cycle", 2, 2, powerCycle, "power-cycle N|all", "switches the chip's supply off and on"},
    Verb{"break", 2, 2, changeLine<&Chain::breakAddressLine>, "break N",
         "breaks the ADDR line from module N towards the host"},
    Verb{"mend", 2, 2, changeLine<&Chain::mendAddressLine>, "mend N", "restores that line"},
    Verb{"fault", 1, kMany, inject, "fault ..., fault clear", "injects a fault, or clears all faults"},
    Verb{"faults", 1, 1, faults, "faults", "the faults injected, and how often each occurred"},
    Verb{"foreign", 1, kMany, foreign, "foreign BYTES",
         "sends bytes as another host on the line, such as AA 02 0E 10"},
    Verb{"stats", 1, 2, stats, "stats, stats clear", "counters, violations and remarks; clear resets them"},
    Verb{"time", 1, 1, time, "time", "simulated time, and how late it is"},
    Verb{"help", 1, 1, help, "help", "these lines, the names of set, and the kinds of violations"},
};

std::string usages() {
    std::string all;
    for (const Verb& verb : kVerbs)
        all += std::string(all.empty() ? "allowed are " : ", ") + std::string(verb.usage);
    return all;
}

Json help(const Asked&) {
    Json lines = Json::array();
    for (const Verb& verb : kVerbs)
        lines.push_back({{"line", verb.usage}, {"does", verb.does}});
    Json inputs = Json::array();
    for (const InputRow& row : inputTable())
        inputs.push_back({{"name", row.name},
                          {"module", row.chips.word},
                          {"allowed", row.allowed},
                          {"meaning", row.meaning}});
    Json violations = Json::array();
    for (const ViolationRow& row : violationTable())
        violations.push_back({{"kind", row.name}, {"meaning", row.meaning}});
    return {{"lines", lines}, {"set", inputs}, {"violations", violations}};
}

Json answer(const Asked& asked) {
    const WordList& words = asked.words;
    if (words.empty())
        return error("empty line; " + usages());
    const auto verb = std::ranges::find(kVerbs, words[0], &Verb::name);
    if (verb == kVerbs.end())
        return error("unknown line " + quoted(words[0]) + "; " + usages());
    if (words.size() < verb->leastWords || words.size() > verb->mostWords)
        return error("wrong number of words for " + std::string(verb->name) + "; allowed is " +
                     std::string(verb->usage));
    return verb->answer(asked);
}

/// Pads `text` with blanks to `width`, at least two, because a manual page is made from this.
std::string column(std::string_view text, std::size_t width) {
    return std::string(text) + std::string(text.size() + 2 < width ? width - text.size() : 2, ' ');
}

}  // namespace

std::string controlHelp() {
    std::string text = "Control lines on standard input; each is answered by one line of JSON:\n";
    for (const Verb& verb : kVerbs)
        text += "  " + column(verb.usage, 23) + std::string(verb.does) + '\n';
    text += "\nWhat set can change, of which kind of module:\n";
    for (const InputRow& row : inputTable())
        text += "  " + column(row.name, 16) + column(row.chips.word, 10) + std::string(row.allowed) + "\n" +
                std::string(28, ' ') + std::string(row.meaning) + '\n';
    text +=
        "\nViolations, in stats: what a real chip would not have forgiven. Remarks, beside them, are of the\n"
        "same kinds: a data sheet advises against it, but says what comes of it.\n";
    for (const ViolationRow& row : violationTable())
        text += "  " + column(row.name, 23) + std::string(row.meaning) + '\n';
    return text;
}

std::string handleControlLine(Chain& chain, std::string_view line, TimePoint now,
                              const std::optional<Pace>& pace) {
    const WordList words = split(line);
    // The input may contain any bytes; the output must be UTF-8.
    return answer({chain, words, now, pace}).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace nmc::sim
