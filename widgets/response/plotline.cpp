// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/plotline.h"

#include <QPainter>

#include "widgets/scope/plotgeometry.h"

namespace nmc {

void paintLine(QPainter& painter, const PlotGeometry& geometry, const QPolygonF& line) {
    const QPolygonF whole = geometry.at(line);
    QPolygonF places;
    const auto paint = [&] {
        painter.drawPolyline(places);
        places.clear();
    };
    for (qsizetype i = 1; i < whole.size(); ++i) {
        const auto part = partWithin(geometry.area, {whole[i - 1], whole[i]});
        if (!part)
            continue;
        if (places.empty() || places.back() != part->line.p1()) {
            paint();
            places << part->line.p1();
        }
        places << part->line.p2();
    }
    paint();
}

}  // namespace nmc
