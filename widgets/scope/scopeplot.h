// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "model/scope/derivedsignals.h"
#include "widgets/scope/axisrange.h"
#include "widgets/scope/plotcanvas.h"
#include "widgets/scope/scopemodule.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

class Underlay;

/// The times of the two cursors, seconds since the history's zero.
using CursorTimes = PlotCanvas::Cursors;

/// One strip of the scope: signals over time on one value axis. Its owner decides which time is visible, and
/// receives what the user requests with the mouse and the wheel.
class ScopePlot : public PlotCanvas {
    Q_OBJECT

public:
    struct Trace {
        ModuleIndex module;
        ScopeSignal signal = ScopeSignal::Position;
        LinearScale scale;
        QString label;
        QString tag;  ///< empty if all traces belong to the same module
        double samplesPerSecond = 0;
        std::vector<double> limits{};  ///< travel limits, drawn as lines
        bool operator==(const Trace&) const = default;
    };
    /// The visible time, in seconds since `zero`.
    struct View {
        TimePoint zero;
        double left = 0;
        double right = 10;
        double division = 1;
        double sharpness = 1;  ///< device pixels per pixel
    };

    explicit ScopePlot(QWidget* parent = nullptr);

    void setTraces(std::vector<Trace> traces);
    [[nodiscard]] const std::vector<Trace>& traces() const { return m_traces; }
    /// Only the lowest of a stack of strips shows the times.
    void setTimeLabels(bool shown);
    /// Shows one frame. `now` (s) paces the value axis while it fits itself; `derived` contains the signals
    /// that samples do not; `under` is drawn in pale colours under the traces.
    void showFrame(const View& view, const History& history, double now, const DerivedSignals& derived = {},
                   const Underlay* under = nullptr);
    /// Call when the data are replaced: the value axis may then jump.
    void forget();
    void showCursors(const std::optional<CursorTimes>& cursors) { setCursors(cursors); }
    /// Marks the time of an event, in s.
    void showMarker(const std::optional<double>& seconds);
    /// Shows the level of a trigger as a line across the strip.
    void showLevel(const std::optional<double>& level);

    /// True if the value axis fits itself to the visible values; zooming or moving it ends that.
    [[nodiscard]] bool fits() const { return !m_manual; }
    void fit();
    void zoomValues(double factor, double at) override;
    /// Moves by a share of the visible range.
    void panValues(double share);

    /// For aligning strips: the width that the labels to the left of the plot area need; leaveLeft() sets the
    /// width that they get.
    [[nodiscard]] int labelWidth() const { return m_frame.labelWidth(); }
    void leaveLeft(int width);

    [[nodiscard]] AxisRange::Range valueRange() const;
    /// The note about a band that the strip does not show completely; empty if it does.
    [[nodiscard]] const QString& bandNotice() const { return m_bandNotice; }
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// There is a new frame, or new axes; update() shows it.
    void paintWanted();
    /// A `factor` above 1 shows more; `at` (s) stays in place.
    void timeZoomed(double factor, double at);
    void timePanned(double seconds);
    void timeChosen(double left, double right);
    void cursorMoved(int cursor, double seconds);
    /// After a double click: everything is to be shown.
    void everythingWanted();
    void focusWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void zoomTime(double factor, double at) override { emit timeZoomed(factor, at); }
    void pan(double timeShare, double valueShare) override;
    void showTime(double left, double right) override { emit timeChosen(left, right); }
    void moveCursor(std::size_t cursor, double seconds) override {
        emit cursorMoved(static_cast<int>(cursor), seconds);
    }
    void showEverything() override { emit everythingWanted(); }
    void refreshLegend() override { setTraces(m_traces); }
    void paintTraces(QPainter& painter) override;
    void paintMarks(QPainter& painter) override;

private:
    void fitValues(double now);
    void noteBand();
    void setValueAxis(const AxisRange::Range& range);
    [[nodiscard]] double smallestSpan() const;

    std::vector<Trace> m_traces;
    std::vector<TraceDrawing> m_drawings;
    std::vector<TraceDrawing> m_under;  ///< of the recording under the traces, in the order of m_traces
    bool m_timeLabels = true;
    AxisRange m_range;
    std::optional<AxisRange::Range> m_manual;
    std::optional<double> m_marker;
    std::optional<double> m_level;
    QString m_bandNotice;
};

}  // namespace nmc
