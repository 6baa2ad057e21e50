// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responsestrips.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "model/response/responsedrive.h"
#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/unitwords.h"
#include "widgets/common/words.h"
#include "widgets/response/plotline.h"

namespace nmc {

namespace {
class StripTexts {
    Q_DECLARE_TR_FUNCTIONS(StripTexts)
};
constexpr double kStripTraceWidth = 1.3;
}  // namespace

void ResponseStrips::show(const KeptResponse* a, const KeptResponse* b, const AxisScale* scaleOfB) {
    constexpr double kBands = 4.0;         // above and below the goal
    constexpr double kFewestCounts = 4.0;  // an encoder reports whole counts
    m_curves = {};
    const KeptResponse* first = a != nullptr ? a : b;
    if (first == nullptr)
        return;
    const AxisScale& firstScale = a != nullptr ? a->scale : *scaleOfB;
    m_unit = texts::unitOf(firstScale);
    m_band = firstScale.distance(first->run.band());
    m_zoom = std::max(kBands * m_band, firstScale.distance(kFewestCounts));
    m_limit = 1.0;
    for (const KeptResponse* kept : {a, b}) {
        if (kept == nullptr)
            continue;
        Curve& curve = m_curves[kept == a ? 0 : 1];
        const AxisScale& scale = kept == a ? a->scale : *scaleOfB;
        for (const DrivePoint& point : driveOf(kept->run)) {
            curve.error << QPointF(point.seconds, scale.position(point.error));
            curve.pwm << QPointF(point.seconds, point.pwm);
        }
        if (kept->run.move && kept->run.move->peak)
            m_zoom = std::max(m_zoom, scale.distance(kept->run.move->peak->value));
        const ResponseMetrics& metrics = kept->run.metrics;
        if (metrics.steadyError)
            m_zoom = std::max(m_zoom, 2 * scale.distance(std::abs(metrics.steadyError->value)));
        const servo::SetGain& gains = kept->run.taken.gains;
        m_limit = std::max<double>(m_limit, std::min(gains.ol + gains.db.value_or(0), 255));
    }
}

void ResponseStrips::paint(QPainter& painter, const QRectF& place, const PlotGeometry& above,
                           const QPalette& palette) const {
    const double em = QFontMetricsF(painter.font()).height();
    const double gap = em;  // for the numbers at the edges of both strips
    const double high = (place.height() - 3 * gap) / 2;
    PlotGeometry geometry = above;
    geometry.area = QRectF(above.area.left(), place.top() + gap, above.area.width(), high);
    geometry.bottom = -m_zoom;
    geometry.top = m_zoom;
    paintStrip(painter, geometry, StripTexts::tr("error, zoomed (%1)").arg(m_unit), m_band, &Curve::error,
               palette);
    geometry.area.translate(0, high + gap);
    // The limit itself is not drawn on the edge.
    geometry.bottom = -m_limit * 1.08;
    geometry.top = m_limit * 1.08;
    paintStrip(painter, geometry, StripTexts::tr("PWM, calculated (of 255)"), 0.0, &Curve::pwm, palette);
}

void ResponseStrips::paintStrip(QPainter& painter, const PlotGeometry& geometry, const QString& title,
                                double band, QPolygonF Curve::*line, const QPalette& palette) const {
    const QRectF& area = geometry.area;
    const double em = QFontMetricsF(painter.font()).height();
    const QColor muted = look::mutedText(palette);
    if (band > 0) {
        QColor fill = muted;
        fill.setAlpha(kBandAlpha);
        painter.fillRect(
            QRectF(QPointF(area.left(), geometry.y(band)), QPointF(area.right(), geometry.y(-band))), fill);
    }
    painter.setPen(QPen(muted, 1));
    painter.drawRect(area);
    painter.drawLine(geometry.across(0));
    const double limit = band > 0 ? m_zoom : m_limit;
    for (const double value : {-limit, 0.0, limit})
        painter.drawText(QRectF(0, geometry.y(value) - em / 2, area.left() - em / 4, em),
                         Qt::AlignRight | Qt::AlignVCenter, texts::readout(value, 2));
    painter.save();
    painter.setClipRect(area);
    for (const std::size_t which : {std::size_t{1}, std::size_t{0}}) {
        QPen pen(look::traceColour(static_cast<int>(which), palette), kStripTraceWidth, Qt::SolidLine,
                 Qt::FlatCap);
        if (which == 1)
            pen.setDashPattern({4, 2.5});
        painter.setPen(pen);
        paintLine(painter, geometry, m_curves[which].*line);
    }
    painter.restore();
    painter.setPen(muted);
    painter.drawText(area.adjusted(em / 3, 0, -em / 3, 0), Qt::AlignRight | Qt::AlignTop, title);
}

}  // namespace nmc
