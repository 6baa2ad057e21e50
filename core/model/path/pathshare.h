// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "bus/exchange.h"
#include "protocol/pathpoint.h"

/// The fraction of a bus's time that a path needs (docs/paths.md). Pure.
namespace nmc {

struct PathLine {
    std::uint32_t baud = 115'200;
    /// The delay that the adapter adds to every reply.
    Duration latency = bus::kMinLatency;
};

/// The rest is reserved for retries, stops, and other commands.
inline constexpr double kPathAvailable = 0.8;

/// The fraction needed to send the points of all axes, and to poll every module of the chain five times a
/// second. `axes`: those of the path; `modules`: all modules in the chain, including these.
[[nodiscard]] double pathShare(const PathLine& line, servo::PathRate rate,
                               std::span<const ModuleIdentity> axes, std::size_t modules);

}  // namespace nmc
