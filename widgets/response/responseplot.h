// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/response/responsestrips.h"
#include "widgets/scope/plotframe.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

struct Prediction;

/// One or two step responses over the time since their step, relative to their start: A solid, B dashed, with
/// the goal and the settling band; below them error and PWM. Shows the transient; a double click switches to
/// the whole record and back. Wheel, mouse and keys zoom and move the plot as they do a strip of the scope.
class ResponsePlot : public QWidget {
    Q_OBJECT

public:
    explicit ResponsePlot(QWidget* parent = nullptr);

    /// `a` and `b` may be null. `others`, oldest first, are drawn in pale colours behind them, the oldest
    /// palest.
    void showRuns(const KeptResponse* a, const KeptResponse* b,
                  const std::vector<const KeptResponse*>& others = {});
    /// Draws over the run `about` what the motor model would have done (`fitted`), and what it would do with
    /// suggested gains (`predicted`). `about` and `predicted` may be null.
    void showModel(const KeptResponse* about, const std::vector<ResponsePoint>& fitted,
                   const Prediction* predicted);

    /// Shows two cursors to measure with, within the visible time.
    void showCursors(bool shown);
    /// The readings of the cursors: a row each for the time, A and B, with a name, the reading at each
    /// cursor, and the difference. Empty while the cursors are hidden.
    [[nodiscard]] std::vector<std::array<QString, 4>> readings() const;
    /// Shows the transient again.
    void fitTransient();
    /// Draws vectors if the painter supports them.
    void renderTo(QPainter& painter);

    [[nodiscard]] QString legendText(std::size_t entry) const { return m_frame.legendText(entry); }
    /// Where this point is drawn; `value` is in the unit of the axis.
    [[nodiscard]] QPointF pointAt(double seconds, double value) const;
    [[nodiscard]] const PlotGeometry& geometryShown() const { return m_geometry; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// readings() has changed.
    void measured();
    void cursorsWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// In seconds and in the unit of the axis.
    struct Curve {
        std::vector<QPolygonF> parts;  ///< samples are missing between them
        double goal = 0;
        double band = 0;
        double bandPercent = 0;
        double record = 0;
        double transient = 0;  ///< s to show, until the motor stays at rest
        QString label;
        QString unit;

        /// Interpolated linearly between samples.
        [[nodiscard]] std::optional<double> at(double seconds) const;
        [[nodiscard]] bool sameGoal(const Curve& other) const {
            return goal == other.goal && band == other.band;
        }
    };

    [[nodiscard]] static Curve curveOf(const KeptResponse& kept, const AxisScale& scale);
    [[nodiscard]] static QPolygonF lineOf(const KeptResponse& about,
                                          const std::vector<ResponsePoint>& points);
    enum class Drag : std::uint8_t { None, Pan, Cursor1, Cursor2, Choose };
    /// A visible range of time and values.
    struct View {
        double left, right, bottom, top;
    };

    void paintRange(QPainter& painter) const;
    void paintLevel(QPainter& painter, double value, double from, double to) const;
    void paintOver(QPainter& painter);
    void paintCursors(QPainter& painter) const;
    void paintTitles(QPainter& painter) const;
    [[nodiscard]] View fitted() const;
    [[nodiscard]] View seen() const;
    void showView(const View& view);
    /// A `factor` above 1 shows more; `at` stays in place.
    void zoomTime(double factor, double at);
    void zoomValues(double factor, double at);
    void pan(double timeShare, double valueShare);
    [[nodiscard]] std::optional<std::size_t> cursorAt(const QPointF& position) const;
    void adoptPalette();
    void fit();
    /// Height of the strips below the plot in pixels; 0 if there is no run, or no room for them.
    [[nodiscard]] int stripsHeight() const;
    void paintGoal(QPainter& painter, const Curve& curve) const;
    void paintCurve(QPainter& painter, std::size_t which) const;
    void paintOthers(QPainter& painter) const;
    [[nodiscard]] QColor colour(std::size_t which) const;

    PlotFrame m_frame;
    std::array<std::optional<Curve>, 2> m_curves;
    std::vector<Curve> m_others;
    QPolygonF m_fitted;
    QPolygonF m_predicted;
    QPolygonF m_range;  ///< around m_predicted, closed
    PlotGeometry m_geometry;
    ResponseStrips m_strips;
    bool m_whole = false;  ///< shows the whole record instead of the transient
    std::optional<View> m_view;
    std::optional<std::array<double, 2>> m_cursors;  ///< s
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;
    QPointF m_dragTo;
};

}  // namespace nmc
