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

/// A path of one PIC-SERVO CMC or SC, or of a group (docs/paths.md): looks whether its axes stand where it
/// begins, lays as many points as their buffers hold, starts it, keeps the buffers filled, and looks that
/// each command position is on it. It goes before operations and polls, and takes the line only when a frame
/// fits into a buffer.
///
/// Add Path Points must never be repeated blindly: its points would be in the buffer twice. When the answer
/// to a frame is lost, or says that it was refused, "points left" in two looks of different length tells
/// whether it was carried out; where that does not tell, the path ends.
///
/// However it ends but at its last point, its axes are to be stopped (takeStops()); nothing is sent after
/// that. Ends in exactly one OperationFinished, behind a PathProgress that says how.
class PathTask : public Task {
public:
    PathTask(Chain& chain, const Line& line, std::vector<Event>& events)
        : m_chain(chain), m_line(line), m_events(events) {}

    /// False while there is one already; nothing was taken.
    [[nodiscard]] bool begin(const Operation& operation);
    [[nodiscard]] bool active() const { return m_plan != nullptr; }
    /// One of these is an axis of it.
    [[nodiscard]] bool isFor(const std::vector<ModuleIndex>& modules) const;
    /// These are told to stop by somebody else; the other axes are to be stopped.
    void overtake(const std::vector<ModuleIndex>& modules);

    struct Stops {
        std::vector<ModuleIndex> modules;
        StopManner manner = StopManner::Abruptly;
    };
    /// Who has to be stopped. Once.
    [[nodiscard]] Stops takeStops() { return std::exchange(m_stops, {}); }

    /// What a module says, whoever asked it; before the end of that exchange is delivered.
    void onReport(ModuleIndex module, const ReplyEnd& end);
    /// Ends where one of its axes does not answer any more.
    void noteSilence();
    /// Tells of an under-run that is to be expected, also while nothing can be sent.
    void foresee(TimePoint now);
    /// When there may be something to tell.
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
        std::size_t sending = 0;  ///< points of the frame under way
        std::size_t doubt = 0;    ///< of a frame of which nobody knows whether it was carried out
        std::optional<bool> vote{};
        bool second = false;    ///< layouts take turns
        unsigned looks = 0;     ///< in this phase
        unsigned agree = 0;     ///< of them, in a row: it has started; it is on its path no more
        StatusItems agreed{};   ///< the last of them had these
        unsigned disagree = 0;  ///< the same for the contrary
        unsigned vain = 0;      ///< questions in a row without a right answer
        bool ready = false;     ///< takes points
        bool done = false;      ///< holds its last point
        std::size_t left = 0;   ///< as told last

        [[nodiscard]] ModuleIndex module() const { return path->module; }
        /// Counts of the point with this number, from 1; of 0, where it begins.
        [[nodiscard]] std::int32_t place(std::size_t point) const {
            return point == 0 ? path->from : path->points[point - 1];
        }
        /// Nobody knows whether a frame of so many points was carried out.
        void doubtFrame(std::size_t count);
        /// A second look in a row that says the same, in a reply of another length.
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

    Chain& m_chain;
    const Line& m_line;
    std::vector<Event>& m_events;
    std::shared_ptr<const PathPlan> m_plan;
    OperationId m_id;
    std::vector<Axis> m_axes;
    Phase m_phase = Phase::Looking;
    bool m_touched = false;  ///< something of it may be in a buffer
    TimePoint m_started;     ///< latched
    std::optional<TimePoint> m_reportedAt;
    std::optional<std::size_t> m_least;
    bool m_runsDry = false;  ///< and told
    Stops m_stops;
};

}  // namespace nmc::bus
