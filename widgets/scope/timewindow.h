// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace nmc {

/// The time that the scope shows, in seconds since the history's zero: it rolls with the present, or stays
/// where the user has put it. Pure.
class TimeWindow {
public:
    static constexpr double kShortest = 1e-3;
    static constexpr double kLongest = 7 * 86'400.0;

    [[nodiscard]] double left() const { return m_left; }
    [[nodiscard]] double right() const { return m_right; }
    [[nodiscard]] double width() const { return m_right - m_left; }
    /// 1, 2 or 5 times a power of ten, about a tenth of the width.
    [[nodiscard]] double division() const;
    [[nodiscard]] bool rolls() const { return m_rolls; }

    /// Rolls from now on, in steps of a division: moving an axis costs more than the rest of a frame.
    void roll() { m_rolls = true; }
    void stand() { m_rolls = false; }
    /// Moves on to the present; does nothing while the window stands still.
    void follow(double now);
    /// Keeps the right edge.
    void setWidth(double seconds);
    /// Shows this time, and stands still.
    void show(double left, double right);
    /// A `factor` above 1 shows more. `at` stays in place. A window that rolls continues to do so, and keeps
    /// its right edge instead.
    void zoom(double factor, double at);
    /// Moves by `seconds`, and stands still.
    void pan(double seconds);

    /// 1, 2 or 5 times a power of ten, not below `rough`.
    [[nodiscard]] static double nice(double rough);

private:
    [[nodiscard]] static double allowed(double width);

    double m_left = 0;
    double m_right = 10;
    bool m_rolls = true;
};

}  // namespace nmc
