// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace nmc {

/// The name of an enumerator as it stands in the source; for programs that talk to the panel, not for users.
template <auto Value>
[[nodiscard]] consteval std::string_view enumeratorName() {
    // g++ and clang++ both write "[... Value = nmc::Enum::Name...]" here.
    std::string_view name = __PRETTY_FUNCTION__;
    name.remove_prefix(name.find("Value = ") + 8);
    name = name.substr(0, name.find_first_of(";]"));
    return name.substr(name.rfind(':') + 1);
}

/// The name of a value of an enum that counts from 0 to `Last` without gaps.
template <auto Last>
[[nodiscard]] constexpr std::string_view enumName(decltype(Last) value) {
    constexpr std::size_t count = static_cast<std::size_t>(Last) + 1;
    constexpr auto names = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array{enumeratorName<static_cast<decltype(Last)>(I)>()...};
    }
    (std::make_index_sequence<count>());
    return names.at(static_cast<std::size_t>(value));
}

}  // namespace nmc
