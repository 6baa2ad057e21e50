// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "model/machinefile/jsontree.h"
#include "model/machinefile/machinefile.h"
#include "model/machinefile/machinelayout.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

namespace {

using layout::Bounds;
using layout::Need;
using Kind = FileProblem::Kind;
using Wanted = FileProblem::Wanted;

constexpr std::size_t kMaxQuoted = 40;

std::string numberText(double number) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

/// Not longer than a sentence can bear, and not cut within a character.
std::string quoted(const std::string& text) {
    if (text.size() <= kMaxQuoted)
        return text;
    std::size_t end = kMaxQuoted;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    return text.substr(0, end) + "…";
}

bool printable(const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7F;
    });
}

/// Takes an object of the file apart, into the members of a struct. The first problem ends it.
class Reader {
public:
    Reader(const JsonValue& object, std::optional<FileProblem>& problem, bool steps = false)
        : m_object(object), m_problem(problem), m_steps(steps) {}

    void setSteps(bool steps) { m_steps = steps; }

    void text(std::string_view key, std::string& text) {
        if (const JsonValue* value = typed(key, JsonValue::Kind::Text, Wanted::Text, Need::Optional))
            take(key, *value, text);
    }
    void flag(std::string_view key, bool& flag) {
        if (const JsonValue* value = typed(key, JsonValue::Kind::Flag, Wanted::YesOrNo, Need::Required))
            flag = value->flag;
    }
    void real(std::string_view key, double& number, Bounds bounds, Need need = Need::Required) {
        const JsonValue* value = typed(key, JsonValue::Kind::Number, Wanted::Number, need);
        if (value != nullptr && within(key, *value, bounds))
            number = value->number;
    }
    template <std::integral T>
    void whole(std::string_view key, T& number, Bounds bounds, Need need = Need::Required) {
        const JsonValue* value = typed(key, JsonValue::Kind::Number, Wanted::WholeNumber, need);
        if (value != nullptr && isWhole(key, *value) && within(key, *value, bounds))
            number = static_cast<T>(value->number);
    }
    template <std::integral T>
    void whole(std::string_view key, std::optional<T>& number, Bounds bounds) {
        if (m_object.find(key) != nullptr)
            whole(key, number.emplace(), bounds);
    }
    void distance(std::string_view stem, double& number, Need need = Need::Required) {
        withUnit(stem, &layout::UnitSuffixes::distance, number, layout::kDistance, need);
    }
    void velocity(std::string_view stem, double& number, Need need = Need::Required) {
        withUnit(stem, &layout::UnitSuffixes::velocity, number, layout::velocityBounds(m_steps), need);
    }
    void acceleration(std::string_view stem, double& number, Need need = Need::Required) {
        withUnit(stem, &layout::UnitSuffixes::acceleration, number, layout::accelerationBounds(m_steps),
                 need);
    }
    void perUnit(double& number, Need need) {
        withUnit("", &layout::UnitSuffixes::perUnit, number, layout::kPerUnit, need);
    }
    void seconds(std::string_view key, double& number) { real(key, number, layout::kSeconds); }

    template <typename Enum, std::size_t Size>
    void choice(std::string_view key, Enum& chosen, const layout::Word<Enum> (&words)[Size]) {
        const JsonValue* value = typed(key, JsonValue::Kind::Text, Wanted::Text, Need::Required);
        if (value == nullptr)
            return;
        for (const layout::Word<Enum>& word : words)
            if (word.text == value->text) {
                chosen = word.value;
                return;
            }
        refuse(key, *value, {.kind = Kind::UnknownWord, .found = quoted(value->text)});
    }
    void type(std::string_view key, ModuleType& type) {
        const JsonValue* value = m_object.find(key);
        if (value == nullptr || value->kind != JsonValue::Kind::Number) {
            choice(key, type, layout::kTypeWords);
            return;
        }
        std::uint8_t number = 0;
        whole(key, number, {0, 255});
        type = static_cast<ModuleType>(number);
    }

