// SPDX-License-Identifier: MIT
#include "model/path/pathdrawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bus/path.h"
#include "model/module/servodefaults.h"
#include "model/path/pathfile.h"
#include "model/path/pathmoves.h"
#include "model/sequence/sequencecheck.h"

namespace nmc {

namespace {

class Drawing {
public:
    Drawing(const Machine& machine, const std::vector<ModuleState>& modules, servo::PathRate rate)
        : m_machine(machine), m_modules(modules) {
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
        PathMoves leg{.rate = m_table.rate, .axes = {}};
        for (const PathTable::Column& column : m_table.columns) {
            const AxisSettings& settings = m_machine.axis(column.module);
            const MotionSettings motion = servodefaults::motionOf(settings);
            const double perSecond = ticksPerSecond(1);  // with another SR, no path is run
            const std::int32_t place = m_places.at(column.module);
            leg.axes.push_back({column.module,
                                motion.velocity * move.percent / 100.0 * perSecond,
                                motion.acceleration * perSecond * perSecond,
                                place,
                                {place}});
        }
        const Point* point = m_machine.program.point(move.point);
        for (std::size_t i = 0; point != nullptr && i < point->axes.size(); ++i) {
            const PointAxis& axis = point->axes[i];
            const auto goal = goalOf(axis, m_modules[axis.module.value()]);
            if (!goal)
                return fail(DrawingProblem::Kind::PlaceUnknown, axis.module);
            for (PathMoves::Axis& moved : leg.axes)
                if (moved.module == axis.module)
                    moved.goals = {*goal};
            m_places[axis.module] = *goal;
        }
        append(pathFromMoves(leg));
    }
    void operator()(const action::Wait& wait) {
        const double count = std::round(wait.seconds / toSeconds(bus::pathPeriod(m_table.rate)));
        if (!(count <= static_cast<double>(kMaxPathPoints)))
            return fail(DrawingProblem::Kind::TooManyPoints);
        PathTable rest{m_table.rate, {}};
        for (const PathTable::Column& column : m_table.columns)
            rest.columns.push_back({column.module, std::vector(static_cast<std::size_t>(std::max(count, 0.0)),
                                                               m_places.at(column.module))});
        append(rest);
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

    void append(const PathTable& leg) {
        if (!leg.columns.empty() && points() + leg.columns.front().points.size() > kMaxPathPoints)
            return fail(DrawingProblem::Kind::TooManyPoints);
        for (std::size_t i = 0; i < leg.columns.size(); ++i)
            m_table.columns[i].points.insert(m_table.columns[i].points.end(), leg.columns[i].points.begin(),
                                             leg.columns[i].points.end());
    }

    const Machine& m_machine;
    const std::vector<ModuleState>& m_modules;
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
