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
#include "widgets/scope/chartbackdrop.h"
#include "widgets/scope/tracedrawing.h"

namespace nmc {

struct Prediction;

/// One or two step responses over the time since their step, from where they began: A solid, B dashed, with
/// the goal and the settling band; below them error and PWM. As long as the transient lasts; a double click
/// shows the whole record, or that again. Wheel, mouse and keys zoom and move it as a strip of the scope.
class ResponsePlot : public QWidget {
    Q_OBJECT

public:
    explicit ResponsePlot(QWidget* parent = nullptr);

    /// Either may be null. `others`, oldest first, are drawn pale behind them, the oldest palest.
    void showRuns(const KeptResponse* a, const KeptResponse* b,
                  const std::vector<const KeptResponse*>& others = {});
    /// Over `about`, which may be null: what the motor that was found would have done, and what it would do
    /// with suggested gains, which may be null.
    void showModel(const KeptResponse* about, const std::vector<ResponsePoint>& fitted,
                   const Prediction* predicted);

    /// Two cursors to measure with; they come where they can be seen.
    void showCursors(bool shown);
    /// What they read: a row each for the time, A and B, of a name, what is at either cursor, and the
    /// difference. Empty while they are hidden.
    [[nodiscard]] std::vector<std::array<QString, 4>> readings() const;
    /// Once more as long as the transient lasts.
    void fitTransient();
    /// In vectors where the painter can.
    void renderTo(QPainter& painter);

    [[nodiscard]] QString legendText(std::size_t entry) const { return m_backdrop.legendText(entry); }
    /// Where that is drawn; value in the unit of the axis.
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
        std::vector<QPolygonF> parts;  ///< between them samples are missing
        double goal = 0;
        double band = 0;
        double bandPercent = 0;
        double record = 0;
        double transient = 0;  ///< s, until little happens any more
        QString label;
        QString unit;

        /// On a straight line between its neighbours.
        [[nodiscard]] std::optional<double> at(double seconds) const;
        [[nodiscard]] bool sameGoal(const Curve& other) const {
            return goal == other.goal && band == other.band;
        }
    };

    [[nodiscard]] static Curve curveOf(const KeptResponse& kept, const AxisScale& scale);
    [[nodiscard]] static QPolygonF lineOf(const KeptResponse& about,
                                          const std::vector<ResponsePoint>& points);
    enum class Drag : std::uint8_t { None, Pan, Cursor1, Cursor2, Choose };
    /// What the user has zoomed to.
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
    /// `factor` above 1 shows more; what is at `at` stays.
    void zoomTime(double factor, double at);
    void zoomValues(double factor, double at);
    void pan(double timeShare, double valueShare);
    [[nodiscard]] std::optional<std::size_t> cursorAt(const QPointF& position) const;
    void adoptPalette();
    void fit();
    /// How high the strips below the plot are, in pixels; 0 where there is no room for them.
    [[nodiscard]] int stripsHeight() const;
    void paintGoal(QPainter& painter, const Curve& curve) const;
    void paintCurve(QPainter& painter, std::size_t which) const;
    void paintOthers(QPainter& painter) const;
    [[nodiscard]] QColor colour(std::size_t which) const;

    ChartBackdrop m_backdrop;
    std::array<std::optional<Curve>, 2> m_curves;
    std::vector<Curve> m_others;
    QPolygonF m_fitted;
    QPolygonF m_predicted;
    QPolygonF m_range;  ///< around m_predicted, closed
    PlotGeometry m_geometry;
    ResponseStrips m_strips;
    bool m_whole = false;  ///< the whole record, and not the transient alone
    std::optional<View> m_view;
    std::optional<std::array<double, 2>> m_cursors;  ///< s
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;
    QPointF m_dragTo;
};

}  // namespace nmc
