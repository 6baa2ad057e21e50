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

/// The stop of every motor as bytes that need no answer (bus::Engine::stopBurst), ready for somebody who can
/// ask an engine nothing: the signal handler of a crash, and the guardian behind a dead panel. A plain block
/// of memory, of the same layout in every process of this build.
struct StopBurst {
    /// 32 modules with a stop packet and its padding each, and the nulls before them.
    static constexpr std::size_t kCapacity = 1'024;

    std::uint32_t baud = 0;  ///< the rate at which the chain hears it; 0: whatever the port is at
    std::uint32_t size = 0;  ///< 0: nothing is left to stop
    std::array<std::uint8_t, kCapacity> bytes{};

    /// Nothing when it would not fit whole: half a burst would be a promise not kept.
    [[nodiscard]] static std::optional<StopBurst> of(ByteSpan bytes, std::uint32_t baud);
    [[nodiscard]] ByteSpan span() const { return ByteSpan(bytes).first(size); }
};
static_assert(std::is_trivially_copyable_v<StopBurst>);

/// How often it is looked again at a port that is waited for.
inline constexpr Duration kLookEvery = std::chrono::milliseconds(1);

// What follows makes bare system calls only, so a signal handler may use it as well. Each is bounded in time.

/// Waits until all that was written to the terminal has left its driver, or `limit` has passed.
bool waitUntilSent(int fd, Duration limit);

/// Sets the terminal to the burst's rate, writes it, and waits until it is on the wire. False when the port
/// did not take all of it.
bool sendBurst(int fd, const StopBurst& burst);

}  // namespace nmc
