// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPen>
#include <QString>
#include <QWidget>
#include <vector>

#include "model/frequency/frequencyresponse.h"

namespace nmc {

/// Magnitude above and phase below, over the logarithm of the frequency: of the closed loop (T), from command
/// to position, and of the open loop (L), from error to position. Several responses are laid over one
/// another, each in its colour.
class BodePlot : public QWidget {
    Q_OBJECT

public:
    explicit BodePlot(QWidget* parent = nullptr);

    struct Curve {
        QString name;
        std::vector<FrequencyPoint> points;  ///< by ascending frequency, at least one
        int colour = 0;                      ///< look::traceColour()
        bool measured = true;
        bool closes = true;  ///< false: the closed loop would be unstable, so it has no T
        bool operator==(const Curve&) const = default;
    };
    /// `honest`: frequency in Hz above which the line is too slow; 0 if none is known. Curves are named if
    /// there are several.
    void showCurves(std::vector<Curve> curves, double honest);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Line;
    struct Pane;
    /// Adds the lines of a curve to those of the magnitude and those of the phase.
    void addLines(const Curve& curve, std::vector<Line>& loud, std::vector<Line>& late) const;
    static void paintSpread(QPainter& painter, const Pane& pane, const Line& line);
    void paintPane(QPainter& painter, const Pane& pane) const;
    void paintLegend(QPainter& painter, const QRectF& area,
                     const std::vector<std::pair<QString, QPen>>& entries) const;

    std::vector<Curve> m_curves;
    double m_honest = 0.0;
};

}  // namespace nmc
