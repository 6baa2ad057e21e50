// SPDX-License-Identifier: MIT
#include "sim/faultspec.h"

#include <algorithm>
#include <array>
#include <set>

#include "protocol/commandtable.h"
#include "protocol/frame.h"
#include "sim/controlwords.h"

namespace nmc::sim {

namespace {

using Words = std::span<const std::string_view>;
using Refusal = tl::unexpected<std::string>;

enum Target : std::uint8_t { Bus = 1, Module = 2, Servo = 4, Several = 8 };
enum Side : std::uint8_t { None = 0, Command = 1, Status = 2, Either = 3 };
enum Option : std::uint8_t { On = 1, P = 2, N = 4, T = 8, For = 16, Bit = 32, NeedsT = 64 };

/// The fields of a `fault` line that a kind may have.
struct Row {
    std::string_view name;
    FaultKind kind;
    unsigned targets;
    Side sides;        ///< the sides that can be chosen
    Side usual;        ///< the side when none is chosen
    unsigned options;  ///< `at` is allowed with every kind
};

constexpr unsigned kFrames = On | P | N | For;
constexpr std::array kRows{
    Row{"drop", FaultKind::Drop, Bus | Module, Either, Either, kFrames},
    Row{"dup", FaultKind::Dup, Bus | Module, Either, Either, kFrames},
    Row{"flip", FaultKind::Flip, Bus | Module, Either, Either, kFrames | Bit},
    Row{"collide", FaultKind::Collide, Bus | Module, Either, Either, kFrames},
    Row{"truncate", FaultKind::Truncate, Bus | Module, Either, Either, kFrames},
    Row{"garbage", FaultKind::Garbage, Bus | Module, Either, Either, kFrames},
    Row{"overrun", FaultKind::Overrun, Bus | Module, Command, Command, kFrames},
    Row{"delay", FaultKind::Delay, Bus | Module, Status, Status, kFrames | T | NeedsT},
    Row{"silent", FaultKind::Silent, Bus | Module, Status, Status, kFrames},
    Row{"cksum", FaultKind::Cksum, Bus | Module, Command, Command, kFrames},
    Row{"ignore", FaultKind::Ignore, Bus | Module, Command, Command, P | N | For},
    Row{"stuck", FaultKind::Stuck, Module, Status, Status, For},
    Row{"noise", FaultKind::Noise, Bus, Either, Status, N | T | For},
    Row{"break", FaultKind::Break, Bus, Either, Either, For},
    Row{"mute", FaultKind::MuteRx, Bus | Module, None, None, For},
    Row{"echo", FaultKind::Echo, Bus, None, None, For},
    Row{"foreign", FaultKind::Foreign, Bus, Command, Command, On | N | T | For},
    Row{"powercycle", FaultKind::PowerCycle, Bus | Module, None, None, 0},
    Row{"stall", FaultKind::Stall, Module | Servo, None, None, For},
    Row{"reverse", FaultKind::Reverse, Module | Servo, None, None, For},
    Row{"sameaddr", FaultKind::SameAddress, Module | Several, None, None, 0},
    Row{"definestat", FaultKind::DefineStatus, Bus | Module, None, None, 0},
};

/// Commands that the other host may send: none that could move a motor.
constexpr std::array kForeignCommands{CommandCode::Nop, CommandCode::ReadStatus, CommandCode::DefineStatus};

std::string kindNames() {
    std::string names;
    for (const Row& row : kRows)
        names += (names.empty() ? "" : " ") + std::string(row.name);
    return names;
}

/// Parses a duration of up to a day, in seconds or with a unit.
std::optional<Duration> duration(std::string_view word) {
    constexpr double kDay = 86'400.0;
    double unit = 1.0;
    for (const auto& [suffix, seconds] : {std::pair{"us", 1e-6}, std::pair{"ms", 1e-3}, std::pair{"s", 1.0}})
        if (word.ends_with(suffix)) {
            word.remove_suffix(std::string_view(suffix).size());
            unit = seconds;
            break;
        }
    const auto value = numberIn<double>(word);
    if (!value || !(*value >= 0.0 && *value * unit <= kDay))
        return std::nullopt;
    return fromSeconds(*value * unit);
}

class Parser {
public:
    Parser(Words words, std::span<const ModuleIdentity> chain) : m_words(words), m_chain(chain) {}

