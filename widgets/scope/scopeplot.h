// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/scope/derivedsignals.h"
#include "widgets/scope/axisrange.h"
#include "widgets/scope/chartbackdrop.h"
#include "widgets/scope/scopemodule.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

class Underlay;

/// The times of the two cursors, seconds since the history's zero.
using CursorTimes = std::array<double, 2>;

/// One strip of the scope: some signals over time on one value axis. It draws; what is to be seen is decided
/// by its owner, whom it tells what mouse and wheel want.
class ScopePlot : public QWidget {
    Q_OBJECT

public:
    struct Trace {
        ModuleIndex module;
        ScopeSignal signal = ScopeSignal::Position;
        LinearScale scale;
        QString label;
        QString tag;  ///< empty where there is one module only
        double samplesPerSecond = 0;
        std::vector<double> limits{};  ///< of travel, drawn as lines
        bool operator==(const Trace&) const = default;
    };
    /// The visible time, in seconds since `zero`.
    struct View {
        TimePoint zero;
        double left = 0;
        double right = 10;
        double division = 1;
        double sharpness = 1;  ///< device pixels in a pixel
        bool operator==(const View&) const = default;
    };

    /// `timeLabels`: only the lowest of a stack of strips says the time.
    explicit ScopePlot(QWidget* parent = nullptr);

    void setTraces(std::vector<Trace> traces);
    [[nodiscard]] const std::vector<Trace>& traces() const { return m_traces; }
    void setTimeLabels(bool shown);
    /// One frame. `now` (s) paces the value axis while that fits itself; `derived` has what samples have not;
    /// `under` is drawn pale below the traces.
    void showFrame(const View& view, const History& history, double now, const DerivedSignals& derived = {},
                   const Underlay* under = nullptr);
    /// Other data: the value axis may jump.
    void forget();
    void showCursors(const std::optional<CursorTimes>& cursors);
    /// Where something happened, s.
    void showMarker(const std::optional<double>& seconds);
    /// A level across the strip, where a trigger looks.
    void showLevel(const std::optional<double>& level);

    /// Whether the value axis fits itself to what is seen; zooming or moving it ends that.
    [[nodiscard]] bool fits() const { return !m_manual; }
    void fit();
    void zoomValues(double factor, double at);
    /// By a share of what is seen.
    void panValues(double share);

    /// For lining up strips: the room that the labels left of the plot area need, and what to leave.
    [[nodiscard]] int labelWidth() const { return m_backdrop.labelWidth(); }
    void leaveLeft(int width);

    [[nodiscard]] QRectF plotArea() const { return m_backdrop.plotArea(); }
    [[nodiscard]] AxisRange::Range valueRange() const;
    /// What the strip says of a band that it does not show whole; empty when it does.
    [[nodiscard]] const QString& bandNotice() const { return m_bandNotice; }
    [[nodiscard]] QString legendText(std::size_t trace) const { return m_backdrop.legendText(trace); }
    /// In vectors where the painter can.
    void renderTo(QPainter& painter);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// There is a new frame, or new axes, and update() shows it.
    void paintWanted();
    /// More than 1 shows more; `at` (s) stays.
    void timeZoomed(double factor, double at);
    void timePanned(double seconds);
    void timeChosen(double left, double right);
    void cursorMoved(int cursor, double seconds);
    /// Double click: all of it.
    void everythingWanted();
    void focusWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    enum class Drag : std::uint8_t { None, Pan, Cursor1, Cursor2, Choose };

    void adoptPalette();
    void fitValues(double now);
    void noteBand();
    void setValueAxis(const AxisRange::Range& range);
    void paintOver(QPainter& painter);
    void paintCursors(QPainter& painter) const;
    [[nodiscard]] double smallestSpan() const;
    [[nodiscard]] std::optional<int> cursorAt(const QPointF& position) const;

    ChartBackdrop m_backdrop;
    std::vector<Trace> m_traces;
    std::vector<TraceDrawing> m_drawings;
    std::vector<TraceDrawing> m_under;  ///< of the same traces
    View m_view;
    bool m_timeLabels = true;
    AxisRange m_range;
    std::optional<AxisRange::Range> m_manual;
    PlotGeometry m_geometry;
    std::optional<CursorTimes> m_cursors;
    std::optional<double> m_marker;
    std::optional<double> m_level;
    QString m_bandNotice;
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;
    QPointF m_dragTo;
};

}  // namespace nmc