    template <typename T>
    void part(std::string_view key, T& part) {
        if (const JsonValue* value = typed(key, JsonValue::Kind::Object, Wanted::Object, Need::Optional)) {
            Reader reader(*value, m_problem, m_steps);
            layout::fields(reader, part);
        }
    }
    template <typename T>
    void part(std::string_view key, std::optional<T>& into) {
        if (m_object.find(key) != nullptr)
            part(key, into.emplace());
    }
    template <typename T>
    void list(std::string_view key, std::vector<T>& into, std::size_t most) {
        const JsonValue* value = listOf(key, most);
        if (value == nullptr)
            return;
        for (const JsonValue& item : value->items) {
            if (!is(key, item, JsonValue::Kind::Object, Wanted::Object))
                return;
            Reader reader(item, m_problem);
            layout::fields(reader, into.emplace_back());
        }
    }
    template <std::size_t Size>
    void names(std::string_view key, std::array<std::string, Size>& names) {
        const JsonValue* value = listOf(key, Size);
        if (value == nullptr)
            return;
        for (std::size_t i = 0; i < value->items.size(); ++i)
            if (is(key, value->items[i], JsonValue::Kind::Text, Wanted::Text))
                take(key, value->items[i], names[i]);
    }
    void module(std::string_view key, std::optional<ModuleIndex>& module) {
        std::optional<std::uint8_t> number;
        whole(key, number, {1, static_cast<double>(layout::kMaxAxes)});
        if (number)
            module = indexOf(*number);
    }
    void module(std::string_view key, ModuleIndex& module) {
        std::uint8_t number = 1;
        whole(key, number, {1, static_cast<double>(layout::kMaxAxes)});
        module = indexOf(number);
    }
    /// Users count rows from 1.
    void row(std::string_view key, std::size_t& row, std::size_t most) {
        std::size_t number = 1;
        whole(key, number, {1, static_cast<double>(most)});
        row = number - 1;
    }
    /// The one of a variant that its word stands for.
    template <typename... T>
    void alternative(std::string_view key, std::variant<T...>& into,
                     const std::array<std::string_view, sizeof...(T)>& words) {
        const JsonValue* value = typed(key, JsonValue::Kind::Text, Wanted::Text, Need::Required);
        if (value == nullptr)
            return;
        const auto index = static_cast<std::size_t>(
            std::distance(words.begin(), std::find(words.begin(), words.end(), value->text)));
        if (index == words.size())
            return refuse(key, *value, {.kind = Kind::UnknownWord, .found = quoted(value->text)});
        std::size_t i = 0;
        ((i++ == index ? void(into = T{}) : void()), ...);
    }
    void modules(std::string_view key, std::vector<ModuleIndex>& modules) {
        const JsonValue* value = listOf(key, layout::kMaxAxes);
        if (value == nullptr)
            return;
        for (const JsonValue& item : value->items)
            if (is(key, item, JsonValue::Kind::Number, Wanted::WholeNumber) && isWhole(key, item) &&
                within(key, item, {1, static_cast<double>(layout::kMaxAxes)}))
                modules.push_back(indexOf(static_cast<std::uint8_t>(item.number)));
    }

private:
    /// Users count modules from 1.
    static ModuleIndex indexOf(std::uint8_t number) {
        return ModuleIndex(number > 0 ? static_cast<std::uint8_t>(number - 1) : number);
    }
    void refuse(std::string_view key, const JsonValue& where, FileProblem problem) {
        if (m_problem)
            return;
        problem.field = key;
        problem.line = where.line;
        m_problem = std::move(problem);
    }
    bool is(std::string_view key, const JsonValue& value, JsonValue::Kind kind, Wanted wanted) {
        if (value.kind == kind)
            return true;
        refuse(key, value, {.kind = Kind::WrongType, .wanted = wanted});
        return false;
    }
    /// Null after a problem, and for what may be missing and is.
    const JsonValue* typed(std::string_view key, JsonValue::Kind kind, Wanted wanted, Need need) {
        if (m_problem)
            return nullptr;
        const JsonValue* value = m_object.find(key);
        if (value == nullptr) {
            if (need == Need::Required)
                refuse(key, m_object, {.kind = Kind::Missing});
            return nullptr;
        }
        return is(key, *value, kind, wanted) ? value : nullptr;
    }
    const JsonValue* listOf(std::string_view key, std::size_t most) {
        const JsonValue* value = typed(key, JsonValue::Kind::List, Wanted::List, Need::Optional);
        if (value == nullptr || value->items.size() <= most)
            return value;
        refuse(key, *value, {.kind = Kind::TooMany, .max = static_cast<double>(most)});
        return nullptr;
    }
    bool isWhole(std::string_view key, const JsonValue& value) {
        if (value.number == std::trunc(value.number))
            return true;
        refuse(key, value, {.kind = Kind::WrongType, .wanted = Wanted::WholeNumber});
        return false;
    }
    bool within(std::string_view key, const JsonValue& value, Bounds bounds) {
        if (value.number >= bounds.min && value.number <= bounds.max)
            return true;
        refuse(key, value,
               {.kind = Kind::OutOfRange,
                .found = numberText(value.number),
                .min = bounds.min,
                .max = bounds.max,
                .ofModule = bounds.ofModule});
        return false;
    }
    void take(std::string_view key, const JsonValue& value, std::string& text) {
        if (printable(value.text))
            text = value.text;
        else
            refuse(key, value, {.kind = Kind::UnprintableText});
    }
    void withUnit(std::string_view stem, std::string_view layout::UnitSuffixes::*suffix, double& number,
                  Bounds bounds, Need need) {
        const std::string other = std::string(stem).append(layout::suffixes(!m_steps).*suffix);
        if (const JsonValue* value = m_object.find(other))
            refuse(other, *value, {.kind = Kind::OtherChip});
        real(std::string(stem).append(layout::suffixes(m_steps).*suffix), number, bounds, need);
    }

    const JsonValue& m_object;
    std::optional<FileProblem>& m_problem;
    bool m_steps;
};