    tl::expected<FaultSpec, std::string> parse() {
        for (const std::string_view word : m_words)
            m_spec.text += (m_spec.text.empty() ? "" : " ") + std::string(word);
        if (auto done = target(); !done)
            return Refusal(done.error());
        if (auto done = kind(); !done)
            return Refusal(done.error());
        while (m_at < m_words.size())
            if (auto done = option(m_words[m_at++]); !done)
                return Refusal(done.error());
        if ((m_row->options & NeedsT) != 0 && !m_spec.least)
            return refuse("needs t=A..B, the least and the greatest delay");
        if (m_spec.kind == FaultKind::Ignore && !m_spec.command)
            return refuse("needs the command: ignore=<command>");
        return m_spec;
    }

private:
    using Done = tl::expected<void, std::string>;

    [[nodiscard]] Refusal refuse(const std::string& why) const {
        return Refusal(std::string(m_row->name) + " " + why);
    }
    [[nodiscard]] std::string_view next() { return m_at < m_words.size() ? m_words[m_at++] : ""; }

    Done target() {
        const std::string_view word = next();
        if (word == "bus")
            return {};
        if (word != "module")
            return Refusal("a fault is of the bus or of modules: allowed are bus, module K[,K...]");
        std::string_view list = next();
        std::set<std::uint8_t> seen;
        while (true) {
            const std::string_view item = list.substr(0, list.find(','));
            const auto value = numberIn<unsigned>(item);
            if (!value || *value < 1 || *value > m_chain.size())
                return Refusal("no module " + quoted(item) + "; allowed is 1 to " +
                               std::to_string(m_chain.size()) + ", several with commas");
            const auto index = static_cast<std::uint8_t>(*value - 1);
            if (seen.insert(index).second)
                m_spec.modules.push_back(index);
            if (item.size() == list.size())
                return {};
            list.remove_prefix(item.size() + 1);
        }
    }

    Done kind() {
        const std::string_view word = next();
        const std::string_view name = word.substr(0, word.find('='));
        const auto* const row = std::ranges::find(kRows, name, &Row::name);
        if (row == kRows.end() || (name.size() != word.size() && row->kind != FaultKind::Ignore))
            return Refusal("no kind of fault " + quoted(word) + "; allowed are " + kindNames());
        m_row = row;
        m_spec.kind = row->kind;
        m_spec.sides = {(row->usual & Command) != 0, (row->usual & Status) != 0};
        if (m_spec.onBus() && (row->targets & Bus) == 0)
            return refuse("is a module's, not the bus's: allowed is module K");
        if (!m_spec.onBus() && (row->targets & Module) == 0)
            return refuse("is the bus's, not a module's");
        if ((row->targets & Several) != 0 && m_spec.modules.size() < 2)
            return refuse("needs two modules or more: module K,K");
        if ((row->targets & Servo) != 0)
            for (const std::uint8_t module : m_spec.modules)
                if (const ModuleType type = m_chain[module].type; type != ModuleType::Servo)
                    return refuse("needs a servo: module " + std::to_string(module + 1) +
                                  (type == ModuleType::Stepper ? " is a stepper, which has no feedback"
                                                               : " is a PIC-I/O, which has no motor"));
        if (row->kind == FaultKind::Ignore && name.size() != word.size())
            return command(word.substr(name.size() + 1));
        return row->kind == FaultKind::MuteRx ? mute() : Done{};
    }

    Done mute() {
        const std::string_view word = next();
        if (word != "rx" && word != "tx")
            return refuse("needs the host's line: mute rx, what it receives, or mute tx, what it transmits");
        if (word == "tx")
            m_spec.kind = FaultKind::MuteTx;
        return {};
    }

    Done option(std::string_view word) {
        if (word == "cmd" || word == "status") {
            const Side side = word == "cmd" ? Command : Status;
            if ((m_row->sides & side) == 0)
                return refuse("does not go with " + std::string(word) + sidesAllowed());
            m_spec.sides = {side == Command, side == Status};
            return {};
        }
        const std::string_view name = word.substr(0, word.find('='));
        const std::string_view value = name.size() == word.size() ? "" : word.substr(name.size() + 1);
        struct Handler {
            std::string_view name;
            unsigned option;
            Done (Parser::*read)(std::string_view);
        };
        static constexpr std::array kHandlers{
            Handler{"on", On, &Parser::command}, Handler{"p", P, &Parser::probability},
            Handler{"n", N, &Parser::count},     Handler{"t", T, &Parser::range},
            Handler{"for", For, &Parser::lasts}, Handler{"bit", Bit, &Parser::bit},
            Handler{"at", 0, &Parser::at}};
        for (const Handler& handler : kHandlers) {
            if (handler.name != name)
                continue;
            if (handler.option != 0 && (m_row->options & handler.option) == 0)
                return refuse("does not go with " + std::string(name) + "=" + optionsAllowed());
            return (this->*handler.read)(value);
        }
        return Refusal("cannot read " + quoted(word) +
                       "; allowed are cmd, status, on=<command>, p=PROB, n=COUNT, t=A..B, at=TIME, "
                       "for=DURATION, bit=B");
    }

