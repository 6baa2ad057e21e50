// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "bus/exchange.h"
#include "protocol/pathpoint.h"

/// How much of a bus's time a path needs (docs/paths.md). Pure.
namespace nmc {

struct PathLine {
    std::uint32_t baud = 115'200;
    /// What the adapter adds to every reply.
    Duration latency = bus::kMinLatency;
};

/// Shares of the time of the bus.
struct PathShare {
    double points = 0.0;  ///< for the points of all axes
    double polls = 0.0;   ///< to see every module of the chain five times a second
    [[nodiscard]] double needed() const { return points + polls; }
    [[nodiscard]] bool fits() const;
    bool operator==(const PathShare&) const = default;
};
/// The rest is for what was lost, for stops, and for whatever else is asked for.
inline constexpr double kPathAvailable = 0.8;

/// `axes`: those of the path; `modules`: in the chain, these too.
[[nodiscard]] PathShare pathShare(const PathLine& line, servo::PathRate rate,
                                  std::span<const ModuleIdentity> axes, std::size_t modules);

}  // namespace nmc
