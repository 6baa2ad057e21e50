// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QStaticText>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "model/scope/history.h"
#include "model/scope/linearscale.h"
#include "widgets/scope/plotgeometry.h"

class QPainter;

namespace nmc {

/// How far values reach; low > high if there are none. The band is that of a calculated error, and for other
/// signals that of the values.
struct Reach {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    double lowBand = low, highBand = high;

    [[nodiscard]] double span() const { return high - low; }
    void add(const Reach& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
        lowBand = std::min(lowBand, other.lowBand);
        highBand = std::max(highBand, other.highBand);
    }
};

/// The look of one trace, and its content in the present frame. On the screen it is drawn with drawLines, or
/// column by column where it is dense: QLineSeries would cost a hundred times as much, and drawPolyline ten
/// times (scope.md).
class TraceDrawing {
public:
    QColor colour;
    bool dashed = false;  ///< for a command position
    QStaticText tag;      ///< written at the end of the trace, where hue alone does not distinguish traces

    /// Takes the samples that are visible in `geometry`'s time; its range of values does not matter yet.
    void take(const ModuleHistory& history, ScopeSignal signal, const LinearScale& scale, TimePoint zero,
              const PlotGeometry& geometry, double devicePixelRatio);
    void clear();
    /// Within the visible time.
    [[nodiscard]] const Reach& reach() const { return m_reach; }
    /// The same without the most extreme hundredth of the columns, at most three: these are spikes.
    [[nodiscard]] Reach reachWithoutSpikes() const;

    /// The painter is clipped to the plot area.
    void paint(QPainter& painter, const PlotGeometry& geometry) const;
    /// Marks the highest and the lowest value at the edges of the plot area that they exceed.
    void paintExceeding(QPainter& painter, const PlotGeometry& geometry, double step) const;

private:
    /// At most a device pixel wide, or one sample.
    struct Column {
        double left, right;  ///< s
        double entry, exit;
        double bandLow, bandHigh;  ///< of a calculated error
        bool joined;               ///< to the previous column
    };
    /// The highest values of a sequence, in descending order.
    struct Highest {
        std::array<double, 4> values;

        Highest() { values.fill(-std::numeric_limits<double>::infinity()); }
        void add(double value) {
            for (double& kept : values)
                if (value > kept)
                    std::swap(value, kept);
        }
    };
    [[nodiscard]] static double dashesPerSecond(const PlotGeometry& geometry);
    /// Passes each visible line to `add`, clipped, with the times of its ends.
    template <typename Add>
    void visitLines(const PlotGeometry& geometry, Add&& add) const;
    void paintLines(QPainter& painter, const PlotGeometry& geometry) const;
    void paintPath(QPainter& painter, const PlotGeometry& geometry) const;
    void paintDense(QPainter& painter, const PlotGeometry& geometry) const;
    void paintBand(QPainter& painter, const PlotGeometry& geometry) const;
    void paintTag(QPainter& painter, const PlotGeometry& geometry) const;

    std::vector<Column> m_columns;
    Reach m_reach;
    Highest m_highs, m_highBands, m_negatedLows, m_negatedLowBands;
    std::size_t m_visible = 0;               ///< columns
    double m_lowestAt = 0, m_highestAt = 0;  ///< s
    bool m_hasBand = false;
};

}  // namespace nmc