/// What the groups say of each other.
std::optional<FileProblem> contradiction(const Machine& machine, const JsonValue& file) {
    std::array<bool, layout::kMaxAxes> taken{};
    for (std::size_t i = 0; i < machine.groups.size(); ++i) {
        const GroupSettings& group = machine.groups[i];
        const int line = file.find("groups")->items[i].line;
        for (std::size_t k = 0; k < i; ++k)
            if (machine.groups[k].address == group.address)
                return FileProblem{.kind = Kind::AddressTwice,
                                   .line = line,
                                   .field = "address",
                                   .found = std::to_string(group.address)};
        for (const ModuleIndex member : group.members)
            if (std::exchange(taken[member.value()], true))
                return FileProblem{.kind = Kind::ModuleTwice,
                                   .line = line,
                                   .field = "modules",
                                   .found = std::to_string(member.value() + 1)};
        if (group.leader &&
            std::find(group.members.begin(), group.members.end(), *group.leader) == group.members.end())
            return FileProblem{.kind = Kind::LeaderNotInGroup, .line = line, .field = "leader"};
    }
    return std::nullopt;
}

Kind fileKind(SequenceProblem::Kind kind) {
    using From = SequenceProblem::Kind;
    switch (kind) {
        case From::NameTwice:
            return Kind::NameTwice;
        case From::AxisTwice:
            return Kind::AxisTwice;
        case From::NoSuchPoint:
            return Kind::NoSuchPoint;
        case From::NoSuchSequence:
            return Kind::NoSuchSequence;
        case From::CallsItself:
            return Kind::CallsItself;
        case From::RepeatsBelow:
            return Kind::RepeatsBelow;
        case From::NoName:
        case From::NoRows:
        case From::NoAxes:
        case From::NoSuchModule:
        case From::Refused:
        case From::TaughtElsewhere:
        case From::NoRecipe:
        case From::NoSuchPin:
        case From::NotAnInput:
        case From::NotAnOutput:
        case From::OutputsUnknown:
        case From::Unreachable:
        case From::NotThere:
        case From::NotSet:
            break;
    }
    return Kind::NameMissing;
}

/// What points and sequences say of each other, with the line of the point, the sequence or its row.
std::optional<FileProblem> programProblem(const Program& program, const JsonValue& file) {
    const auto problem = contradiction(program);
    if (!problem)
        return std::nullopt;
    using From = SequenceProblem::Kind;
    const bool ofName = problem->kind == From::NoName || problem->kind == From::NameTwice;
    const std::string field = problem->ofPoint ? "points" : "sequences";
    const std::vector<JsonValue>& items = file.find(field)->items;
    const auto lineOf = [&] {
        if (problem->ofPoint || ofName)
            return items[problem->row].line;
        const auto sequence = program.sequence(problem->sequence) - program.sequences.data();
        return items[static_cast<std::size_t>(sequence)].find("rows")->items[problem->row].line;
    };
    return FileProblem{
        .kind = fileKind(problem->kind),
        .line = lineOf(),
        .field = field,
        .found = problem->module ? std::to_string(problem->module->value() + 1) : quoted(problem->name)};
}

/// An axis has one place in the order.
std::optional<FileProblem> orderProblem(const Machine& machine, const JsonValue& file) {
    for (std::size_t i = 0; i < machine.homeOrder.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (machine.homeOrder[k] == machine.homeOrder[i])
                return FileProblem{.kind = Kind::AxisTwice,
                                   .line = file.find("home_order")->items[i].line,
                                   .field = "home_order",
                                   .found = std::to_string(machine.homeOrder[i].value() + 1)};
    return std::nullopt;
}

std::optional<FileProblem> wrongFormat(const JsonValue& file) {
    const JsonValue* format = file.find("format");
    if (format == nullptr || format->text != layout::kFormat)
        return FileProblem{.kind = Kind::OtherFormat,
                           .line = format != nullptr ? format->line : file.line,
                           .field = "format"};
    int version = 0;
    std::optional<FileProblem> problem;
    Reader(file, problem).whole("version", version, {1, std::numeric_limits<int>::max()});
    if (!problem && version > layout::kVersion)
        problem = FileProblem{.kind = Kind::NewerVersion,
                              .line = file.find("version")->line,
                              .field = "version",
                              .found = std::to_string(version),
                              .max = layout::kVersion};
    return problem;
}

}  // namespace

tl::expected<ParsedMachine, FileProblem> parseMachine(std::string_view text) {
    if (text.size() > kMaxMachineFile)
        return tl::unexpected(
            FileProblem{.kind = Kind::TooLarge, .max = static_cast<double>(kMaxMachineFile)});
    const auto file = parseJson(text);
    if (!file)
        return tl::unexpected(file.error());
    if (const auto problem = wrongFormat(*file))
        return tl::unexpected(*problem);
    Machine machine;
    std::optional<FileProblem> problem;
    Reader reader(*file, problem);
    layout::fields(reader, machine);
    if (!problem)
        problem = contradiction(machine, *file);
    if (!problem)
        problem = programProblem(machine.program, *file);
    if (!problem)
        problem = orderProblem(machine, *file);
    if (problem)
        return tl::unexpected(*problem);
    return ParsedMachine{std::move(machine), {std::string(text)}};
}

}  // namespace nmc
