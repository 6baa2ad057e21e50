// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/glyphs.h"

#include <QPainter>
#include <QPainterPath>
#include <utility>

#include "widgets/common/look.h"

namespace nmc {

namespace {

QRectF square(const QRectF& rect) {
    const double side = std::min(rect.width(), rect.height());
    return {rect.center().x() - side / 2, rect.center().y() - side / 2, side, side};
}

/// Paints the mark of an activity, which is drawn in a unit square mapped to `rect`, in `colour`.
class MarkPainter {
public:
    MarkPainter(QPainter& painter, const QRectF& rect, const QColor& colour)
        : m_painter(painter), m_rect(rect), m_colour(colour) {}

    void polygon(std::initializer_list<QPointF> points) {
        QPolygonF shape;
        for (const QPointF& p : points)
            shape << at(p);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_colour);
        m_painter.drawPolygon(shape);
    }
    void line(std::initializer_list<QPointF> points) {
        QPolygonF shape;
        for (const QPointF& p : points)
            shape << at(p);
        stroke();
        m_painter.drawPolyline(shape);
    }
    void ring(double radius) {
        stroke();
        m_painter.drawEllipse(at({0.5, 0.5}), radius * m_rect.width(), radius * m_rect.height());
    }
    void disc(QPointF centre, double radius) {
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_colour);
        m_painter.drawEllipse(at(centre), radius * m_rect.width(), radius * m_rect.height());
    }
    // Letters are drawn as shapes, too: otherwise a font would be loaded in every size of a mark for one
    // letter.
    void exclamationMark() {
        polygon({{0.36, 0.02}, {0.64, 0.02}, {0.57, 0.66}, {0.43, 0.66}});
        disc({0.5, 0.87}, 0.13);
    }
    void smallI() {
        disc({0.5, 0.16}, 0.11);
        line({{0.5, 0.44}, {0.5, 0.86}});
    }
    void questionMark() {
        QPainterPath hook(at({0.26, 0.30}));
        hook.cubicTo(at({0.28, -0.02}), at({0.78, 0.00}), at({0.74, 0.32}));
        hook.cubicTo(at({0.72, 0.46}), at({0.50, 0.46}), at({0.50, 0.64}));
        stroke();
        m_painter.drawPath(hook);
        disc({0.5, 0.88}, 0.10);
    }

private:
    [[nodiscard]] QPointF at(QPointF p) const {
        return {m_rect.left() + p.x() * m_rect.width(), m_rect.top() + p.y() * m_rect.height()};
    }
    void stroke() {
        m_painter.setPen(QPen(m_colour, m_rect.width() * 0.14, Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin));
        m_painter.setBrush(Qt::NoBrush);
    }

    QPainter& m_painter;
    QRectF m_rect;
    QColor m_colour;
};

void paintMark(MarkPainter mark, Activity activity) {
    switch (activity) {
        case Activity::Unknown:
            mark.questionMark();
            break;
        case Activity::MaybeOff:
            mark.line({{0.2, 0.8}, {0.8, 0.2}});
            mark.disc({0.8, 0.8}, 0.12);
            break;
        case Activity::MaybeMoving:
            mark.line({{0.3, 0.1}, {0.75, 0.5}, {0.3, 0.9}});
            break;
        case Activity::Restarted:
            mark.exclamationMark();
            break;
        case Activity::Unresponsive:
            for (double x : {0.15, 0.5, 0.85})
                mark.disc({x, 0.5}, 0.12);
            break;
        case Activity::NotAsked:
            for (double x : {0.3, 0.7})
                mark.disc({x, 0.5}, 0.12);
            break;
        case Activity::NoPower:
        case Activity::PowerLost:
            mark.polygon({{0.62, 0.0}, {0.18, 0.58}, {0.45, 0.58}, {0.36, 1.0}, {0.82, 0.40}, {0.54, 0.40}});
            break;
        case Activity::ServoOff:
        case Activity::AmplifierOff:
        case Activity::Ready:
            mark.ring(0.38);
            break;
        case Activity::Tripped:
            mark.line({{0.16, 0.16}, {0.84, 0.84}});
            mark.line({{0.84, 0.16}, {0.16, 0.84}});
            break;
        case Activity::PwmMode:
            mark.line(
                {{0.05, 0.8}, {0.05, 0.2}, {0.4, 0.2}, {0.4, 0.8}, {0.75, 0.8}, {0.75, 0.2}, {0.98, 0.2}});
            break;
        case Activity::Turned:
            mark.ring(0.38);
            mark.line({{0.5, 0.5}, {0.98, 0.02}});
            break;
        case Activity::Limited:
            mark.ring(0.40);
            mark.line({{0.12, 0.5}, {0.88, 0.5}});
            break;
        case Activity::Holding:
            mark.ring(0.40);
            mark.disc({0.5, 0.5}, 0.20);
            break;
        case Activity::Accelerating:
            mark.polygon({{0.06, 0.86}, {0.94, 0.86}, {0.94, 0.12}});
            break;
        case Activity::AtSpeed:
            mark.polygon({{0.02, 0.1}, {0.5, 0.5}, {0.02, 0.9}});
            mark.polygon({{0.5, 0.1}, {0.98, 0.5}, {0.5, 0.9}});
            break;
        case Activity::Decelerating:
            mark.polygon({{0.06, 0.12}, {0.06, 0.86}, {0.94, 0.86}});
            break;
        case Activity::OnPath:
            mark.line({{0.06, 0.86}, {0.34, 0.30}, {0.66, 0.66}, {0.94, 0.12}});
            break;
        case Activity::StoppedByLimit:
            mark.polygon({{0.0, 0.15}, {0.55, 0.5}, {0.0, 0.85}});
            mark.polygon({{0.66, 0.0}, {0.9, 0.0}, {0.9, 1.0}, {0.66, 1.0}});
            break;
        case Activity::EstopActive:
            mark.polygon({{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}});
            break;
        case Activity::Overheated:
            mark.line({{0.5, 0.05}, {0.5, 0.6}});
            mark.disc({0.5, 0.78}, 0.22);
            break;
        case Activity::WentOff:
            mark.ring(0.42);
            mark.line({{0.2, 0.8}, {0.8, 0.2}});
            break;
    }
}

