// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>

class QPainter;

namespace nmc {

struct PlotGeometry;

/// Draws the part of `line`, in seconds and values, that is within the area, because an SVG file has no
/// clipping. The parts are polylines, so that dashes are continuous.
void paintLine(QPainter& painter, const PlotGeometry& geometry, const QPolygonF& line);

}  // namespace nmc
