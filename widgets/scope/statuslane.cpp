// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/statuslane.h"

#include <QPainter>
#include <utility>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Bits of a PIC-SERVO, in the word of both bytes. pos_error is set all the time while the servo is off, and
/// means nothing then (DS-V 5.2, Clear Sticky Bits).
constexpr unsigned kPosError = 0x10;
constexpr unsigned kServoOn = 0x04U << 8U;
}  // namespace

StatusLane::StatusLane(QWidget* parent) : QWidget(parent) {
    look::name(this, u"scopeStatusLane"_s, tr("Status bits over time"));
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_geometry.bottom = 0;
    m_geometry.top = 1;
}

void StatusLane::setBits(const ScopeModule& module, std::vector<ScopeBit> bits) {
    QStringList names;
    for (const ScopeBit& bit : bits)
        names << texts::bitName(bit, module);
    if (m_type == module.identity.type && m_bits == bits && m_names == names)
        return;
    m_type = module.identity.type;
    m_names = names;
    m_bits = std::move(bits);
    updateGeometry();
    update();
}

QFont StatusLane::ownFont() const {
    return look::scaled(font(), 0.85);
}

QFontMetrics StatusLane::ownMetrics() const {
    return QFontMetrics(ownFont());
}

int StatusLane::rowHeight() const {
    return ownMetrics().height();
}

int StatusLane::labelWidth() const {
    const QFontMetrics metrics = ownMetrics();
    int width = 0;
    for (const QString& name : m_names)
        width = qMax(width, metrics.horizontalAdvance(name));
    return width + metrics.height() / 2;
}

QSize StatusLane::sizeHint() const {
    return {rowHeight() * 20, rowHeight() * static_cast<int>(m_bits.size())};
}

void StatusLane::setArea(double left, double right) {
    m_geometry.area = QRectF(left, 0, right - left, height());
}

void StatusLane::showFrame(const ScopePlot::View& view, const ModuleHistory* history) {
    m_geometry.left = view.left;
    m_geometry.right = view.right;
    m_pieces.clear();
    if (history != nullptr && !m_geometry.area.isEmpty()) {
        const Duration widest =
            fromSeconds((view.right - view.left) / (m_geometry.area.width() * view.sharpness));
        history->visit(
            view.zero + fromSeconds(view.left), view.zero + fromSeconds(view.right), widest,
            [&](const ScopeSpan& span) {
                m_pieces.push_back({toSeconds(span.first - view.zero), toSeconds(span.last - view.zero),
                                    span.statusAll | unsigned{span.auxAll} << 8U,
                                    span.statusAny | unsigned{span.auxAny} << 8U,
                                    !span.gapBefore && !m_pieces.empty()});
            });
    }
    update();
}

void StatusLane::showCursors(const std::optional<CursorTimes>& cursors) {
    if (std::exchange(m_cursors, cursors) != cursors)
        update();
}

void StatusLane::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    renderTo(painter);
}

void StatusLane::renderTo(QPainter& painter) {
    painter.save();
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setFont(ownFont());
    const int rowHigh = rowHeight();
    for (std::size_t i = 0; i < m_bits.size(); ++i) {
        const QRectF row(m_geometry.area.left(), rowHigh * static_cast<double>(i), m_geometry.area.width(),
                         rowHigh);
        painter.setClipping(false);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(0, row.top(), row.left() - rowHigh / 3.0, row.height()),
                         Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                         m_names[static_cast<qsizetype>(i)]);
        painter.setClipRect(row);
        paintBit(painter, m_bits[i], row);
    }
    if (m_cursors && !m_geometry.empty()) {
        painter.setClipRect(m_geometry.area);
        painter.setPen(palette().color(QPalette::Text));
        for (const double seconds : *m_cursors)
            painter.drawLine(QLineF(m_geometry.x(seconds), 0, m_geometry.x(seconds), height()));
    }
    painter.restore();
}

void StatusLane::paintBit(QPainter& painter, const ScopeBit& bit, const QRectF& row) const {
    const unsigned mask = 1U << bit.number();
    const double high = row.top() + 1.5;
    const double low = row.bottom() - 1.5;
    const bool needsServo = m_type == ModuleType::Servo && mask == kPosError;
    const unsigned watched = needsServo ? mask | kServoOn : mask;
    const auto level = [&](unsigned bits) { return (bits & mask) != 0 ? high : low; };
    for (std::size_t begin = 0, end = 0; begin < m_pieces.size(); begin = end) {
        // Continues as long as the bit does not change.
        const Piece& first = m_pieces[begin];
        end = begin + 1;
        while (end < m_pieces.size() && m_pieces[end].joined &&
               ((m_pieces[end].all ^ first.all) & watched) == 0 &&
               ((m_pieces[end].any ^ first.any) & watched) == 0)
            ++end;
        const bool goesOn = end < m_pieces.size() && m_pieces[end].joined;
        // An SVG file has no clipping.
        const double left = std::max(m_geometry.x(first.left), row.left());
        const double right =
            std::min(std::max(m_geometry.x(goesOn ? m_pieces[end].left : m_pieces[end - 1].right), left + 1),
                     row.right());
        if (right <= left)
            continue;
        const bool means = !needsServo || (first.any & kServoOn) != 0;
        const QColor line = means ? look::traceColour(0, palette()) : look::mutedText(palette());
        QColor fill = line;
        fill.setAlpha(60);
        painter.setPen(line);
        const bool both = ((first.all ^ first.any) & mask) != 0;
        if (both || level(first.all) == high)
            painter.fillRect(QRectF(QPointF(left, high), QPointF(right, low)), both ? line : fill);
        if (!both)
            painter.drawLine(QLineF(left, level(first.all), right, level(first.all)));
        if (first.joined && !both && left > row.left())
            painter.drawLine(QLineF(left, high, left, low));
    }
}

}  // namespace nmc
