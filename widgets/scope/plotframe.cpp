// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/plotframe.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "widgets/common/look.h"
#include "widgets/scope/scopewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kLegendOpacity = 128;   ///< of 255: the traces behind it can be made out
constexpr double kMarkerWidth = 1.5;  ///< of a line in the legend, in heights of its text
}  // namespace

void PlotFrame::invalidate() {
    m_outdated = true;
    emit changed();
}

template <typename T>
void PlotFrame::set(T& part, const T& value) {
    if (part == value)
        return;
    part = value;
    invalidate();
}

void PlotFrame::setLegend(const std::vector<LegendEntry>& entries) {
    if (entries != m_legend)
        m_legendPicture = {};
    set(m_legend, entries);
}

QString PlotFrame::legendText(std::size_t entry) const {
    return entry < m_legend.size() ? m_legend[entry].label : QString();
}

void PlotFrame::setLook(const QPalette& palette, const QFont& font) {
    m_font = font;
    m_text = palette.color(QPalette::Active, QPalette::Text);
    m_base = palette.color(QPalette::Active, QPalette::Base);
    m_axes = look::mutedText(palette);
    m_grid = look::faintLine(palette);
    m_legendPicture = {};
    measureLabels();
    invalidate();
}

void PlotFrame::resize(const QSizeF& size) {
    m_legendPicture = {};
    set(m_size, size);
}

void PlotFrame::setMargins(int left, int right, int bottom) {
    // Above, there is room for half of the topmost number.
    const QMargins margins(left, static_cast<int>(std::ceil(textHeight() * 0.6)), right, bottom);
    if (margins != m_margins)
        m_legendPicture = {};
    set(m_margins, margins);
}

void PlotFrame::setTimeAxis(double left, double right, double division, double labelInterval) {
    set(m_times, Axis{left, right, division});
    set(m_labelInterval, labelInterval);
}

void PlotFrame::setTimeUnit(const QString& unit) {
    set(m_timeUnit, unit);
}

void PlotFrame::setValueAxis(double bottom, double top, double interval) {
    const Axis axis{bottom, top, interval};
    if (m_values == axis)
        return;
    m_values = axis;
    measureLabels();
    invalidate();
}

QRectF PlotFrame::plotArea() const {
    return QRectF(QPointF(), m_size).marginsRemoved(m_margins);
}

double PlotFrame::textHeight() const {
    return QFontMetricsF(m_font).height();
}

double PlotFrame::gap() const {
    return textHeight() * 0.4;
}

void PlotFrame::measureLabels() {
    const QFontMetricsF metrics(m_font);
    const double widest =
        std::max(metrics.horizontalAdvance(texts::numberAt(m_values.from, m_values.interval)),
                 metrics.horizontalAdvance(texts::numberAt(m_values.to, m_values.interval)));
    m_labelWidth = static_cast<int>(std::ceil(widest + gap()));
}

const QPixmap& PlotFrame::picture(double devicePixelRatio) {
    const QSize pixels = (m_size * devicePixelRatio).toSize();
    if (!m_outdated && m_picture.size() == pixels)
        return m_picture;
    m_picture = QPixmap(pixels);
    m_picture.setDevicePixelRatio(devicePixelRatio);
    QPainter painter(&m_picture);
    render(painter);
    m_outdated = false;
    return m_picture;
}

void PlotFrame::render(QPainter& painter) const {
    painter.save();
    painter.fillRect(QRectF(QPointF(), m_size), m_base);
    if (!plotArea().isEmpty()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setFont(m_font);
        paintLines(painter);
        paintNumbers(painter);
    }
    painter.restore();
}

// ---- axes and grid ----

std::vector<double> PlotFrame::Axis::multiplesOf(double step) const {
    // Far more than there is room for; rounding could keep the end from being reached.
    constexpr int kMost = 1'000;
    std::vector<double> multiples;
    if (!(to > from && step > 0))
        return multiples;
    const double first = std::ceil(from / step - 1e-6);
    for (int i = 0; i < kMost && (first + i) * step <= to + 1e-6 * step; ++i)
        multiples.push_back((first + i) * step);
    return multiples;
}

