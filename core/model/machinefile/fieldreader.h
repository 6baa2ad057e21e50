// SPDX-License-Identifier: MIT
#pragma once

// Reads the JSON files of this program. For .cpp files of core/model only.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "base/numbertext.h"
#include "base/text.h"
#include "model/machinefile/jsontree.h"
#include "model/machinefile/machinelayout.h"

namespace nmc::layout {

inline constexpr std::size_t kMaxQuoted = 40;

/// Shortens text to what fits in a sentence, without cutting within a character.
[[nodiscard]] inline std::string quoted(const std::string& text) {
    if (text.size() <= kMaxQuoted)
        return text;
    std::size_t end = kMaxQuoted;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    return text.substr(0, end) + "…";
}

/// Reads the members of a struct from an object of the file. The first problem ends it.
class FieldReader {
public:
    using Kind = FileProblem::Kind;
    using Wanted = FileProblem::Wanted;

    FieldReader(const JsonValue& object, std::optional<FileProblem>& problem, bool steps = false)
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
    void flag(std::string_view key, std::optional<bool>& flag) {
        if (m_object.find(key) != nullptr)
            this->flag(key, flag.emplace());
    }
    /// A flag that is omitted when false.
    void mark(std::string_view key, bool& flag) {
        if (m_object.find(key) != nullptr)
            this->flag(key, flag);
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
        withUnit(stem, &UnitSuffixes::distance, number, kDistance, need);
    }
    void place(std::string_view stem, std::optional<std::int32_t>& place) {
        double counts = std::numeric_limits<double>::quiet_NaN();
        withUnit(stem, &UnitSuffixes::distance, counts, kPlace, Need::Optional);
        if (!std::isnan(counts))
            place = static_cast<std::int32_t>(std::lround(counts));
    }
    void velocity(std::string_view stem, double& number, Need need = Need::Required) {
        withUnit(stem, &UnitSuffixes::velocity, number, velocityBounds(m_steps), need);
    }
    void acceleration(std::string_view stem, double& number, Need need = Need::Required) {
        withUnit(stem, &UnitSuffixes::acceleration, number, accelerationBounds(m_steps), need);
    }
    void perUnit(double& number, Need need) { withUnit("", &UnitSuffixes::perUnit, number, kPerUnit, need); }
    void seconds(std::string_view key, double& number) { real(key, number, kSeconds); }

    template <typename Enum, std::size_t Size>
    void choice(std::string_view key, Enum& chosen, const std::array<std::string_view, Size>& words) {
        if (const auto index = wordIn(key, words))
            chosen = static_cast<Enum>(*index);
    }
    void type(std::string_view key, ModuleType& type) {
        const JsonValue* value = m_object.find(key);
        if (value == nullptr || value->kind != JsonValue::Kind::Number) {
            choice(key, type, kTypeWords);
            return;
        }
        std::uint8_t number = 0;
        whole(key, number, {0, 255});
        type = static_cast<ModuleType>(number);
    }

