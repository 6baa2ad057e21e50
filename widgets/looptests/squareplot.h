// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <vector>

#include "model/response/edgefold.h"
#include "model/settings/axisscale.h"
#include "widgets/scope/recordplot.h"

namespace nmc {

/// One period of a square wave, relative to the middle between its sides: the median of all edges with the
/// present gains, their spread, and, paler, the median with the previous gains.
class SquarePlot : public RecordPlot {
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

protected:
    void refreshLegend() override;
    void paintTraces(QPainter& painter) override;
    [[nodiscard]] View fitted() const override;
    [[nodiscard]] QMargins room() const override;

private:
    /// Points in seconds and in the unit of the axis.
    struct Curve {
        QPolygonF median, low, high;
    };
    [[nodiscard]] static Curve curveOf(const std::vector<FoldedPoint>& points, double from, double since,
                                       const AxisScale& scale);

    std::vector<Curve> m_now;
    std::vector<Curve> m_before;
    QPolygonF m_command;
    QString m_unit;
};

}  // namespace nmc