void PlotFrame::paintLines(QPainter& painter) const {
    const PlotGeometry at = geometry();
    painter.setPen(QPen(m_grid, 1));
    for (const double value : m_values.multiplesOf(m_values.interval))
        painter.drawLine(at.across(value));
    for (const double time : m_times.multiplesOf(m_times.interval))
        painter.drawLine(at.down(time));
    painter.setPen(QPen(m_axes, 1));
    painter.drawLine(QLineF(at.area.topLeft(), at.area.bottomLeft()));
    painter.drawLine(QLineF(at.area.bottomLeft(), at.area.bottomRight()));
}

void PlotFrame::paintNumbers(QPainter& painter) const {
    const PlotGeometry at = geometry();
    const double height = textHeight();
    painter.setPen(m_text);
    for (const double value : m_values.multiplesOf(m_values.interval))
        painter.drawText(
            QRectF(at.area.left() - labelWidth(), at.y(value) - height / 2, labelWidth() - gap(), height),
            Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, texts::numberAt(value, m_values.interval));
    const QString unit = m_timeUnit.isEmpty() ? QString() : u' ' + m_timeUnit;
    for (const double time : m_times.multiplesOf(m_labelInterval))
        painter.drawText(QRectF(at.x(time) - 4 * height, at.area.bottom() + gap() / 2, 8 * height, height),
                         Qt::AlignHCenter | Qt::AlignTop, texts::numberAt(time, m_labelInterval) + unit);
}

// ---- legend ----

/// At the top left, where the traces are oldest, in as many rows as it needs.
std::vector<PlotFrame::Placed> PlotFrame::placedLegend() const {
    const QRectF area = plotArea().adjusted(gap(), gap() / 2, -gap(), 0);
    const QFontMetricsF metrics(m_font);
    const double beside = kMarkerWidth * textHeight() + 2 * gap();
    std::vector<Placed> placed;
    QPointF at = area.topLeft();
    for (const LegendEntry& entry : m_legend) {
        const QString label = metrics.elidedText(entry.label, Qt::ElideRight, area.width() - beside);
        const double width = beside + metrics.horizontalAdvance(label);
        if (at.x() > area.left() && at.x() + width > area.right())
            at = QPointF(area.left(), at.y() + textHeight());
        placed.push_back({QRectF(at, QSizeF(width, textHeight())), label});
        at.rx() += width + gap();
    }
    return placed;
}

void PlotFrame::drawLegend(QPainter& painter, const std::vector<Placed>& entries) const {
    const double marker = kMarkerWidth * textHeight();
    QColor behind = m_base;
    behind.setAlpha(kLegendOpacity);
    painter.save();
    painter.setFont(m_font);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF& area = entries[i].area;
        painter.fillRect(area, behind);
        QPen pen(m_legend[i].colour, 2, Qt::SolidLine, Qt::FlatCap);
        if (m_legend[i].dashed)
            pen.setDashPattern({marker / 5, marker / 10});  // in widths of the pen: two dashes fit
        painter.setPen(pen);
        painter.drawLine(QLineF(area.left(), area.center().y(), area.left() + marker, area.center().y()));
        painter.setPen(m_text);
        painter.drawText(QPointF(area.left() + marker + gap(), area.top() + QFontMetricsF(m_font).ascent()),
                         entries[i].label);
    }
    painter.restore();
}

/// On a screen, a picture: drawing the text in every frame costs a tenth of it. On paper, vectors.
void PlotFrame::paintLegend(QPainter& painter) {
    if (m_legend.empty() || plotArea().isEmpty())
        return;
    const auto* screen = dynamic_cast<const QWidget*>(painter.device());
    if (screen == nullptr)
        return drawLegend(painter, placedLegend());
    const double ratio = screen->devicePixelRatioF();
    if (m_legendPicture.isNull() || m_legendPicture.devicePixelRatio() != ratio) {
        const std::vector<Placed> entries = placedLegend();
        QRectF area;
        for (const Placed& entry : entries)
            area |= entry.area;
        m_legendAt = area.topLeft();
        m_legendPicture = QPixmap((area.size() * ratio).toSize() + QSize(1, 1));
        m_legendPicture.setDevicePixelRatio(ratio);
        m_legendPicture.fill(Qt::transparent);
        QPainter picture(&m_legendPicture);
        picture.translate(-m_legendAt);
        drawLegend(picture, entries);
    }
    painter.drawPixmap(m_legendAt, m_legendPicture);
}

}  // namespace nmc
