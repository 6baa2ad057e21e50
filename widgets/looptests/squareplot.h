// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <vector>

#include "model/response/edgefold.h"
#include "model/settings/axisscale.h"
#include "widgets/scope/plotframe.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

/// One period of a square wave, relative to the middle between its sides: the median of all edges with the
/// present gains, their spread, and, paler, the median with the previous gains.
class SquarePlot : public QWidget {
    Q_OBJECT

public:
    explicit SquarePlot(QWidget* parent = nullptr);

    struct Fold {
        std::vector<FoldedPoint> forward;
        std::vector<FoldedPoint> back;
        double counts = 0.0;  ///< from side to side
        double half = 0.0;    ///< s; half a period
    };
    void showFold(const Fold& now, const Fold& before, const AxisScale& scale);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// Points in seconds and in the unit of the axis.
    struct Curve {
        QPolygonF median, low, high;
    };
    [[nodiscard]] static Curve curveOf(const std::vector<FoldedPoint>& points, double from, double since,
                                       const AxisScale& scale);
    void adoptPalette();
    void fit();
    [[nodiscard]] QPolygonF placed(const QPolygonF& line) const;

    PlotFrame m_frame;
    PlotGeometry m_geometry;
    std::vector<Curve> m_now;
    std::vector<Curve> m_before;
    QPolygonF m_command;
};

}  // namespace nmc
