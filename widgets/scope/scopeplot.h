// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtCharts/QChartView>
#include <vector>

#include "model/series.h"
#include "widgets/common/look.h"
#include "widgets/scope/axisrange.h"

class QLineSeries;
class QValueAxis;

namespace nmc {

class AxisLabels;
class TraceItem;

/// One strip of the scope: Qt Charts draws axes, grid and legend, TraceItem the data.
class ScopePlot : public QChartView {
    Q_OBJECT

public:
    struct TraceStyle {
        QString label;
        look::TraceColour colour = look::TraceColour::Position;
        bool dashed = false;
    };

    /// `timeLabels`: only the lowest of a stack of strips says the time.
    ScopePlot(std::vector<TraceStyle> traces, bool timeLabels, QWidget* parent = nullptr);

    /// The visible time: seconds since `origin`.
    struct View {
        TimePoint origin;
        double left = 0;
        double right = 10;
        double division = 2;
        bool operator==(const View&) const = default;
    };
    /// One frame; `series` in the order of the traces. `now` paces the vertical axis.
    void showTraces(const View& view, const std::vector<const Series*>& series, TimePoint now);
    /// Samples per second of a trace, as they came in.
    void showRate(std::size_t trace, double samplesPerSecond);
    /// Another module, or a new connection: the vertical axis may jump.
    void forget();

    /// For lining up strips: the room that the labels left of the plot area need, and what to leave.
    [[nodiscard]] int labelWidth() const;
    void leaveLeft(int width);

    [[nodiscard]] QRectF plotArea() const;
    [[nodiscard]] AxisRange::Range valueRange() const;
    [[nodiscard]] QString legendText(std::size_t trace) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void adoptPalette();
    void fitValues(double seconds);
    void fitTicks();

    std::vector<TraceStyle> m_styles;
    std::vector<QLineSeries*> m_legend;  ///< without data: they are there for the legend
    QValueAxis* m_timeAxis;
    QValueAxis* m_valueAxis;
    TraceItem* m_item;
    AxisLabels* m_labels;
    bool m_timeLabels;
    AxisRange m_range;
    View m_view;
};

}  // namespace nmc
