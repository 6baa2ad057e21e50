// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/plotgeometry.h"

#include <algorithm>

namespace nmc {

QPolygonF PlotGeometry::at(const QPolygonF& line) const {
    QPolygonF places;
    places.reserve(line.size());
    for (const QPointF& point : line)
        places << at(point.x(), point.y());
    return places;
}

std::optional<LinePart> partWithin(const QRectF& area, const QLineF& line) {
    double from = 0, to = 1;
    const auto cut = [&](double start, double way, double least, double most) {
        if (way == 0)
            return start >= least && start <= most;
        const double first = (way > 0 ? least - start : most - start) / way;
        const double last = (way > 0 ? most - start : least - start) / way;
        from = std::max(from, first);
        to = std::min(to, last);
        return from < to;
    };
    if (!cut(line.x1(), line.dx(), area.left(), area.right()) ||
        !cut(line.y1(), line.dy(), area.top(), area.bottom()))
        return std::nullopt;
    return LinePart{
        {from > 0 ? line.pointAt(from) : line.p1(), to < 1 ? line.pointAt(to) : line.p2()}, from, to};
}

}  // namespace nmc