    template <typename T>
    void part(std::string_view key, T& part) {
        if (const JsonValue* value = typed(key, JsonValue::Kind::Object, Wanted::Object, Need::Optional)) {
            FieldReader reader(*value, m_problem, m_steps);
            fields(reader, part);
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
            FieldReader reader(item, m_problem);
            fields(reader, into.emplace_back());
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
    /// Reads many numbers from a single text.
    void numbers(std::string_view key, std::vector<double>& numbers, std::size_t most) {
        const JsonValue* value = typed(key, JsonValue::Kind::Text, Wanted::Text, Need::Required);
        if (value == nullptr)
            return;
        const char* place = value->text.data();
        const char* const end = place + value->text.size();
        while (place != end) {
            double number = 0;
            const auto [next, error] = std::from_chars(place, end, number);
            const bool apart = next == end || *next == ' ';
            if (error != std::errc() || !apart || !std::isfinite(number))
                return refuse(key, *value,
                              {.kind = Kind::NotANumber,
                               .found = quoted(std::string(place, std::find(place, end, ' ')))});
            if (numbers.size() == most)
                return refuse(key, *value, {.kind = Kind::TooMany, .max = static_cast<double>(most)});
            numbers.push_back(number);
            place = next == end ? end : next + 1;
        }
    }
    void module(std::string_view key, std::optional<ModuleIndex>& module) {
        std::optional<std::uint8_t> number;
        whole(key, number, {1, static_cast<double>(kMaxAxes)});
        if (number)
            module = indexOf(*number);
    }
    void module(std::string_view key, ModuleIndex& module) {
        std::uint8_t number = 1;
        whole(key, number, {1, static_cast<double>(kMaxAxes)});
        module = indexOf(number);
    }
    /// Users count rows from 1.
    void row(std::string_view key, std::size_t& row, std::size_t most) {
        std::size_t number = 1;
        whole(key, number, {1, static_cast<double>(most)});
        row = number - 1;
    }
    /// Selects the alternative of the variant for its word.
    template <typename... T>
    void alternative(std::string_view key, std::variant<T...>& into,
                     const std::array<std::string_view, sizeof...(T)>& words) {
        const auto index = wordIn(key, words);
        std::size_t i = 0;
        ((i++ == index ? void(into = T{}) : void()), ...);
    }
    void modules(std::string_view key, std::vector<ModuleIndex>& modules) {
        const JsonValue* value = listOf(key, kMaxAxes);
        if (value == nullptr)
            return;
        for (const JsonValue& item : value->items)
            if (is(key, item, JsonValue::Kind::Number, Wanted::WholeNumber) && isWhole(key, item) &&
                within(key, item, {1, static_cast<double>(kMaxAxes)}))
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
    /// Returns null after a problem, and for an optional field that is missing.
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
    /// The index of the text among the words; nothing after a problem.
    std::optional<std::size_t> wordIn(std::string_view key, std::span<const std::string_view> words) {
        const JsonValue* value = typed(key, JsonValue::Kind::Text, Wanted::Text, Need::Required);
        if (value == nullptr)
            return std::nullopt;
        const auto word = std::ranges::find(words, value->text);
        if (word != words.end())
            return static_cast<std::size_t>(word - words.begin());
        refuse(key, *value, {.kind = Kind::UnknownWord, .found = quoted(value->text)});
        return std::nullopt;
    }
    bool isWhole(std::string_view key, const JsonValue& value) {
        if (value.number == std::trunc(value.number))
            return true;
        refuse(key, value, {.kind = Kind::WrongType, .wanted = Wanted::WholeNumber});
        return false;
    }
    bool within(std::string_view key, const JsonValue& value, Bounds bounds) {
        const double number = bounds.eitherSign ? std::abs(value.number) : value.number;
        if (number >= bounds.min && number <= bounds.max)
            return true;
        refuse(key, value,
               {.kind = Kind::OutOfRange,
                .found = textOf(value.number),
                .min = bounds.min,
                .max = bounds.max,
                .ofModule = bounds.ofModule});
        return false;
    }
    void take(std::string_view key, const JsonValue& value, std::string& text) {
        if (std::ranges::none_of(value.text, isControl))
            text = value.text;
        else
            refuse(key, value, {.kind = Kind::UnprintableText});
    }
    void withUnit(std::string_view stem, std::string_view UnitSuffixes::*suffix, double& number,
                  Bounds bounds, Need need) {
        const std::string other = std::string(stem).append(suffixes(!m_steps).*suffix);
        if (const JsonValue* value = m_object.find(other))
            refuse(other, *value, {.kind = Kind::OtherChip});
        real(std::string(stem).append(suffixes(m_steps).*suffix), number, bounds, need);
    }

    const JsonValue& m_object;
    std::optional<FileProblem>& m_problem;
    bool m_steps;
};

/// Parses a file of at most `most` bytes that is of `format` and whose version is at most `newest`.
[[nodiscard]] inline tl::expected<JsonValue, FileProblem> parsed(std::string_view text, std::size_t most,
                                                                 std::string_view format, int newest) {
    if (text.size() > most)
        return tl::unexpected(
            FileProblem{.kind = FileProblem::Kind::TooLarge, .max = static_cast<double>(most)});
    auto file = parseJson(text);
    if (!file)
        return file;
    const JsonValue* said = file->find("format");
    if (said == nullptr || said->text != format)
        return tl::unexpected(FileProblem{.kind = FileProblem::Kind::OtherFormat,
                                          .line = said != nullptr ? said->line : file->line,
                                          .field = "format"});
    int version = 0;
    std::optional<FileProblem> problem;
    FieldReader(*file, problem).whole("version", version, {1, std::numeric_limits<int>::max()});
    if (!problem && version > newest)
        problem = FileProblem{.kind = FileProblem::Kind::NewerVersion,
                              .line = file->find("version")->line,
                              .field = "version",
                              .found = std::to_string(version),
                              .max = static_cast<double>(newest)};
    if (problem)
        return tl::unexpected(*problem);
    return file;
}

}  // namespace nmc::layout
