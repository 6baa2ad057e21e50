// SPDX-License-Identifier: MIT
#pragma once

// The fields of a part of a machine as a list, by model/machinefile/machinelayout.h. For machinecompare.cpp
// and tests only.

#include <string>
#include <vector>

#include "model/machinefile/machinecompare.h"
#include "model/machinefile/machinelayout.h"

namespace nmc::layout {

struct ListedField {
    std::string key;
    Quantity quantity;
    FieldValue value;
};

class FieldList {
public:
    [[nodiscard]] const std::vector<ListedField>& fields() const { return m_fields; }

    void text(std::string_view key, const std::string& text) {
        if (!text.empty())
            add(key, Quantity::Plain, text);
    }
    void flag(std::string_view key, bool flag) { add(key, Quantity::Plain, flag); }
    void flag(std::string_view key, const std::optional<bool>& flag) {
        if (flag)
            add(key, Quantity::Plain, *flag);
    }
    void mark(std::string_view key, bool marked) {
        if (marked)
            flag(key, true);
    }
    void real(std::string_view key, double number, Bounds /*bounds*/, Need /*need*/ = {}) {
        add(key, Quantity::Plain, number);
    }
    template <std::integral T>
    void whole(std::string_view key, T number, Bounds /*bounds*/, Need /*need*/ = {}) {
        add(key, Quantity::Plain, static_cast<double>(number));
    }
    template <std::integral T>
    void whole(std::string_view key, const std::optional<T>& number, Bounds bounds) {
        if (number)
            whole(key, *number, bounds);
    }
    void distance(std::string_view key, double number, Need /*need*/ = {}) {
        addSet(key, Quantity::Distance, number);
    }
    void place(std::string_view key, const std::optional<std::int32_t>& place) {
        if (place)
            add(key, Quantity::Place, static_cast<double>(*place));
    }
    void velocity(std::string_view key, double number, Need /*need*/ = {}) {
        addSet(key, Quantity::Velocity, number);
    }
    void acceleration(std::string_view key, double number, Need /*need*/ = {}) {
        addSet(key, Quantity::Acceleration, number);
    }
    void perUnit(double number, Need /*need*/) { add(kServoSuffixes.perUnit, Quantity::Plain, number); }
    void seconds(std::string_view key, double number) { add(key, Quantity::Seconds, number); }
    template <typename Enum, std::size_t Size>
    void choice(std::string_view key, Enum chosen, const Word<Enum> (&words)[Size]) {
        for (const Word<Enum>& word : words)
            if (word.value == chosen)
                add(key, Quantity::Plain, std::string(word.text));
    }
    template <std::size_t Size>
    void names(std::string_view key, const std::array<std::string, Size>& names) {
        for (std::size_t i = 0; i < Size; ++i)
            text(std::string(key) + std::to_string(i + 1), names[i]);
    }

    void module(std::string_view key, ModuleIndex module) { whole(key, module.value() + 1, {}); }
    void row(std::string_view key, std::size_t row, std::size_t /*most*/) { whole(key, row + 1, {}); }
    template <typename... T>
    void alternative(std::string_view key, const std::variant<T...>& from,
                     const std::array<std::string_view, sizeof...(T)>& words) {
        text(key, std::string(words[from.index()]));
    }

    void add(std::string_view key, Quantity quantity, FieldValue value) {
        m_fields.push_back({std::string(key), quantity, std::move(value)});
    }

private:
    /// 0 is what nobody has set.
    void addSet(std::string_view key, Quantity quantity, double number) {
        if (number != 0)
            add(key, quantity, number);
    }

    std::vector<ListedField> m_fields;
};

template <typename T>
[[nodiscard]] std::vector<ListedField> listed(const T& part) {
    FieldList list;
    fields(list, part);
    return list.fields();
}
/// Nothing for a part that nobody has set.
template <typename T>
[[nodiscard]] std::vector<ListedField> listedUnless(const T& part, const T& unset) {
    return part == unset ? std::vector<ListedField>{} : listed(part);
}
template <typename T>
[[nodiscard]] std::vector<ListedField> listed(const std::optional<T>& part) {
    return part ? listed(*part) : std::vector<ListedField>{};
}

}  // namespace nmc::layout
