// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QString>
#include <array>

#include "model/response/responsefile.h"
#include "widgets/scope/plotgeometry.h"

class QPainter;
class QPalette;

namespace nmc {

/// The strips below the step plot, on its time axis: the position error, zoomed in to where it settles, and
/// the PWM value that the filter calculates from it. A solid, B dashed.
class ResponseStrips {
public:
    /// Either may be null. A is drawn in its own unit, B by `scaleOfB`.
    void show(const KeptResponse* a, const KeptResponse* b, const AxisScale* scaleOfB);
    /// Height of both strips, in lines of text.
    static constexpr double kLines = 9.0;
    /// `place`: over the full width. `above`: geometry of the plot, whose time axis the strips share.
    void paint(QPainter& painter, const QRectF& place, const PlotGeometry& above,
               const QPalette& palette) const;

private:
    struct Curve {
        QPolygonF error;  ///< in the unit that it is drawn in
        QPolygonF pwm;
    };
    void paintStrip(QPainter& painter, const PlotGeometry& geometry, const QString& title, double band,
                    QPolygonF Curve::*line, const QPalette& palette) const;

    std::array<Curve, 2> m_curves;
    QString m_unit;
    double m_band = 1.0;
    double m_zoom = 1.0;     ///< range to either side, in the unit of the axis
    double m_limit = 255.0;  ///< range to either side, in PWM counts
};

}  // namespace nmc
