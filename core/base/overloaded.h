// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <variant>

namespace nmc {

/// Takes a variant apart with std::visit, one function for each alternative: a new one is a compile error,
/// and never falls into the branch of another.
template <typename... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

/// The alternatives that one function takes, each by its name.
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
