// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>

class QPainter;

namespace nmc {

struct PlotGeometry;

/// How opaque the settling band is, like everything that lies behind the lines; of 255.
inline constexpr int kBandAlpha = 45;

/// `line`, in seconds and values, as far as it is in the area: an SVG file knows no clipping. In whole lines,
/// so that dashes run through.
void paintLine(QPainter& painter, const PlotGeometry& geometry, const QPolygonF& line);

}  // namespace nmc
