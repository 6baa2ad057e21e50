// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bus/chain.h"
#include "bus/pathbuffer.h"
#include "bus/stoptarget.h"
#include "bus/task.h"

namespace nmc::bus {

/// Runs a path of one PIC-SERVO CMC or SC, or of a group (docs/paths.md): verifies that its axes stand where
/// it begins, fills their buffers, starts it, keeps the buffers filled, and verifies that each command
/// position is on the path. It takes precedence over operations and polls, and uses the line only when a
/// frame fits into a buffer.
///
/// Add Path Points must never be repeated blindly, because its points would then be in the buffer twice. If
/// the answer to a frame is lost, or reports that it was refused, "points left" in two replies of different
/// length shows whether the frame was carried out; if that is not conclusive, the path ends.
///
/// Unless it ends at its last point, its axes must be stopped (takeStops()); nothing is sent after that. Ends
/// in exactly one OperationFinished, preceded by a PathProgress that states how it ended.
class PathTask : public Task {
public:
    using Task::Task;

    /// Returns false while another path is active; the operation was not accepted.
    [[nodiscard]] bool begin(const Operation& operation);
    [[nodiscard]] bool active() const { return m_plan != nullptr; }
    /// True if one of these modules is an axis of the path.
    [[nodiscard]] bool isFor(const std::vector<ModuleIndex>& modules) const;
    /// These modules are being stopped by something else; the other axes must be stopped.
    void overtake(const std::vector<ModuleIndex>& modules);

    struct Stops {
        std::vector<ModuleIndex> modules;
        StopManner manner = StopManner::Abruptly;
    };
    /// The modules to be stopped. Returned once.
    [[nodiscard]] Stops takeStops() { return std::exchange(m_stops, {}); }

    /// Takes any report of a module; called before the end of that exchange is delivered.
    void onReport(ModuleIndex module, const ReplyEnd& end);
    /// Ends the path if one of its axes no longer answers.
    void noteSilence();
    /// Reports a predicted underrun, even while nothing can be sent.
    void foresee(TimePoint now);
    /// When there may be something to predict.
    [[nodiscard]] std::optional<TimePoint> foreseeAt() const;

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override;

private:
    enum class Phase : std::uint8_t { Looking, Readying, Laying, Counting, Starting, Confirming, Running };
    struct Axis {
        const PathAxis* path;
        PathBuffer buffer;
        std::size_t sending = 0;  ///< points of the frame in progress
        std::size_t doubt = 0;    ///< points of a frame for which it is unknown whether it was carried out
        std::optional<bool> vote{};
        bool second = false;    ///< layouts alternate
        unsigned looks = 0;     ///< in this phase
        unsigned agree = 0;     ///< consecutive ones that agree: it has started, or it has left its path
        StatusItems agreed{};   ///< items of the last of them
        unsigned disagree = 0;  ///< consecutive ones that show the contrary
        unsigned vain = 0;      ///< consecutive queries without a right answer
        bool ready = false;     ///< accepts points
        bool done = false;      ///< holds its last point
        std::size_t left = 0;   ///< as last reported

        [[nodiscard]] ModuleIndex module() const { return path->module; }
        /// Position in counts of the point with this number, from 1; 0: the beginning.
        [[nodiscard]] std::int32_t place(std::size_t point) const {
            return point == 0 ? path->from : path->points[point - 1];
        }
        /// It is unknown whether a frame with this many points was carried out.
        void doubtFrame(std::size_t count);
        /// Returns true for a second consecutive reply, of different length, that shows the same.
        [[nodiscard]] bool confirms(StatusItems items);
    };

    [[nodiscard]] bool possible() const;
    [[nodiscard]] bool together() const;
    [[nodiscard]] bool mayLeap(const PathAxis& axis) const;
    void enter(Phase phase);
    [[nodiscard]] Next lookFirst();
    [[nodiscard]] Next makeReady();
    [[nodiscard]] Next lay();
    [[nodiscard]] Next lookTwice(Phase then);
    [[nodiscard]] Next start(TimePoint now);
    [[nodiscard]] Next keepFilled(TimePoint now);
    [[nodiscard]] Ask look(Axis& axis) const;
    [[nodiscard]] Next addPoints(Axis& axis);
    [[nodiscard]] bool halts(const Axis& axis) const;
    [[nodiscard]] bool stale(const Axis& axis, TimePoint now) const;

    [[nodiscard]] Axis* find(ModuleIndex module);
    void settle(Axis& axis, const ReplyEnd& end);
    void confirmStart(Axis& axis, const ReplyEnd& end);
    void watch(Axis& axis, const ReplyEnd& end);
    void standsStill(Axis& axis, const StatusReport& report);
    [[nodiscard]] bool offPath(const Axis& axis, const StatusReport& report) const;
    void begun();

    [[nodiscard]] PathProgress progress(TimePoint now) const;
    [[nodiscard]] TimePoint dryAt() const;
    void reportProgress(TimePoint now);
    void end(PathEnd how, std::optional<ModuleIndex> by = {}, const std::vector<ModuleIndex>& stopped = {});

    std::shared_ptr<const PathPlan> m_plan;
    OperationId m_id;
    std::vector<Axis> m_axes;
    Phase m_phase = Phase::Looking;
    bool m_touched = false;  ///< points of this path may be in a buffer
    TimePoint m_started;     ///< when it was latched
    std::optional<TimePoint> m_reportedAt;
    std::optional<std::size_t> m_least;
    bool m_runsDry = false;  ///< this has been reported
    Stops m_stops;
};

}  // namespace nmc::bus
