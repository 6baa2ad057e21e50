// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "model/frequency/frequencyresponse.h"

namespace nmc {

/// Magnitude above and phase below, over the logarithm of the frequency: of the closed loop (T), from command
/// to position, and of the open loop (L), from error to position.
class BodePlot : public QWidget {
    Q_OBJECT

public:
    explicit BodePlot(QWidget* parent = nullptr);

    /// `points`: by ascending frequency. `honest`: frequency in Hz above which the line is too slow; 0 if
    /// none is known.
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