    [[nodiscard]] std::string sidesAllowed() const {
        if (m_row->sides == None)
            return "; it has no side";
        return m_row->sides == Command ? "; it strikes commands" : "; it strikes replies";
    }

    [[nodiscard]] std::string optionsAllowed() const {
        std::string text = "; allowed is at=";
        for (const auto& [option, name] :
             {std::pair{On, " on="}, std::pair{P, " p="}, std::pair{N, " n="}, std::pair{T, " t="},
              std::pair{For, " for="}, std::pair{Bit, " bit="}})
            if ((m_row->options & static_cast<unsigned>(option)) != 0)
                text += name;
        return text;
    }

    Done command(std::string_view word) {
        // The same key may belong to another command on another chip, so only the commands of the chips meant
        // here count.
        std::string names;
        for (std::size_t i = 0; i < m_chain.size(); ++i) {
            const auto index = static_cast<std::uint8_t>(i);
            if (!m_spec.onBus() && std::ranges::count(m_spec.modules, index) == 0)
                continue;
            for (const CommandRow& row : commandTable(m_chain[i])) {
                if (m_spec.kind == FaultKind::Foreign && std::ranges::count(kForeignCommands, row.code) == 0)
                    continue;
                if (row.key == word) {
                    m_spec.command = row.code;
                    return {};
                }
                if (names.find(row.key) == std::string::npos)
                    names += (names.empty() ? "" : " ") + std::string(row.key);
            }
        }
        return refuse("knows no command " + quoted(word) + "; allowed are " + names);
    }

    Done probability(std::string_view word) {
        const auto value = numberIn<double>(word);
        if (!value || !(*value >= 0.0 && *value <= 1.0))
            return Refusal("p cannot be " + quoted(word) + "; allowed is 0 to 1");
        m_spec.probability = *value;
        return {};
    }
    Done count(std::string_view word) {
        m_spec.count = numberIn<std::uint64_t>(word);
        if (!m_spec.count || *m_spec.count == 0)
            return Refusal("n cannot be " + quoted(word) + "; allowed is a whole number from 1 on");
        return {};
    }
    Done range(std::string_view word) {
        const std::size_t dots = word.find("..");
        m_spec.least = duration(word.substr(0, dots));
        m_spec.most = dots == std::string_view::npos ? m_spec.least : duration(word.substr(dots + 2));
        if (!m_spec.least || !m_spec.most || *m_spec.least > *m_spec.most)
            return Refusal("t cannot be " + quoted(word) +
                           "; allowed is A..B in seconds or with a unit, such as 2ms..5ms");
        return {};
    }
    Done lasts(std::string_view word) {
        m_spec.lasts = duration(word);
        if (!m_spec.lasts)
            return Refusal("for cannot be " + quoted(word) + "; allowed are seconds, or such as 200ms");
        return {};
    }
    Done at(std::string_view word) {
        const auto time = duration(word);
        if (!time)
            return Refusal("at cannot be " + quoted(word) + "; allowed is a simulated time in seconds");
        m_spec.at = TimePoint(*time);
        return {};
    }
    Done bit(std::string_view word) {
        constexpr unsigned kLast = 8 * kMaxPacket - 1;
        m_spec.bit = numberIn<unsigned>(word);
        if (!m_spec.bit || *m_spec.bit > kLast)
            return Refusal("bit cannot be " + quoted(word) + "; allowed is 0 to " + std::to_string(kLast) +
                           ", from bit 0 of the frame's first byte");
        return {};
    }

    Words m_words;
    std::span<const ModuleIdentity> m_chain;
    std::size_t m_at = 0;
    const Row* m_row = nullptr;
    FaultSpec m_spec;
};

}  // namespace

tl::expected<FaultSpec, std::string> parseFault(Words words, std::span<const ModuleIdentity> chain) {
    return Parser(words, chain).parse();
}

}  // namespace nmc::sim
