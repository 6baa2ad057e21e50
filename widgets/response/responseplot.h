// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <array>
#include <optional>
#include <vector>

#include "model/response/responsefile.h"
#include "widgets/response/responsestrips.h"
#include "widgets/scope/recordplot.h"

namespace nmc {

struct Prediction;

/// One or two step responses or profiled moves over the time since their step, relative to their start: A
/// solid, B dashed, with the goal and the settling band; below them error and PWM. Shows the transient; a
/// double click switches to the whole record and back. Wheel, mouse and keys zoom and move the plot as they
/// do a strip of the scope.
class ResponsePlot : public RecordPlot {
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
    void fitAgain() override;

signals:
    /// readings() has changed.
    void measured();
    void cursorsWanted();

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void moveCursor(std::size_t cursor, double seconds) override;
    /// The whole record, or the transient again.
    void showEverything() override;
    void refreshLegend() override;
    void paintTraces(QPainter& painter) override;
    [[nodiscard]] View fitted() const override;
    [[nodiscard]] QMargins room() const override;
    [[nodiscard]] int frameHeight() const override { return height() - stripsHeight(); }

private:
    /// In seconds and in the unit of the axis.
    struct Curve {
        std::vector<QPolygonF> parts;  ///< samples are missing between them
        QPolygonF command;             ///< of a profiled move
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

    void paintRange(QPainter& painter) const;
    void paintLevel(QPainter& painter, double value, double from, double to) const;
    void paintTitles(QPainter& painter) const;
    /// Height of the strips below the plot in pixels; 0 if there is no run, or no room for them.
    [[nodiscard]] int stripsHeight() const;
    void paintGoal(QPainter& painter, const Curve& curve) const;
    void paintCurve(QPainter& painter, std::size_t which) const;
    void paintOthers(QPainter& painter) const;
    [[nodiscard]] QColor colour(std::size_t which) const;

    std::array<std::optional<Curve>, 2> m_curves;
    std::vector<Curve> m_others;
    QPolygonF m_fitted;
    QPolygonF m_predicted;
    QPolygonF m_range;  ///< around m_predicted, closed
    ResponseStrips m_strips;
    bool m_whole = false;  ///< shows the whole record instead of the transient
};

}  // namespace nmc
