// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>

class QPainter;

namespace nmc {

struct PlotGeometry;

/// Of the settling band and what else lies behind the lines.
inline constexpr int kBandAlpha = 45;

/// `line`, in seconds and values, as far as it is in the area: an SVG file knows no clipping. In whole lines,
/// so that dashes run through.
void paintLine(QPainter& painter, const PlotGeometry& geometry, const QPolygonF& line);

}  // namespace nmc
