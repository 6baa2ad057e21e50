// SPDX-License-Identifier: MIT
#include "bus/pathtask.h"

#include <algorithm>
#include <cstdlib>

#include "bus/commandlane.h"
#include "bus/gate.h"

namespace nmc::bus {

namespace {

using servo::AddPathPoints;

/// Of a look for it that does not come to an end.
constexpr unsigned kMaxLooks = 12;
constexpr unsigned kMaxInVain = 4;
/// A module that nobody has asked for so long is asked.
constexpr Duration kInSight = std::chrono::milliseconds(250);
}  // namespace

// ---- from outside ----

bool PathTask::begin(const Operation& operation) {
    if (active())
        return false;
    m_plan = operation.path;
    m_id = operation.id;
    m_axes.clear();
    m_touched = m_runsDry = false;
    m_toldAt.reset();
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
    return points > 0 && std::all_of(m_plan->axes.begin(), m_plan->axes.end(), [&](const PathAxis& axis) {
               return m_chain.has(axis.module) && axis.points.size() == points && !mayLeap(axis);
           });
}

/// Some segment is longer than a point can be told.
bool PathTask::mayLeap(const PathAxis& axis) const {
    std::int64_t before = axis.from;
    return std::any_of(axis.points.begin(), axis.points.end(), [&](std::int32_t point) {
        return std::abs(point - std::exchange(before, point)) > servo::maxPathCounts(m_plan->rate);
    });
}

/// One axis by itself, or a whole group that is known to be that.
bool PathTask::together() const {
    if (!m_plan->group)
        return m_plan->axes.size() == 1;
    const auto isAxis = [&](ModuleIndex module) {
        return std::any_of(m_plan->axes.begin(), m_plan->axes.end(),
                           [&](const PathAxis& axis) { return axis.module == module; });
    };
    return BusAddress(*m_plan->group) != kEverybody &&
           std::all_of(m_chain.modules().begin(), m_chain.modules().end(), [&](const Chain::Module& module) {
               const ModuleInfo& info = module.belief.info();
               return info.group && (info.group->group == *m_plan->group) == isAxis(info.index);
           });
}

bool PathTask::isFor(const std::vector<ModuleIndex>& modules) const {
    return std::any_of(m_axes.begin(), m_axes.end(), [&](const Axis& axis) {
        return std::find(modules.begin(), modules.end(), axis.module()) != modules.end();
    });
}

void PathTask::overtake(const std::vector<ModuleIndex>& modules) {
    if (active())
        end(PathEnd::Stopped, {}, modules);
}

void PathTask::drop() {
    cancel();
    m_stops = {};
}

void PathTask::Axis::doubtFrame(std::size_t count) {
    doubt = count;
    vote.reset();
    looks = agree = 0;
}

// ---- what is next ----

bool PathTask::wants(TimePoint now) const {
    if (!active())
        return false;
    return m_phase != Phase::Running || std::any_of(m_axes.begin(), m_axes.end(), [&](const Axis& axis) {
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
        first = std::min({first, axis.buffer.toldAt() + kInSight, axis.buffer.dryAt()});
        if (axis.buffer.frame() > 0)
            first = std::min(first, axis.buffer.roomAt());
    }
    return first;
}

/// It was seen to be on its path no more: nothing is sent before a second look.
bool PathTask::halts(const Axis& axis) const {
    return m_phase == Phase::Running && axis.agree > 0 && !axis.done;
}

bool PathTask::stale(const Axis& axis, TimePoint now) const {
    return now >= std::min(axis.buffer.toldAt() + kInSight, axis.buffer.dryAt()) && !axis.done;
}

Next PathTask::next(TimePoint now) {
    for (Axis& axis : m_axes) {
        // Dropped on its way: it may have arrived.
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

/// Each stands still, with an empty buffer, and holds the place where its path begins: two looks say so.
Next PathTask::lookFirst() {
    for (Axis& axis : m_axes) {
        if (axis.looks < 2)
            return look(axis);
        const Belief& belief = m_chain.belief(axis.module());
        const Permission verdict = mayFollowPath(belief, m_plan->rate);
        if (verdict == Permission::NeedsStatus)
            return look(axis);
        if (verdict != Permission::Allowed || belief.commandPosition() != axis.path->from || axis.left != 0 ||
            m_chain.at(axis.module()).owed) {
            end(PathEnd::NotReady, axis.module());
            return Again{};
        }
    }
    enter(Phase::Readying);
    return Again{};
}

/// A CMC takes points only with its advanced features on, which the bit of any Stop Motor does.
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

/// Once. Every axis counts as having heard it until it shows the contrary.
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
            m_chain.tell(axis.module(), go, m_started);
    }
    enter(Phase::Confirming);
    if (!answers)
        return Line::Script{Line::Packet{packet}, Line::Spacer{}};
    Ask ask = m_chain.command(Purpose::Operation, {*answers, go});
    ask.request.address = address;
    return ask;
}

/// First the one that runs dry first. By the clock alone nothing is laid for long: a path that its chip has
/// ended takes points, too.
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
    return m_chain.status(Purpose::Check, axis.module(),
                          StatusItems(static_cast<std::uint8_t>(items.mask() | StatusItems::PathPoints)));
}

Next PathTask::addPoints(Axis& axis) {
    const auto& control = m_chain.belief(axis.module()).pathControl();
    std::vector<servo::PathPoint> points;
    for (std::size_t i = 0; i < axis.buffer.frame(); ++i) {
        const std::size_t next = axis.buffer.sent() + i + 1;
        points.push_back({axis.place(next) - axis.place(next - 1), m_plan->rate});
    }
    const auto add = control ? AddPathPoints::of(points, control->fastPath) : std::nullopt;
    if (!add) {  // somebody has changed I/O Control
        end(PathEnd::NotReady, axis.module());
        return Again{};
    }
    m_touched = true;
    axis.sending = points.size();
    return m_chain.command(Purpose::Operation, {axis.module(), ServoCommand(*add)});
}

}  // namespace nmc::bus
