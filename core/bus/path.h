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

/// Paths of PIC-SERVO CMC and SC (docs/paths.md): points that the chip runs through at a fixed rate from a
/// buffer, which is kept filled. Values; any thread may hold copies.
namespace nmc::bus {

struct PathAxis {
    ModuleIndex module;
    std::int32_t from = 0;             ///< the command position that it holds; the path begins there
    std::vector<std::int32_t> points;  ///< counts, absolute
};
struct PathPlan {
    servo::PathRate rate = servo::PathRate::Hz60;
    std::vector<PathAxis> axes;  ///< of as many points each
    /// Whose members are the axes, and nobody else; it starts them in the same tick. None: there is one axis.
    std::optional<std::uint8_t> group{};
    bool smoothStop = false;  ///< an acceleration is loaded in each, so that it can slow down
};

/// Time from one point to the next.
[[nodiscard]] constexpr Duration pathPeriod(servo::PathRate rate) {
    return servo::ticksPerPoint(rate) * kServoTick;
}
/// Points in the buffer of a CMC and of an SC.
[[nodiscard]] constexpr std::size_t pathCapacity(const ModuleIdentity& module) {
    return isSc(module) ? 128 : hasPathBuffer(module) ? 96 : 0;
}

enum class PathEnd : std::uint8_t {
    Done,        ///< each axis holds its last point, to the count
    Stopped,     ///< by a stop of whatever kind
    NotReady,    ///< an axis may not start one now, or does not hold where its path begins; nothing was sent
    NotStarted,  ///< not by all of its axes
    UnderRun,    ///< a buffer ran dry before the end; the chip stood still at the last point it had
    StoppedShort,  ///< the chip left the path by itself: a limit, a position error, no power
    OffPath,       ///< the command position is not on the path
    Uncertain,     ///< an answer was lost, and which points the chip has cannot be told
    NoAnswer,
};

/// How far it is; about ten times a second, and at its end.
struct PathProgress {
    ModuleIndex module;  ///< the first of its axes
    std::shared_ptr<const PathPlan> plan;
    std::size_t done = 0;                ///< points that all axes have begun to go to
    std::size_t left = 0;                ///< in the buffer that has fewest
    std::optional<std::size_t> least{};  ///< of that while points were still to come
    Duration lasts{};                    ///< until that buffer is dry
    /// It will be dry, or nearly, before points can be brought to it, as far as that can be foreseen.
    bool runsDry = false;
    std::optional<PathEnd> end{};
    std::optional<ModuleIndex> endedBy{};  ///< the axis it ended for

    [[nodiscard]] std::size_t points() const { return plan->axes.front().points.size(); }
    /// Time to its last point.
    [[nodiscard]] Duration remaining() const {
        return pathPeriod(plan->rate) * static_cast<Duration::rep>(points() - done);
    }
    bool operator==(const PathProgress&) const = default;
};

}  // namespace nmc::bus
