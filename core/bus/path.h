// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/strong.h"
#include "base/time.h"
#include "protocol/commands.h"
#include "protocol/pathpoint.h"

/// Paths of PIC-SERVO CMC and SC (docs/paths.md): the chip runs through points at a fixed rate from a buffer
/// that is kept filled. Values; any thread may hold copies.
namespace nmc::bus {

struct PathAxis {
    ModuleIndex module;
    std::int32_t from = 0;             ///< the command position at which it holds; the path begins there
    std::vector<std::int32_t> points;  ///< counts, absolute
};
struct PathPlan {
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<PathAxis> axes;  ///< all with the same number of points
    /// The group with exactly these axes as members, which starts them in the same tick. Empty: there is one
    /// axis.
    std::optional<std::uint8_t> group{};
    bool smoothStop = false;  ///< each axis has an acceleration, so that it can decelerate
};

/// Time from one point to the next.
[[nodiscard]] constexpr Duration pathPeriod(servo::PathRate rate) {
    return servo::ticksPerPoint(rate) * kServoTick;
}
/// Capacity of the path buffer in points.
[[nodiscard]] constexpr std::size_t pathCapacity(const ModuleIdentity& module) {
    return isSc(module) ? 128 : hasPathBuffer(module) ? 96 : 0;
}

enum class PathEnd : std::uint8_t {
    Done,      ///< each axis holds exactly its last point
    Stopped,   ///< by a stop of any kind
    NotReady,  ///< an axis cannot start a path now, or does not hold where its path begins; nothing was sent
    NotStarted,    ///< not started by all of its axes
    UnderRun,      ///< a buffer ran empty before the end; the chip stopped at the last point it had
    StoppedShort,  ///< the chip ended the path by itself: a limit, a position error, no power
    OffPath,       ///< the command position is not on the path
    Uncertain,     ///< an answer was lost, and it cannot be determined which points the chip has
    NoAnswer,
};

/// Progress of a path, reported about ten times a second, and at its end.
struct PathProgress {
    ModuleIndex module;  ///< the first of its axes
    std::shared_ptr<const PathPlan> plan;
    std::size_t done = 0;                ///< points that all axes have begun to approach
    std::size_t left = 0;                ///< points left in the emptiest buffer
    std::optional<std::size_t> least{};  ///< minimum of `left` while points were still to be sent
    Duration lasts{};                    ///< time until that buffer is empty
    /// True if the buffer is predicted to run empty, or nearly, before points can be sent.
    bool runsDry = false;
    std::optional<PathEnd> end{};
    std::optional<ModuleIndex> endedBy{};  ///< the axis that caused the end

    [[nodiscard]] std::size_t points() const { return plan->axes.front().points.size(); }
    /// Time until the last point.
    [[nodiscard]] Duration remaining() const {
        return pathPeriod(plan->rate) * static_cast<Duration::rep>(points() - done);
    }
    bool operator==(const PathProgress&) const = default;
};

}  // namespace nmc::bus
