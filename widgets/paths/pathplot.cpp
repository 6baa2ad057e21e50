// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/paths/pathplot.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "widgets/common/look.h"
#include "widgets/common/plots.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/unitwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

PathPlot::PathPlot(QWidget* parent) : QWidget(parent) {
    look::name(this, u"pathPlot"_s, tr("Positions of the path over time"));
}

void PathPlot::showPath(const PathTable& table, const std::vector<PathColumn>& axes) {
    m_lanes.clear();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const PathColumn& axis = axes[i];
        Lane lane;
        lane.title = Common::tr("%1 (%2)").arg(QString::fromStdString(axis.name), texts::unitOf(axis.scale));
        for (const std::int32_t point : table.columns[i].points)
            lane.points.push_back(axis.scale.position(point));
        const auto reach = std::ranges::minmax(table.columns[i].points);
        const auto [least, most] = axis.scale.ordered(reach.min, reach.max);
        lane.lowest = texts::position(axis.scale, least);
        lane.highest = texts::position(axis.scale, most);
        lane.bottom = axis.scale.position(least);
        lane.top = axis.scale.position(most);
        m_lanes.push_back(std::move(lane));
    }
    m_share = -1.0;
    forgetPicture();
}

void PathPlot::showNothing() {
    m_lanes.clear();
    forgetPicture();
}

void PathPlot::showProgress(double share) {
    if (std::exchange(m_share, share) != share)
        update();
}

void PathPlot::forgetPicture() {
    m_picture = {};
    update();
}

QRectF PathPlot::area(std::size_t lane) const {
    const double em = fontMetrics().height();
    const double each = (height() - em / 2) / static_cast<double>(std::max<std::size_t>(m_lanes.size(), 1));
    return {em / 2, each * static_cast<double>(lane) + em * 1.5, width() - em, each - em * 2};
}

void PathPlot::paintLane(QPainter& painter, const Lane& lane, const QRectF& area,
                         const QColor& colour) const {
    const int em = fontMetrics().height();
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(area.left(), area.top() - em * 1.4, area.width(), em * 1.3),
                     Qt::AlignLeft | Qt::AlignVCenter, lane.title);
    painter.setPen(look::mutedText(palette()));
    painter.drawText(QRectF(area.left(), area.top() - em * 1.4, area.width(), em * 1.3),
                     Qt::AlignRight | Qt::AlignVCenter, tr("%1 to %2").arg(lane.lowest, lane.highest));
    painter.setPen(look::faintLine(palette()));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(area);
    const double span = lane.top > lane.bottom ? lane.top - lane.bottom : 1.0;
    const QRectF inside = area.adjusted(0, 3, 0, -3);
    const auto y = [&](double value) {
        return inside.bottom() - (value - lane.bottom) / span * inside.height();
    };
    // Minimum and maximum of each pixel, so that no corner of the path is lost, however long it is.
    const std::size_t count = lane.points.size();
    const std::size_t columns = std::min(count, static_cast<std::size_t>(std::max(1.0, area.width())));
    QPolygonF line;
    for (std::size_t column = 0; column < columns; ++column) {
        const auto from = lane.points.begin() + static_cast<std::ptrdiff_t>(column * count / columns);
        const auto to = lane.points.begin() + static_cast<std::ptrdiff_t>((column + 1) * count / columns);
        const auto [least, most] = std::minmax_element(from, to);
        const double x =
            area.left() + area.width() * static_cast<double>(column + 1) / static_cast<double>(columns);
        line << QPointF(x, y(*std::min(least, most)));
        if (least != most)
            line << QPointF(x, y(*std::max(least, most)));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, kTraceWidth));
    painter.drawPolyline(line);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void PathPlot::drawPicture() {
    m_picture = QPixmap(size() * devicePixelRatioF());
    m_picture.setDevicePixelRatio(devicePixelRatioF());
    m_picture.fill(palette().color(QPalette::Window));
    QPainter painter(&m_picture);
    painter.setFont(look::tabular(font()));
    for (std::size_t i = 0; i < m_lanes.size(); ++i)
        paintLane(painter, m_lanes[i], area(i), look::traceColour(static_cast<int>(i), palette()));
}

void PathPlot::paintEvent(QPaintEvent* /*event*/) {
    if (m_picture.size() != size() * devicePixelRatioF())
        drawPicture();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    if (m_lanes.empty()) {
        painter.setPen(look::mutedText(palette()));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No path. Open a file, or draw one from a sequence."));
    }
    if (m_share < 0.0)
        return;
    painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        const QRectF lane = area(i);
        const double x = lane.left() + m_share * lane.width();
        painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
    }
}

void PathPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        forgetPicture();
}

QSize PathPlot::sizeHint() const {
    return {fontMetrics().height() * 26, fontMetrics().height() * 14};
}

QSize PathPlot::minimumSizeHint() const {
    return {fontMetrics().height() * 14, fontMetrics().height() * 8};
}

}  // namespace nmc
