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

/// Fractions of the bus time.
struct PathShare {
    double points = 0.0;  ///< to send the points of all axes
    double polls = 0.0;   ///< to poll every module of the chain five times a second
    [[nodiscard]] double needed() const { return points + polls; }
    [[nodiscard]] bool fits() const;
};
/// The rest is reserved for retries, stops, and other commands.
inline constexpr double kPathAvailable = 0.8;

/// `axes`: those of the path; `modules`: all modules in the chain, including these.
[[nodiscard]] PathShare pathShare(const PathLine& line, servo::PathRate rate,
                                  std::span<const ModuleIdentity> axes, std::size_t modules);

}  // namespace nmc
