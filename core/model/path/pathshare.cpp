// SPDX-License-Identifier: MIT
#include "model/path/pathshare.h"

#include "bus/path.h"
#include "bus/pathbuffer.h"
#include "bus/pollschedule.h"

namespace nmc {

namespace {

/// Header, address, command byte, checksum.
constexpr std::size_t kFrame = 4;

[[nodiscard]] double seconds(const PathLine& line, std::size_t sent, std::size_t answered) {
    const bus::LineTiming timing{byteTimeAtBaud(line.baud), line.latency, {}};
    return toSeconds(timing.bytes(sent + answered) + kServoTick + line.latency);
}

}  // namespace

double pathShare(const PathLine& line, servo::PathRate rate, std::span<const ModuleIdentity> axes,
                 std::size_t modules) {
    constexpr std::size_t kPoints = bus::PathBuffer::kLongestFrame;
    const double framesPerSecond = 1.0 / (toSeconds(bus::pathPeriod(rate)) * static_cast<double>(kPoints));
    const double pollsPerSecond = 1.0 / toSeconds(bus::PollSchedule::kBackground);
    // Read Status with the items of a full poll.
    double share = static_cast<double>(modules) * pollsPerSecond * seconds(line, kFrame + 1, kMaxReply);
    for (const ModuleIdentity& axis : axes)
        share += framesPerSecond *
                 seconds(line, kFrame + 2 * kPoints, replyLength(axis, bus::standingItems(axis)));
    return share;
}

}  // namespace nmc
