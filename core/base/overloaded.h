// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <variant>

namespace nmc {

/// Builds a visitor for std::visit from one function per alternative: a new alternative is a compile error
/// and never falls into another's branch.
template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// Constrains one function of a visitor to the alternatives listed by name.
template <typename T, typename... Named>
concept AnyOf = (std::same_as<T, Named> || ...);

template <typename T, typename Variant>
inline constexpr bool kIsIn = false;
template <typename T, typename... Alternatives>
inline constexpr bool kIsIn<T, std::variant<Alternatives...>> = AnyOf<T, Alternatives...>;
/// The alternatives that a variant lists.
template <typename T, typename Variant>
concept In = kIsIn<T, Variant>;

template <typename... Variants>
struct Joined;
template <typename... T>
struct Joined<std::variant<T...>> {
    using Type = std::variant<T...>;
};
template <typename... T, typename... U, typename... Others>
struct Joined<std::variant<T...>, std::variant<U...>, Others...>
    : Joined<std::variant<T..., U...>, Others...> {};
/// One variant of all their alternatives.
template <typename... Variants>
using Join = typename Joined<Variants...>::Type;

}  // namespace nmc
