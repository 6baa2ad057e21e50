// SPDX-License-Identifier: MIT
#include "model/scope/stretchfigures.h"

#include <algorithm>
#include <cmath>

namespace nmc {

namespace {

constexpr double kFewestPoints = 4;  ///< points per period; fewer could belong to any rate
constexpr int kFewestPeriods = 2;
constexpr double kRegular = 0.2;     ///< permitted relative deviation of a period from the average
constexpr double kHysteresis = 0.5;  ///< relative to the RMS; a sine peaks at 1.4, so noise is not counted

void takeMeans(const std::vector<SignalPoint>& points, StretchFigures& figures) {
    double time = 0, sum = 0, squares = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!points[i].joined)
            continue;
        const double a = points[i - 1].value;
        const double b = points[i].value;
        const double seconds = points[i].seconds - points[i - 1].seconds;
        time += seconds;
        sum += seconds * (a + b) / 2;
        squares += seconds * (a * a + a * b + b * b) / 3;
    }
    if (time == 0) {  // only unconnected points
        for (const SignalPoint& point : points) {
            sum += point.value;
            squares += point.value * point.value;
        }
        time = static_cast<double>(points.size());
    }
    figures.mean = sum / time;
    figures.rms = std::sqrt(squares / time);
}

/// The times at which a signal crosses a line, separately for each direction, so that the duty cycle does not
/// matter.
class Crossings {
public:
    explicit Crossings(double threshold) : m_threshold(threshold) {}

    /// `above`: the distance above the line.
    void take(double seconds, double above, bool joined) {
        if (!joined) {  // what precedes a gap says nothing about a period across it
            m_side = 0;
            m_up.reset();
            m_down.reset();
        } else if ((above > 0) != (m_above > 0)) {
            m_crossed = m_seconds + (seconds - m_seconds) * m_above / (m_above - above);
        }
        m_seconds = seconds;
        m_above = above;
        if (const int side = above >= m_threshold ? 1 : above <= -m_threshold ? -1 : 0; side != 0) {
            if (m_side == -side)
                add(side > 0 ? m_up : m_down, m_crossed);
            m_side = side;
        }
    }
    [[nodiscard]] const std::vector<double>& periods() const { return m_periods; }

private:
    void add(std::optional<double>& last, double now) {
        if (last)
            m_periods.push_back(now - *last);
        last = now;
    }

    double m_threshold;
    double m_seconds = 0, m_above = 0;
    double m_crossed = 0;
    int m_side = 0;
    std::optional<double> m_up, m_down;
    std::vector<double> m_periods;
};

std::optional<double> frequency(const std::vector<SignalPoint>& points, const SignalLine& line,
                                double resolution) {
    double squares = 0;
    for (const SignalPoint& point : points)
        squares += std::pow(point.value - line.at(point.seconds), 2);
    const double rms = std::sqrt(squares / static_cast<double>(points.size()));
    // Rounding residues of a straight line are not a signal.
    if (rms <= 1e-9 * (std::abs(line.value) + std::abs(line.slope)) || rms < resolution)
        return std::nullopt;
    Crossings crossings(kHysteresis * rms);
    for (const SignalPoint& point : points)
        crossings.take(point.seconds, point.value - line.at(point.seconds), point.joined);
    const std::vector<double>& periods = crossings.periods();
    if (periods.size() < kFewestPeriods)
        return std::nullopt;
    double mean = 0;
    for (const double period : periods)
        mean += period / static_cast<double>(periods.size());
    const bool regular = std::ranges::all_of(
        periods, [mean](double period) { return std::abs(period - mean) <= kRegular * mean; });
    const double spacing =
        (points.back().seconds - points.front().seconds) / static_cast<double>(points.size() - 1);
    if (!regular || mean < kFewestPoints * spacing)
        return std::nullopt;
    return 1 / mean;
}

}  // namespace

std::optional<SignalLine> lineThrough(const std::vector<SignalPoint>& points) {
    const auto count = static_cast<double>(points.size());
    SignalLine line;
    for (const SignalPoint& point : points) {
        line.seconds += point.seconds / count;
        line.value += point.value / count;
    }
    double along = 0, across = 0;
    for (const SignalPoint& point : points) {
        const double from = point.seconds - line.seconds;
        along += from * from;
        across += from * (point.value - line.value);
    }
    if (along == 0)
        return std::nullopt;
    line.slope = across / along;
    return line;
}

std::optional<StretchFigures> figuresOf(const std::vector<SignalPoint>& points, double resolution) {
    if (points.empty())
        return std::nullopt;
    StretchFigures figures;
    takeMeans(points, figures);
    const auto [low, high] = std::ranges::minmax_element(points, {}, &SignalPoint::value);
    figures.peakToPeak = high->value - low->value;
    if (const auto line = lineThrough(points)) {
        figures.slope = line->slope;
        figures.hertz = frequency(points, *line, resolution);
    }
    return figures;
}

}  // namespace nmc
