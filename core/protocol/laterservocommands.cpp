// SPDX-License-Identifier: MIT
#include "protocol/laterservocommands.h"

namespace nmc::servo {

std::optional<AddPathPoints> AddPathPoints::of(std::span<const PathPoint> points, bool fastPath) {
    AddPathPoints command;
    if (points.size() > kMaxPoints)
        return std::nullopt;
    for (const PathPoint& point : points) {
        const auto word = toPathWord(point, fastPath);
        if (!word)
            return std::nullopt;
        command.m_words[command.m_count++] = *word;
    }
    return command;
}

}  // namespace nmc::servo