/// Paints the container of a severity. Returns where the mark goes, and in which colour.
std::pair<QRectF, QColor> paintContainer(QPainter& painter, const QRectF& r, Severity severity,
                                         const QPalette& palette) {
    const QColor on = look::onSeverityFill(severity, palette);
    painter.setPen(Qt::NoPen);
    painter.setBrush(look::severityFill(severity, palette));
    const double side = r.width();
    switch (severity) {
        case Severity::Normal:
            return {r.adjusted(side * 0.08, side * 0.08, -side * 0.08, -side * 0.08),
                    palette.color(QPalette::Active, QPalette::WindowText)};
        case Severity::Attention: {
            const QPolygonF triangle{QPointF(r.center().x(), r.top()), r.bottomRight(), r.bottomLeft()};
            painter.drawPolygon(triangle);
            return {QRectF(r.left() + side * 0.29, r.top() + side * 0.46, side * 0.42, side * 0.46), on};
        }
        case Severity::Fault:
            painter.drawRect(r.adjusted(side * 0.03, side * 0.03, -side * 0.03, -side * 0.03));
            return {r.adjusted(side * 0.24, side * 0.24, -side * 0.24, -side * 0.24), on};
    }
    return {r, on};
}

}  // namespace

void paintActivity(QPainter& painter, const QRectF& rect, Activity activity, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto [inner, colour] = paintContainer(painter, square(rect), severityOf(activity), palette);
    paintMark(MarkPainter(painter, inner, colour), activity);
    painter.restore();
}

void paintSeverity(QPainter& painter, const QRectF& rect, Severity severity, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto [inner, colour] = paintContainer(painter, square(rect), severity, palette);
    MarkPainter mark(painter, inner, colour);
    if (severity == Severity::Normal) {
        mark.ring(0.48);
        const double edge = inner.width() * 0.15;
        MarkPainter(painter, inner.adjusted(edge, edge, -edge, -edge), colour).smallI();
    } else {
        mark.exclamationMark();
    }
    painter.restore();
}

void paintBit(QPainter& painter, const QRectF& rect, std::optional<bool> set, const QPalette& palette) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF r = square(rect);
    MarkPainter mark(painter, r, palette.color(QPalette::Active, QPalette::WindowText));
    if (!set.has_value())
        mark.line({{0.25, 0.5}, {0.75, 0.5}});
    else if (*set)
        mark.polygon({{0.12, 0.12}, {0.88, 0.12}, {0.88, 0.88}, {0.12, 0.88}});
    else
        MarkPainter(painter, r, look::mutedText(palette)).ring(0.30);
    painter.restore();
}

void GlyphLabel::display(const Shown& shown) {
    if (std::exchange(m_shown, shown) != shown)
        update();
}

QSize GlyphLabel::sizeHint() const {
    const int side = std::holds_alternative<Bit>(m_shown) ? qRound(fontMetrics().capHeight() * 1.15)
                                                          : qRound(fontMetrics().ascent() * 1.15);
    return {side, side};
}

void GlyphLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (const auto* activity = std::get_if<Activity>(&m_shown))
        paintActivity(painter, rect(), *activity, palette());
    else if (const auto* severity = std::get_if<Severity>(&m_shown))
        paintSeverity(painter, rect(), *severity, palette());
    else if (const auto* bit = std::get_if<Bit>(&m_shown))
        paintBit(painter, rect(), *bit, palette());
}

}  // namespace nmc
