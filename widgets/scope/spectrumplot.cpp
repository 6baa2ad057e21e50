// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/spectrumplot.h"

#include <QPainter>
#include <algorithm>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"

namespace nmc {

using namespace Qt::StringLiterals;

SpectrumPlot::SpectrumPlot(QWidget* parent) : RecordPlot({36, 18}, {18, 10}, parent) {
    look::name(this, u"spectrumPlot"_s, tr("Spectrum"));
    setToolTip(tr(
        "The sines in the signal, by frequency in Hz. The circle marks the highest that stands out from the noise. Double-click to show everything. Scroll to zoom the frequency, or the amplitudes with Ctrl; drag to pan; drag with Shift to select frequencies."));
    m_frame.setTimeUnit(u"Hz"_s);
    adoptPalette();
    fit();
}

void SpectrumPlot::showSpectrum(const Spectrum& spectrum, const QString& label) {
    m_spectrum = spectrum;
    m_label = m_spectrum.points.empty() ? QString() : label;
    refreshLegend();
    fit();
}

RecordPlot::View SpectrumPlot::fitted() const {
    if (m_spectrum.points.empty())
        return {0, 100, 0, 1};
    double highest = 0;
    for (const SpectrumPoint& point : m_spectrum.points)
        highest = std::max(highest, point.amplitude);
    constexpr double kPastPeak = 10;
    const double right = m_spectrum.points.back().hertz;
    return {0, m_spectrum.peak ? std::min(right, kPastPeak * m_spectrum.peak->hertz) : right, 0,
            highest > 0 ? highest : 1};
}

void SpectrumPlot::showEverything() {
    fitAgain();
    if (!m_spectrum.points.empty())
        showTime(0, m_spectrum.points.back().hertz);
}

void SpectrumPlot::paintTraces(QPainter& painter) {
    painter.setClipRect(m_geometry.area);
    QPolygonF line;
    for (const SpectrumPoint& point : m_spectrum.points)
        line << m_geometry.at(point.hertz, point.amplitude);
    painter.setPen(QPen(look::traceColour(0, palette()), kTraceWidth));
    painter.drawPolyline(line);
    if (const auto& peak = m_spectrum.peak) {
        painter.setPen(QPen(palette().color(QPalette::Text), kTraceWidth));
        const double radius = fontMetrics().height() / 3.0;
        painter.drawEllipse(m_geometry.at(peak->hertz, peak->amplitude), radius, radius);
    }
}

}  // namespace nmc
