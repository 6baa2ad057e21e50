// SPDX-License-Identifier: MIT
#include "model/path/pathmoves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bus/path.h"

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

}  // namespace

PathTable pathFromMoves(const PathMoves& moves) {
    PathTable table{moves.rate, {}};
    std::vector<std::int32_t> place;
    for (const PathMoves::Axis& axis : moves.axes) {
        table.columns.push_back({axis.module, {}});
        place.push_back(axis.from);
    }
    const double period = toSeconds(bus::pathPeriod(moves.rate));
    const std::size_t goals = moves.axes.empty() ? 0 : moves.axes.front().goals.size();
    std::vector<double> distances(place.size());
    for (std::size_t goal = 0; goal < goals; ++goal) {
        double velocity = std::numeric_limits<double>::infinity();
        double acceleration = velocity;
        for (std::size_t a = 0; a < place.size(); ++a) {
            const PathMoves::Axis& axis = moves.axes[a];
            distances[a] = static_cast<double>(std::int64_t{axis.goals[goal]} - place[a]);
            velocity = std::min(velocity, axis.velocity / std::abs(distances[a]));
            acceleration = std::min(acceleration, axis.acceleration / std::abs(distances[a]));
        }
        if (std::isinf(velocity))
            continue;
        const Trapezoid profile(velocity, acceleration);
        const double points = std::ceil(profile.lasts() / period);
        for (double point = 1.0; point <= points; ++point)
            for (std::size_t a = 0; a < place.size(); ++a) {
                const long distance = std::lround(distances[a] * profile.at(point * period));
                table.columns[a].points.push_back(static_cast<std::int32_t>(place[a] + distance));
            }
        for (std::size_t a = 0; a < place.size(); ++a)
            table.columns[a].points.back() = place[a] = moves.axes[a].goals[goal];
    }
    return table;
}

}  // namespace nmc
