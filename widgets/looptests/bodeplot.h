// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "model/frequency/frequencyresponse.h"

namespace nmc {

/// Magnitude above, phase below, over the logarithm of the frequency: how the position follows the command
/// (T), and what the loop makes of its error (L).
class BodePlot : public QWidget {
    Q_OBJECT

public:
    explicit BodePlot(QWidget* parent = nullptr);

    /// Ascending. `honest`: Hz, beyond which the line is too slow; 0: none is known.
    void showPoints(const std::vector<FrequencyPoint>& points, double honest);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Pane;
    void paintTo(QPainter& painter, const QRectF& area) const;
    static void paintSpread(QPainter& painter, const Pane& pane, const QPolygonF& points);
    void paintPane(QPainter& painter, const Pane& pane) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;

    std::vector<FrequencyPoint> m_points;
    double m_honest = 0.0;
};

}  // namespace nmc
