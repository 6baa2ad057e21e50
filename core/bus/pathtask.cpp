// SPDX-License-Identifier: MIT
#include "bus/pathtask.h"

#include <algorithm>
#include <cstdlib>

#include "bus/gate.h"

namespace nmc::bus {

namespace {

using servo::AddPathPoints;

/// Limits for a series of queries without a result.
constexpr unsigned kMaxLooks = 12;
constexpr unsigned kMaxInVain = 4;
/// A module not queried for this long is queried.
constexpr Duration kInSight = std::chrono::milliseconds(250);
/// Time between two progress reports.
constexpr Duration kNews = std::chrono::milliseconds(100);
/// Bytes of a frame with seven points: header, address, command, points, sum.
constexpr std::size_t kLongestFrame = 4 + 2 * PathBuffer::kLongestFrame;
/// Number of timeouts allowed for queries after a frame was lost.
constexpr int kLookAgain = 4;

/// From this time on, losing a frame may empty the buffer: it includes the time to determine the loss and to
/// send the frame again.
[[nodiscard]] TimePoint dangerAt(TimePoint dry, const LineTiming& timing) {
    if (dry == TimePoint::max())
        return dry;
    const Duration timeout = timing.timeout(kLongestFrame, kMaxReply);
    return dry - LineTiming::quarantine(timeout) - kLookAgain * timeout;
}

[[nodiscard]] Outcome outcomeOf(PathEnd how) {
    switch (how) {
        case PathEnd::Done:
            return Outcome::Done;
        case PathEnd::Stopped:
            return Outcome::Cancelled;
        case PathEnd::NotReady:
            return Outcome::Forbidden;
        case PathEnd::Uncertain:
        case PathEnd::NoAnswer:
            return Outcome::NoAnswer;
        case PathEnd::NotStarted:
        case PathEnd::UnderRun:
        case PathEnd::StoppedShort:
        case PathEnd::OffPath:
            break;
    }
    return Outcome::Refused;
}

}  // namespace

// ---- called from outside ----

bool PathTask::begin(const Operation& operation) {
    if (active())
        return false;
    m_plan = operation.path;
    m_id = operation.id;
    m_axes.clear();
    m_touched = m_runsDry = false;
    m_reportedAt.reset();
    m_least.reset();
    m_stops = {};
    if (!possible()) {
        end(PathEnd::NotReady);
        return true;
    }
    for (const PathAxis& axis : m_plan->axes) {
        const std::size_t capacity = pathCapacity(m_chain.belief(axis.module).info().identity);
        m_axes.push_back({&axis, PathBuffer(axis.points.size(), capacity, pathPeriod(m_plan->rate))});
    }
    enter(Phase::Looking);
    return true;
}

bool PathTask::possible() const {
    if (m_plan->axes.empty() || !together())
        return false;
    const std::size_t points = m_plan->axes.front().points.size();
    return points > 0 && std::ranges::all_of(m_plan->axes, [&](const PathAxis& axis) {
               return m_chain.has(axis.module) && axis.points.size() == points && !mayLeap(axis);
           });
}

/// True if a segment is longer than a point can express.
bool PathTask::mayLeap(const PathAxis& axis) const {
    std::int64_t before = axis.from;
    return std::ranges::any_of(axis.points, [&](std::int32_t point) {
        return std::abs(point - std::exchange(before, point)) > servo::maxPathCounts(m_plan->rate);
    });
}

/// True for a single axis, or for a group known to have exactly the axes as members.
bool PathTask::together() const {
    if (!m_plan->group)
        return m_plan->axes.size() == 1;
    const auto isAxis = [&](ModuleIndex module) {
        return std::ranges::any_of(m_plan->axes, [&](const PathAxis& axis) { return axis.module == module; });
    };
    return BusAddress(*m_plan->group) != kEverybody &&
           std::ranges::all_of(m_chain.modules(), [&](const Chain::Module& module) {
               const ModuleInfo& info = module.belief.info();
               return info.group && (info.group->group == *m_plan->group) == isAxis(info.index);
           });
}

bool PathTask::isFor(const std::vector<ModuleIndex>& modules) const {
    return std::ranges::any_of(
        m_axes, [&](const Axis& axis) { return std::ranges::find(modules, axis.module()) != modules.end(); });
}

void PathTask::overtake(const std::vector<ModuleIndex>& modules) {
    if (active())
        end(PathEnd::Stopped, {}, modules);
}

bool PathTask::onChange(const Change& change) {
    if (change.cancelsAll() || isFor(change.modules)) {
        overtake(change.modules);
        if (change.kind == Change::Kind::StopAll)
            m_stops = {};  // that stops its axes, too
        return true;
    }
    return false;
}

void PathTask::Axis::doubtFrame(std::size_t count) {
    doubt = count;
    vote.reset();
    looks = agree = 0;
}

// ---- next step ----

bool PathTask::wants(TimePoint now) const {
    if (!active())
        return false;
    return m_phase != Phase::Running || std::ranges::any_of(m_axes, [&](const Axis& axis) {
               return axis.sending > 0 || axis.doubt > 0 || halts(axis) || stale(axis, now) ||
                      (axis.buffer.frame() > 0 && axis.buffer.roomAt() <= now);
           });
}

std::optional<TimePoint> PathTask::due() const {
    if (!active())
        return std::nullopt;
    if (m_phase != Phase::Running)
        return TimePoint::min();
    TimePoint first = TimePoint::max();
    for (const Axis& axis : m_axes) {
        if (axis.done)
            continue;
        first = std::min({first, axis.buffer.reportedAt() + kInSight, axis.buffer.dryAt()});
        if (axis.buffer.frame() > 0)
            first = std::min(first, axis.buffer.roomAt());
    }
    return first;
}

/// True if the axis was seen to have left path mode: nothing is sent before a second reply.
bool PathTask::halts(const Axis& axis) const {
    return m_phase == Phase::Running && axis.agree > 0 && !axis.done;
}

bool PathTask::stale(const Axis& axis, TimePoint now) const {
    return now >= std::min(axis.buffer.reportedAt() + kInSight, axis.buffer.dryAt()) && !axis.done;
}

Next PathTask::next(TimePoint now) {
    for (Axis& axis : m_axes) {
        // The frame was dropped while in progress: it may have been received.
        if (const std::size_t points = std::exchange(axis.sending, 0); points > 0)
            axis.doubtFrame(points);
        if (axis.vain > kMaxInVain || axis.looks > kMaxLooks) {
            end(axis.looks > kMaxLooks ? PathEnd::Uncertain : PathEnd::NoAnswer, axis.module());
            return Again{};
        }
        if (axis.doubt > 0 || halts(axis))
            return look(axis);
    }
    switch (m_phase) {
        case Phase::Looking:
            return lookFirst();
        case Phase::Readying:
            return makeReady();
        case Phase::Laying:
            return lay();
        case Phase::Counting:
            return lookTwice(Phase::Starting);
        case Phase::Starting:
            return start(now);
        case Phase::Confirming:
            return lookTwice(Phase::Running);
        case Phase::Running:
            break;
    }
    return keepFilled(now);
}

void PathTask::enter(Phase phase) {
    m_phase = phase;
    for (Axis& axis : m_axes)
        axis.looks = axis.agree = axis.disagree = 0;
}

/// Two replies must show that each axis stands still, has an empty buffer, and holds the position where its
/// path begins.
Next PathTask::lookFirst() {
    for (Axis& axis : m_axes) {
        if (axis.looks < 2)
            return look(axis);
        const Belief& belief = m_chain.belief(axis.module());
        const Permission verdict = mayFollowPath(belief, m_plan->rate);
        if (verdict == Permission::NeedsStatus)
            return look(axis);
        if (verdict != Permission::Allowed || belief.commandPosition() != axis.path->from || axis.left != 0 ||
            m_chain.at(axis.module()).owed || m_chain.at(axis.module()).forbidsStart()) {
            end(PathEnd::NotReady, axis.module());
            return Again{};
        }
    }
    enter(Phase::Readying);
    return Again{};
}

/// A CMC accepts points only with its advanced features on, which are set by a bit of any Stop Motor.
Next PathTask::makeReady() {
    for (Axis& axis : m_axes) {
        const Belief& belief = m_chain.belief(axis.module());
        if (std::exchange(axis.ready, true) || isSc(belief.info().identity))
            continue;
        const servo::StopMotor on{!belief.amplifierOff(), servo::StopManner::AmplifierOnly, {}, true};
        return m_chain.command(Purpose::Operation, {axis.module(), ServoCommand(on)});
    }
    enter(Phase::Laying);
    return Again{};
}

Next PathTask::lay() {
    for (Axis& axis : m_axes)
        if (axis.buffer.frame() > 0 && axis.buffer.roomAt() == TimePoint::min())
            return addPoints(axis);
    enter(Phase::Counting);
    return Again{};
}

Next PathTask::lookTwice(Phase then) {
    for (Axis& axis : m_axes)
        if (axis.agree < 2)
            return look(axis);
    if (then == Phase::Running)
        begun();
    enter(then);
    return Again{};
}

/// Sends the start once. Every axis counts as having received it until it shows the contrary.
Next PathTask::start(TimePoint now) {
    const ModuleCommand go = ServoCommand(AddPathPoints());
    const Payload payload = payloadOf(go);
    const BusAddress address =
        m_plan->group ? BusAddress(*m_plan->group) : m_chain.belief(m_axes.front().module()).info().address;
    const PacketBytes packet = toPacket({address, payload});
    m_started = m_line.latchTime(packet.size(), now);
    std::optional<ModuleIndex> answers;
    for (Axis& axis : m_axes) {
        axis.buffer.start(m_started);
        const auto& place = m_chain.belief(axis.module()).info().group;
        if (!m_plan->group || (place && place->leader))
            answers = axis.module();
        else
            m_chain.noteSent(axis.module(), go, m_started);
    }
    enter(Phase::Confirming);
    if (!answers)
        return Line::Script{Line::Packet{packet}, Line::Spacer{}};
    Ask ask = m_chain.command(Purpose::Operation, {*answers, go});
    ask.request.address = address;
    return ask;
}

/// Fills first the buffer that runs empty first. Points are not sent for long without a recent reply, because
/// a chip that has ended its path accepts points as well.
Next PathTask::keepFilled(TimePoint now) {
    Axis* neediest = nullptr;
    for (Axis& axis : m_axes)
        if (axis.buffer.frame() > 0 && axis.buffer.roomAt() <= now &&
            (neediest == nullptr || axis.buffer.dryAt() < neediest->buffer.dryAt()))
            neediest = &axis;
    if (neediest != nullptr && !stale(*neediest, now))
        return addPoints(*neediest);
    for (Axis& axis : m_axes)
        if (stale(axis, now))
            return look(axis);
    return Idle{};
}

Ask PathTask::look(Axis& axis) const {
    const ModuleIdentity identity = m_chain.belief(axis.module()).info().identity;
    axis.second = !axis.second;
    const StatusItems items = axis.second ? standingItems(identity) : fullItems(identity);
    return m_chain.status(Purpose::Check, axis.module(), items | StatusItems(StatusItems::PathPoints));
}

Next PathTask::addPoints(Axis& axis) {
    const auto& control = m_chain.belief(axis.module()).servoRegisters().pathControl;
    std::vector<servo::PathPoint> points;
    for (std::size_t i = 0; i < axis.buffer.frame(); ++i) {
        const std::size_t next = axis.buffer.sent() + i + 1;
        points.push_back({axis.place(next) - axis.place(next - 1), m_plan->rate});
    }
    const auto add = control ? AddPathPoints::of(points, control->fastPath) : std::nullopt;
    if (!add) {  // I/O Control has been changed
        end(PathEnd::NotReady, axis.module());
        return Again{};
    }
    m_touched = true;
    axis.sending = points.size();
    return m_chain.command(Purpose::Operation, {axis.module(), ServoCommand(*add)});
}

// ---- results of queries and points ----

bool PathTask::Axis::confirms(StatusItems items) {
    const bool other = agree == 0 || agreed != items;
    agreed = items;
    agree += other ? 1U : 0U;
    return agree >= 2;
}

PathTask::Axis* PathTask::find(ModuleIndex module) {
    const auto found =
        std::ranges::find_if(m_axes, [&](const Axis& axis) { return axis.module() == module; });
    return found == m_axes.end() ? nullptr : &*found;
}

Line::Script PathTask::onEnd(const Ask& ask, const ReplyEnd& end, TimePoint /*now*/) {
    Axis* axis = active() && ask.module ? find(*ask.module) : nullptr;
    if (axis == nullptr)
        return {};
    const bool accepted = end.result == ReplyResult::Accepted;
    axis->vain = accepted ? 0 : axis->vain + 1;
    if (const std::size_t points = std::exchange(axis->sending, 0); points == 0) {
        if (!accepted && m_phase == Phase::Readying)
            this->end(PathEnd::NoAnswer, axis->module());
    } else if (accepted) {
        axis->buffer.onSent(points);
    } else {  // that it was refused is known only from the module's reply
        axis->doubtFrame(points);
    }
    return {};
}

void PathTask::onReport(ModuleIndex module, const ReplyEnd& end) {
    Axis* axis = find(module);
    if (axis == nullptr || !end.report.pathPoints)
        return;
    axis->left = *end.report.pathPoints;
    ++axis->looks;
    if (axis->doubt > 0)
        return settle(*axis, end);
    axis->buffer.onReported(axis->left, end.latched, end.latchedBy);
    switch (m_phase) {
        case Phase::Looking:
        case Phase::Readying:
        case Phase::Laying:
        case Phase::Starting:
            return;
        case Phase::Counting:
            if (axis->left != axis->buffer.sent())
                return this->end(PathEnd::Uncertain, module);
            std::ignore = axis->confirms(end.report.items);
            return;
        case Phase::Confirming:
            return confirmStart(*axis, end);
        case Phase::Running:
            return watch(*axis, end);
    }
}

void PathTask::noteSilence() {
    for (const Axis& axis : m_axes)
        if (!m_chain.answers(axis.module()))
            return end(PathEnd::NoAnswer, axis.module());
}

/// Two replies of different length must agree.
void PathTask::settle(Axis& axis, const ReplyEnd& end) {
    const bool stands = end.report.aux && !servo::AuxByte{*end.report.aux}.pathMode();
    if (m_phase == Phase::Running && stands)
        return this->end(PathEnd::UnderRun, axis.module());
    const auto carriedOut = axis.buffer.carriedOut(axis.doubt, axis.left, end.latched, end.latchedBy);
    if (!carriedOut || axis.vote.value_or(*carriedOut) != *carriedOut)
        return this->end(PathEnd::Uncertain, axis.module());
    axis.vote = carriedOut;
    if (!axis.confirms(end.report.items))
        return;
    if (*carriedOut)
        axis.buffer.onSent(axis.doubt);
    axis.doubt = 0;
    axis.looks = axis.agree = 0;
    axis.buffer.onReported(axis.left, end.latched, end.latchedBy);
}

void PathTask::confirmStart(Axis& axis, const ReplyEnd& end) {
    const bool runs = end.report.aux && servo::AuxByte{*end.report.aux}.pathMode();
    if (runs || axis.left < axis.buffer.sent()) {
        std::ignore = axis.confirms(end.report.items);
        axis.disagree = 0;
    } else if (end.latched > m_started + kTakesEffect && ++axis.disagree == 2) {
        this->end(PathEnd::NotStarted, axis.module());
    }
}

/// All axes have started: the model follows them from now on.
void PathTask::begun() {
    for (const Axis& axis : m_axes) {
        const ModuleCommand go = ServoCommand(servo::AddPathPoints());
        m_chain.at(axis.module()).belief.onExecuted(go);
        m_events.emplace_back(CommandExecuted{axis.module(), m_started, go});
    }
}

void PathTask::watch(Axis& axis, const ReplyEnd& end) {
    const StatusReport& report = end.report;
    axis.looks = 0;
    if (!report.aux || !report.position || !report.positionError)
        return;
    if (!axis.buffer.sentAll())
        m_least = std::min(m_least.value_or(axis.left), axis.left);
    if (!servo::AuxByte{*report.aux}.pathMode()) {
        if (axis.confirms(report.items))
            standsStill(axis, report);
    } else {
        axis.agree = 0;
        if (offPath(axis, report))
            return this->end(PathEnd::OffPath, axis.module());
    }
    if (!active())
        return;
    m_runsDry = m_runsDry && end.latched >= dangerAt(dryAt(), m_line.timing());
    reportProgress(end.latched);
}

namespace {

[[nodiscard]] std::int64_t commandPosition(const StatusReport& report) {
    return std::int64_t{*report.position} + *report.positionError;
}

}  // namespace

/// The axis's chip has ended the path.
void PathTask::standsStill(Axis& axis, const StatusReport& report) {
    // Points that arrived too late are still in the buffer.
    const std::size_t taken = axis.buffer.sent() - std::min(axis.left, axis.buffer.sent());
    if (commandPosition(report) != axis.place(taken) || !servo::AuxByte{*report.aux}.servoOn())
        return end(PathEnd::StoppedShort, axis.module());
    if (axis.left > 0 || !axis.buffer.sentAll())
        return end(PathEnd::UnderRun, axis.module());
    axis.done = true;
    if (std::ranges::all_of(m_axes, [](const Axis& other) { return other.done; }))
        end(PathEnd::Done);
}

/// The command position must be between the last point and the next one, plus one more on each side, because
/// the chip need not latch both values in the same tick.
bool PathTask::offPath(const Axis& axis, const StatusReport& report) const {
    const std::size_t sent = axis.buffer.sent();
    const std::size_t taken = sent - std::min(axis.left, sent);
    const std::int64_t at = commandPosition(report);
    std::int64_t lowest = at + 1, highest = at - 1;
    for (std::size_t i = taken < 2 ? 0 : taken - 2; i <= std::min(taken + 1, sent); ++i) {
        lowest = std::min<std::int64_t>(lowest, axis.place(i));
        highest = std::max<std::int64_t>(highest, axis.place(i));
    }
    return at < lowest || at > highest;
}

// ---- reports ----

TimePoint PathTask::dryAt() const {
    TimePoint first = TimePoint::max();
    for (const Axis& axis : m_axes)
        if (!axis.buffer.sentAll())
            first = std::min(first, axis.buffer.dryAt());
    return first;
}

std::optional<TimePoint> PathTask::foreseeAt() const {
    const TimePoint dry = dryAt();
    if (m_phase != Phase::Running || m_runsDry || dry == TimePoint::max())
        return std::nullopt;
    return dangerAt(dry, m_line.timing());
}

void PathTask::foresee(TimePoint now) {
    const auto at = foreseeAt();
    if (!at || now < *at)
        return;
    m_runsDry = true;
    m_reportedAt.reset();
    reportProgress(now);
}

void PathTask::reportProgress(TimePoint now) {
    if (m_reportedAt && now - *m_reportedAt < kNews)
        return;
    m_reportedAt = now;
    m_events.emplace_back(progress(now));
}

PathProgress PathTask::progress(TimePoint now) const {
    PathProgress progress;
    progress.plan = m_plan;
    progress.module = m_plan->axes.empty() ? ModuleIndex() : m_plan->axes.front().module;
    progress.least = m_least;
    progress.runsDry = m_runsDry;
    if (m_axes.empty() || m_phase < Phase::Confirming)
        return progress;
    progress.done = progress.points();
    progress.left = m_axes.front().buffer.sent();
    for (const Axis& axis : m_axes) {
        const std::size_t taken = axis.buffer.taken(now);
        progress.done = std::min(progress.done, taken);
        progress.left = std::min(progress.left, axis.buffer.sent() - taken);
    }
    progress.lasts = pathPeriod(m_plan->rate) * static_cast<Duration::rep>(progress.left);
    return progress;
}

void PathTask::end(PathEnd how, std::optional<ModuleIndex> by, const std::vector<ModuleIndex>& stopped) {
    PathProgress last = progress(m_reportedAt.value_or(TimePoint{}));
    last.end = how;
    last.endedBy = by;
    if (how == PathEnd::Done)
        last.done = last.points(), last.left = 0, last.lasts = {};
    m_events.emplace_back(last);
    m_events.emplace_back(OperationFinished{m_id, outcomeOf(how), by.value_or(last.module),
                                            payloadOf(ServoCommand(servo::AddPathPoints())).commandByte()});
    if (m_touched && how != PathEnd::Done) {
        m_stops.manner = m_plan->smoothStop ? StopManner::Smoothly : StopManner::Abruptly;
        for (const Axis& axis : m_axes)
            if (std::ranges::find(stopped, axis.module()) == stopped.end())
                m_stops.modules.push_back(axis.module());
    }
    m_plan.reset();
    m_axes.clear();
}

}  // namespace nmc::bus
