// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

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

}  // namespace nmc
