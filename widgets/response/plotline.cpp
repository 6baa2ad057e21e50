// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/plotline.h"

#include <QPainter>
#include <algorithm>
#include <optional>
#include <utility>

#include "widgets/scope/tracedrawing.h"

namespace nmc {

namespace {

/// The part of a line that is in an area (Liang and Barsky).
std::optional<QLineF> within(const QRectF& area, const QLineF& line) {
    double from = 0, to = 1;
    const double dx = line.dx(), dy = line.dy();
    for (const auto& [step, room] :
         {std::pair{-dx, line.x1() - area.left()}, std::pair{dx, area.right() - line.x1()},
          std::pair{-dy, line.y1() - area.top()}, std::pair{dy, area.bottom() - line.y1()}}) {
        if (step == 0) {
            if (room < 0)
                return std::nullopt;
        } else if (step < 0) {
            from = std::max(from, room / step);
        } else {
            to = std::min(to, room / step);
        }
    }
    if (from > to)
        return std::nullopt;
    const QPointF start = from > 0 ? line.pointAt(from) : line.p1();
    return QLineF(start, to < 1 ? line.pointAt(to) : line.p2());
}

}  // namespace

void paintLine(QPainter& painter, const PlotGeometry& geometry, const QPolygonF& line) {
    const QPolygonF whole = geometry.at(line);
    QPolygonF places;
    const auto paint = [&] {
        painter.drawPolyline(places);
        places.clear();
    };
    for (qsizetype i = 1; i < whole.size(); ++i) {
        const auto part = within(geometry.area, {whole[i - 1], whole[i]});
        if (!part)
            continue;
        if (places.empty() || places.back() != part->p1()) {
            paint();
            places << part->p1();
        }
        places << part->p2();
    }
    paint();
}

}  // namespace nmc
