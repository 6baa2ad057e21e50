// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/machinefile/machinefile.h"
#include "model/machinefile/machinelayout.h"

namespace nmc {

namespace {

using Json = nlohmann::ordered_json;
using layout::Bounds;
using layout::Need;

constexpr int kIndent = 2;

/// A file never has characters that its reader refuses; they can only have been pasted.
std::string printable(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char c) {
            const auto byte = static_cast<unsigned char>(c);
            return byte < 0x20 || byte == 0x7F;
        },
        ' ');
    return text;
}

/// Puts the members of a struct into an object of the file, each where it stood, and leaves alone whatever
/// else is there.
class Writer {
public:
    explicit Writer(Json& object, bool steps = false) : m_object(object), m_steps(steps) {
        if (!m_object.is_object())
            m_object = Json::object();
    }

    void setSteps(bool steps) { m_steps = steps; }

    void text(std::string_view key, const std::string& text) { at(key) = printable(text); }
    void flag(std::string_view key, bool flag) { at(key) = flag; }
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
        withUnit(stem, &layout::UnitSuffixes::distance, number);
    }
    void velocity(std::string_view stem, double number, Need /*need*/ = {}) {
        withUnit(stem, &layout::UnitSuffixes::velocity, number);
    }
    void acceleration(std::string_view stem, double number, Need /*need*/ = {}) {
        withUnit(stem, &layout::UnitSuffixes::acceleration, number);
    }
    void perUnit(double number, Need /*need*/) { withUnit("", &layout::UnitSuffixes::perUnit, number); }
    void seconds(std::string_view key, double number) { real(key, number, layout::kSeconds); }

    template <typename Enum, std::size_t Size>
    void choice(std::string_view key, Enum chosen, const layout::Word<Enum> (&words)[Size]) {
        for (const layout::Word<Enum>& word : words)
            if (word.value == chosen)
                at(key) = word.text;
    }
    void type(std::string_view key, ModuleType type) {
        at(key) = static_cast<int>(type);
        choice(key, type, layout::kTypeWords);
    }

    template <typename T>
    void part(std::string_view key, const T& part) {
        Writer writer(at(key), m_steps);
        layout::fields(writer, part);
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
            Writer writer(items[i]);
            layout::fields(writer, from[i]);
        }
    }
    template <std::size_t Size>
    void names(std::string_view key, const std::array<std::string, Size>& names) {
        Json& items = at(key) = Json::array();
        for (const std::string& name : names)
            items.push_back(printable(name));
    }
    void module(std::string_view key, const std::optional<ModuleIndex>& module) {
        if (module)
            at(key) = module->value() + 1;
        else
            drop(key);
    }
    void module(std::string_view key, ModuleIndex module) { at(key) = module.value() + 1; }
    void row(std::string_view key, std::size_t row, std::size_t /*most*/) { at(key) = row + 1; }
    /// A row that does something else now keeps nothing of what stood there.
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
    void withUnit(std::string_view stem, std::string_view layout::UnitSuffixes::*suffix, double number) {
        drop(std::string(stem).append(layout::suffixes(!m_steps).*suffix));
        real(std::string(stem).append(layout::suffixes(m_steps).*suffix), number, {});
    }

    Json& m_object;
    bool m_steps;
};

}  // namespace

std::string writeMachine(const Machine& machine, const UnknownKeys& unknown) {
    Json file = Json::parse(unknown.text, nullptr, false);
    if (!file.is_object())
        file = Json::object();
    file["format"] = layout::kFormat;
    file["version"] = layout::kVersion;
    Writer writer(file);
    layout::fields(writer, machine);
    return file.dump(kIndent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace nmc
