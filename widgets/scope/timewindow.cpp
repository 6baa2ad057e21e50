// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/timewindow.h"

#include <algorithm>
#include <cmath>

namespace nmc {

double TimeWindow::nice(double rough) {
    const double magnitude = std::pow(10.0, std::floor(std::log10(rough)));
    const double ratio = rough / magnitude;
    return (ratio <= 1.001 ? 1 : ratio <= 2.001 ? 2 : ratio <= 5.001 ? 5 : 10) * magnitude;
}

double TimeWindow::allowed(double width) {
    return std::clamp(width, kShortest, kLongest);
}

double TimeWindow::division() const {
    return nice(width() / 10);
}

void TimeWindow::follow(double now) {
    if (!m_rolls)
        return;
    const double width = m_right - m_left;
    const double step = division();
    // There is nothing before 0, so at first the window begins there and the trace fills it from the left.
    m_right = std::max(std::ceil(now / step) * step, width);
    m_left = m_right - width;
}

void TimeWindow::setWidth(double seconds) {
    m_left = m_right - allowed(seconds);
}

void TimeWindow::show(double left, double right) {
    m_rolls = false;
    const double width = allowed(right - left);
    const double middle = (left + right) / 2;
    m_left = middle - width / 2;
    m_right = middle + width / 2;
}

void TimeWindow::zoom(double factor, double at) {
    const double wanted = allowed(width() * factor);
    const double share = std::clamp((at - m_left) / width(), 0.0, 1.0);
    if (!m_rolls)
        m_right = at + (1 - share) * wanted;
    m_left = m_right - wanted;
}

void TimeWindow::pan(double seconds) {
    m_rolls = false;
    m_left += seconds;
    m_right += seconds;
}

}  // namespace nmc
