// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace nmc {

/// A number with a meaning: two Strong types cannot be mixed by accident. Arithmetic is done on value().
template <typename Tag, typename Rep>
class Strong {
public:
    constexpr Strong() = default;
    constexpr explicit Strong(Rep value) : m_value(value) {}
    [[nodiscard]] constexpr Rep value() const { return m_value; }
    constexpr auto operator<=>(const Strong&) const = default;

private:
    Rep m_value{};
};

/// Place of a module in the addressing order; 0 is the module farthest from the host (DS-V 4.1).
using ModuleIndex = Strong<struct ModuleIndexTag, std::uint8_t>;

/// The address byte of a packet: individual 0..255, or a group's 0x80..0xFF (DS-V 4.1).
using BusAddress = Strong<struct BusAddressTag, std::uint8_t>;

/// Position in encoder counts or steps. It has 32 bits, as on the chips, and wraps.
using Counts = Strong<struct CountsTag, std::int32_t>;
/// The signed distance from one position to another, taken the short way round the 32-bit wrap.
[[nodiscard]] constexpr std::int32_t countsBetween(std::int32_t from, std::int32_t to) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from));
}

/// 1 in 16.16 fixed point.
inline constexpr double kFixedPointOne = 65'536.0;
/// Velocity magnitude, 16.16 fixed point, counts per servo tick (DS-V 4.4).
using CountsPerTick = Strong<struct CountsPerTickTag, std::uint32_t>;
/// Acceleration, 16.16 fixed point, counts per servo tick squared (DS-V 4.4).
using CountsPerTickSquared = Strong<struct CountsPerTickSquaredTag, std::uint32_t>;
[[nodiscard]] constexpr double toCounts(CountsPerTick velocity) {
    return velocity.value() / kFixedPointOne;
}
[[nodiscard]] constexpr double toCounts(CountsPerTickSquared acceleration) {
    return acceleration.value() / kFixedPointOne;
}

}  // namespace nmc
