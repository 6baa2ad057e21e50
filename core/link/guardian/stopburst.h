// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "base/bytes.h"
#include "base/time.h"

namespace nmc {

/// The stop of every motor as bytes that need no answer (bus::Engine::stopBurst), prepared for code that
/// cannot query an engine: the signal handler of a crash, and the guardian of a dead panel. A plain block of
/// memory with the same layout in every process of this build.
struct StopBurst {
    /// At the highest rate, a servo tick is as long as 65 bytes. After 16 nulls, each of 32 modules may need
    /// its gains back (19 bytes) and its stop (5 bytes), each followed by as many nulls as that: 4 944 bytes,
    /// of which a network may double some.
    static constexpr std::size_t kCapacity = 8'192;

    std::uint32_t baud = 0;  ///< the rate at which the chain listens; 0: the port's present rate
    std::uint32_t size = 0;  ///< 0: nothing is left to stop
    std::array<std::uint8_t, kCapacity> bytes{};

    /// Returns nothing when the bytes do not fit as a whole, because half a burst would not stop every motor.
    [[nodiscard]] static std::optional<StopBurst> of(ByteSpan bytes, std::uint32_t baud);
    [[nodiscard]] ByteSpan span() const { return ByteSpan(bytes).first(size); }
};
static_assert(std::is_trivially_copyable_v<StopBurst>);

/// Interval of checks while waiting for a port.
inline constexpr Duration kLookEvery = std::chrono::milliseconds(1);

// The following functions use bare system calls only, so that a signal handler may call them. The time of
// each is bounded.

/// Waits until everything written to the terminal has left its driver, or `limit` has passed.
bool waitUntilSent(int fd, Duration limit);

/// Sets the terminal to the burst's rate, writes the burst, and waits until it is on the line. Returns false
/// when the port did not accept all of it.
bool sendBurst(int fd, const StopBurst& burst);

}  // namespace nmc
