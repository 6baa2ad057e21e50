// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>
#include <array>
#include <cstdint>
#include <optional>

#include "widgets/scope/plotframe.h"
#include "widgets/scope/plotgeometry.h"

namespace nmc {

/// A plot over time that is moved and measured with the mouse, everywhere in the same way: dragging pans,
/// dragging with Shift selects a time, and a cursor can be dragged; the wheel zooms the time, with Ctrl the
/// values, and pans with Shift; a double click shows everything. It paints the frame, the legend, the cursors
/// and the selected time. A derived plot paints its traces, and decides what is visible. GUI thread.
class PlotCanvas : public QWidget {
    Q_OBJECT

public:
    /// In seconds, as the axis.
    using Cursors = std::array<double, 2>;

    explicit PlotCanvas(QWidget* parent);

    [[nodiscard]] QRectF plotArea() const { return m_frame.plotArea(); }
    [[nodiscard]] QString legendText(std::size_t entry) const { return m_frame.legendText(entry); }
    /// Draws vectors if the painter supports them.
    void renderTo(QPainter& painter);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

    // ---- what the user requests ----

    /// A `factor` above 1 shows more; `at` stays in place (s).
    virtual void zoomTime(double factor, double at) = 0;
    /// The same; `at` is in the unit of the axis.
    virtual void zoomValues(double factor, double at) = 0;
    /// By shares of the visible ranges.
    virtual void pan(double timeShare, double valueShare) = 0;
    virtual void showTime(double left, double right) = 0;
    virtual void moveCursor(std::size_t cursor, double seconds) = 0;
    virtual void showEverything() = 0;

    // ---- for the derived plot ----

    /// To be called by its constructor, and called again when palette or font change.
    void adoptPalette();
    virtual void refreshLegend() = 0;
    /// Painted below the legend.
    virtual void paintTraces(QPainter& painter) = 0;
    /// Painted between the legend and the cursors.
    virtual void paintMarks(QPainter& /*painter*/) {}
    [[nodiscard]] const std::optional<Cursors>& cursors() const { return m_cursors; }
    void setCursors(const std::optional<Cursors>& cursors);

    static constexpr double kPan = 0.1;  ///< share of the visible range, for each notch or key
    PlotFrame m_frame;
    PlotGeometry m_geometry;

private:
    enum class Drag : std::uint8_t { None, Pan, Cursor1, Cursor2, Choose };

    void paintOver(QPainter& painter);
    void paintCursors(QPainter& painter) const;
    [[nodiscard]] std::optional<std::size_t> cursorAt(const QPointF& position) const;

    std::optional<Cursors> m_cursors;
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;
    QPointF m_dragTo;
};

}  // namespace nmc
