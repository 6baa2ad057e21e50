// SPDX-License-Identifier: MIT
#pragma once

// Writes the JSON files of this program. For .cpp files of core/model only.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "base/numbertext.h"
#include "base/text.h"
#include "model/machinefile/machinelayout.h"

namespace nmc::layout {

inline constexpr int kIndent = 2;

/// Replaces characters that the reader does not accept; they can only come from pasted text.
[[nodiscard]] inline std::string withoutControls(std::string text) {
    std::ranges::replace_if(text, isControl, ' ');
    return text;
}

/// Writes the members of a struct into an object of the file, each in its previous place, and leaves
/// everything else in the object alone.
class FieldWriter {
public:
    using Json = nlohmann::ordered_json;

    explicit FieldWriter(Json& object, bool steps = false) : m_object(object), m_steps(steps) {
        if (!m_object.is_object())
            m_object = Json::object();
    }

    void setSteps(bool steps) { m_steps = steps; }

    void text(std::string_view key, const std::string& text) { at(key) = withoutControls(text); }
    void flag(std::string_view key, bool flag) { at(key) = flag; }
    void flag(std::string_view key, const std::optional<bool>& flag) {
        if (flag)
            at(key) = *flag;
        else
            drop(key);
    }
    void mark(std::string_view key, bool flag) { this->flag(key, flag ? std::optional(true) : std::nullopt); }
    void real(std::string_view key, double number, Bounds /*bounds*/, Need /*need*/ = {}) {
        at(key) = std::isfinite(number) ? number : 0.0;
    }
    template <std::integral T>
    void whole(std::string_view key, T number, Bounds /*bounds*/, Need /*need*/ = {}) {
        at(key) = number;
    }
    template <std::integral T>
    void whole(std::string_view key, const std::optional<T>& number, Bounds bounds) {
        if (number)
            whole(key, *number, bounds);
        else
            drop(key);
    }
    void distance(std::string_view stem, double number, Need /*need*/ = {}) {
        withUnit(stem, &UnitSuffixes::distance, number);
    }
    void place(std::string_view stem, const std::optional<std::int32_t>& place) {
        for (const bool steps : {false, true})
            drop(std::string(stem).append(suffixes(steps).distance));
        if (place)
            at(std::string(stem).append(suffixes(m_steps).distance)) = *place;
    }
    void velocity(std::string_view stem, double number, Need /*need*/ = {}) {
        withUnit(stem, &UnitSuffixes::velocity, number);
    }
    void acceleration(std::string_view stem, double number, Need /*need*/ = {}) {
        withUnit(stem, &UnitSuffixes::acceleration, number);
    }
    void perUnit(double number, Need /*need*/) { withUnit("", &UnitSuffixes::perUnit, number); }
    void seconds(std::string_view key, double number) { real(key, number, kSeconds); }

    template <typename Enum, std::size_t Size>
    void choice(std::string_view key, Enum chosen, const std::array<std::string_view, Size>& words) {
        at(key) = words[static_cast<std::size_t>(chosen)];
    }
    void type(std::string_view key, ModuleType type) {
        if (static_cast<std::size_t>(type) < kTypeWords.size())
            choice(key, type, kTypeWords);
        else
            at(key) = static_cast<int>(type);
    }

    template <typename T>
    void part(std::string_view key, const T& part) {
        FieldWriter writer(at(key), m_steps);
        fields(writer, part);
    }
    template <typename T>
    void part(std::string_view key, const std::optional<T>& from) {
        if (from)
            part(key, *from);
        else
            drop(key);
    }
    template <typename T>
    void list(std::string_view key, const std::vector<T>& from, std::size_t /*most*/) {
        Json& items = at(key);
        if (!items.is_array())
            items = Json::array();
        while (items.size() > from.size())
            items.erase(items.size() - 1);
        for (std::size_t i = 0; i < from.size(); ++i) {
            if (i == items.size())
                items.push_back(Json::object());
            FieldWriter writer(items[i]);
            fields(writer, from[i]);
        }
    }
    template <std::size_t Size>
    void names(std::string_view key, const std::array<std::string, Size>& names) {
        Json& items = at(key) = Json::array();
        for (const std::string& name : names)
            items.push_back(withoutControls(name));
    }
    void numbers(std::string_view key, const std::vector<double>& numbers, std::size_t /*most*/) {
        std::string text;
        for (const double number : numbers) {
            if (!text.empty())
                text += ' ';
            appendNumber(text, number);
        }
        at(key) = text;
    }
    void module(std::string_view key, const std::optional<ModuleIndex>& module) {
        if (module)
            at(key) = module->value() + 1;
        else
            drop(key);
    }
    void module(std::string_view key, ModuleIndex module) { at(key) = module.value() + 1; }
    void row(std::string_view key, std::size_t row, std::size_t /*most*/) { at(key) = row + 1; }
    /// A row that now has a different action keeps nothing of its previous contents.
    template <typename... T>
    void alternative(std::string_view key, const std::variant<T...>& from,
                     const std::array<std::string_view, sizeof...(T)>& words) {
        if (!m_object.contains(key) || m_object[std::string(key)] != words[from.index()])
            m_object = Json::object();
        at(key) = words[from.index()];
    }
    void modules(std::string_view key, const std::vector<ModuleIndex>& modules) {
        Json& items = at(key) = Json::array();
        for (const ModuleIndex module : modules)
            items.push_back(module.value() + 1);
    }

private:
    Json& at(std::string_view key) { return m_object[std::string(key)]; }
    void drop(std::string_view key) { m_object.erase(std::string(key)); }
    void withUnit(std::string_view stem, std::string_view UnitSuffixes::*suffix, double number) {
        drop(std::string(stem).append(suffixes(!m_steps).*suffix));
        real(std::string(stem).append(suffixes(m_steps).*suffix), number, {});
    }

    Json& m_object;
    bool m_steps;
};

template <typename Whole>
[[nodiscard]] FieldWriter::Json written(const Whole& whole) {
    FieldWriter::Json json;
    FieldWriter writer(json);
    fields(writer, whole);
    return json;
}

/// One key per line, so that people can read it.
[[nodiscard]] inline std::string fileText(const FieldWriter::Json& file) {
    return file.dump(kIndent, ' ', false, FieldWriter::Json::error_handler_t::replace) + '\n';
}

}  // namespace nmc::layout
