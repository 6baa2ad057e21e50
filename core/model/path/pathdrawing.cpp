// SPDX-License-Identifier: MIT
#include "model/path/pathdrawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bus/path.h"
#include "model/module/servodefaults.h"
#include "model/path/pathfile.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

namespace {

/// A move from 0 to 1 with limited velocity and acceleration.
class Trapezoid {
public:
    Trapezoid(double velocity, double acceleration)
        : m_acceleration(acceleration), m_velocity(std::min(velocity, std::sqrt(acceleration))) {}

    [[nodiscard]] double lasts() const { return 1.0 / m_velocity + ramp(); }
    [[nodiscard]] double at(double time) const {
        if (time <= ramp())
            return m_acceleration * time * time / 2.0;
        const double left = lasts() - time;
        if (left <= ramp())
            return 1.0 - m_acceleration * std::max(left, 0.0) * std::max(left, 0.0) / 2.0;
        return m_velocity * (time - ramp() / 2.0);
    }

private:
    [[nodiscard]] double ramp() const { return m_velocity / m_acceleration; }

    double m_acceleration;
    double m_velocity;  ///< maximum velocity reached
};

class Drawing {
public:
    Drawing(const Machine& machine, const std::vector<ModuleState>& modules, servo::PathRate rate)
        : m_machine(machine), m_modules(modules), m_period(toSeconds(bus::pathPeriod(rate))) {
        m_table.rate = rate;
    }

    tl::expected<PathTable, DrawingProblem> draw(const std::string& sequence) {
        constexpr auto kAllRows = std::numeric_limits<std::size_t>::max();
        for (const auto& [module, place] : entryState(m_machine, sequence, kAllRows).places)
            if (!addAxis(module))
                return tl::unexpected(*m_problem);
        run(sequence);
        if (!m_problem && points() == 0)
            m_problem = {DrawingProblem::Kind::NoMove, sequence, 0, {}};
        if (m_problem)
            return tl::unexpected(*m_problem);
        return std::move(m_table);
    }

    void operator()(const action::MoveTo& move) {
        const Point* point = m_machine.program.point(move.point);
        std::map<ModuleIndex, std::int32_t> goals = m_places;
        for (std::size_t i = 0; point != nullptr && i < point->axes.size(); ++i) {
            const PointAxis& axis = point->axes[i];
            const auto goal = goalOf(axis, m_modules[axis.module.value()]);
            if (!goal)
                return fail(DrawingProblem::Kind::PlaceUnknown, axis.module);
            goals[axis.module] = *goal;
        }
        const auto distance = [&](ModuleIndex axis) {
            return static_cast<double>(std::int64_t{goals.at(axis)} - m_places.at(axis));
        };
        // The axis for which the move takes longest moves at its limits, the others as the line requires.
        double velocity = std::numeric_limits<double>::infinity();
        double acceleration = velocity;
        for (const PathTable::Column& column : m_table.columns) {
            const MotionSettings motion = servodefaults::motionOf(m_machine.axis(column.module));
            const double perSecond = ticksPerSecond(1);  // with another SR, no path is run
            const double counts = std::abs(distance(column.module));
            velocity = std::min(velocity, motion.velocity * move.percent / 100.0 * perSecond / counts);
            acceleration = std::min(acceleration, motion.acceleration * perSecond * perSecond / counts);
        }
        if (std::isinf(velocity))
            return;
        const Trapezoid profile(velocity, acceleration);
        const double count = std::ceil(profile.lasts() / m_period);
        if (!hasRoomFor(count))
            return fail(DrawingProblem::Kind::TooManyPoints);
        // Halves of a count all fall the same way; otherwise a segment at constant velocity might be one too
        // long.
        constexpr double kBelowHalf = 1.0 - 1e-9;
        for (PathTable::Column& column : m_table.columns) {
            const std::int32_t from = m_places.at(column.module);
            const double way = distance(column.module) * kBelowHalf;
            for (double i = 1.0; i < count; ++i) {
                const long travelled = std::lround(way * profile.at(i * m_period));
                column.points.push_back(static_cast<std::int32_t>(from + travelled));
            }
            column.points.push_back(goals.at(column.module));
        }
        m_places = goals;
    }
    void operator()(const action::Wait& wait) {
        const double count = std::round(wait.seconds / m_period);
        if (!hasRoomFor(count))
            return fail(DrawingProblem::Kind::TooManyPoints);
        for (PathTable::Column& column : m_table.columns)
            column.points.resize(column.points.size() + static_cast<std::size_t>(std::max(count, 0.0)),
                                 m_places.at(column.module));
    }
    /// A path needs no wait for arrival: its axes are always at the command position.
    void operator()(const action::WaitForArrival& /*wait*/) {}
    void operator()(const action::Repeat& repeat) {
        if (repeat.times == 0)
            fail(DrawingProblem::Kind::Endless);
    }
    void operator()(const action::Call& /*call*/) {}
    /// Rows that cannot be expressed as path points.
    void operator()(const auto& /*other*/) { fail(DrawingProblem::Kind::NotDrawn); }

private:
    void fail(DrawingProblem::Kind kind, std::optional<ModuleIndex> module = {}) {
        m_problem = m_at;
        m_problem->kind = kind;
        m_problem->module = module;
    }

    [[nodiscard]] bool addAxis(ModuleIndex index) {
        const ModuleState* module = moduleAt(index, m_modules);
        if (module == nullptr || !hasPathBuffer(module->info.identity)) {
            fail(DrawingProblem::Kind::NoPathAxis, index);
        } else if (const auto place = module->commandPosition(); !place) {
            fail(DrawingProblem::Kind::PlaceUnknown, index);
        } else {
            m_table.columns.push_back({index, {}});
            m_places[index] = *place;
        }
        return !m_problem;
    }

    void run(const std::string& name) {
        std::vector<RowPlace> places{{name}};
        std::size_t steps = 0;
        while (const Action* row = m_problem ? nullptr : rowAt(m_machine.program, places.back())) {
            m_at = {.sequence = places.back().sequence, .row = places.back().row};
            std::visit(*this, *row);
            // Moves to the present position yield no points, however often they are repeated.
            if (!m_problem && ++steps > kMaxPathPoints)
                fail(DrawingProblem::Kind::TooManyPoints);
            goOn(m_machine.program, places);
        }
    }

    [[nodiscard]] std::size_t points() const {
        return m_table.columns.empty() ? 0 : m_table.columns.front().points.size();
    }

    [[nodiscard]] bool hasRoomFor(double more) const {
        return static_cast<double>(points()) + more <= static_cast<double>(kMaxPathPoints);
    }

    const Machine& m_machine;
    const std::vector<ModuleState>& m_modules;
    double m_period;
    PathTable m_table;
    std::map<ModuleIndex, std::int32_t> m_places;
    DrawingProblem m_at;
    std::optional<DrawingProblem> m_problem;
};

}  // namespace

tl::expected<PathTable, DrawingProblem> drawPath(const std::string& sequence, const Machine& machine,
                                                 const std::vector<ModuleState>& modules,
                                                 servo::PathRate rate) {
    return Drawing(machine, modules, rate).draw(sequence);
}

}  // namespace nmc
