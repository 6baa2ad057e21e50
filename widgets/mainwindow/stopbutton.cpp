// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/stopbutton.h"

#include <QPainter>

#include "widgets/common/icons.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr double kMinHeight = 15.0;  // mm
}  // namespace

StopButton::StopButton(QWidget* parent) : QAbstractButton(parent) {
    setText(tr("STOP ALL  Esc"));
    look::name(this, u"stopAllButton"_s, tr("STOP ALL  Esc: stop all motors"));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void StopButton::showReach(const QString& reach) {
    if (m_reach == reach && !toolTip().isEmpty())
        return;
    m_reach = reach;
    setToolTip(reach.isEmpty()
                   ? tr("Stops every motor. Unavailable: no port is open.")
                   : tr("Stops every motor on this line at once; Esc does the same from anywhere. It %1.\n"
                        "It works only while the link works: fit a hardware stop as well.")
                         .arg(reach));
    setAccessibleDescription(toolTip());
    update();
}

QFont StopButton::largeFont() const {
    QFont font = look::scaled(this->font(), 1.5);
    font.setBold(true);
    return font;
}

int StopButton::symbolSide() const {
    return look::millimetres(this, kMinHeight) * 6 / 10;
}

QSize StopButton::sizeHint() const {
    const QFontMetrics large(largeFont());
    const int unit = look::gridUnit(this);
    const int height =
        qMax(look::millimetres(this, kMinHeight), large.height() + fontMetrics().height() + unit * 2);
    const int keycap = fontMetrics().horizontalAdvance(tr("Esc")) + unit * 2;
    const int words = qMax(large.horizontalAdvance(Common::tr("STOP ALL")) + unit * 2 + keycap,
                           fontMetrics().horizontalAdvance(Common::tr("goes to all modules")));
    return {unit * 3 + symbolSide() + unit + words + unit, height};
}

void StopButton::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool enabled = isEnabled();
    const bool dark = look::isDark(palette());
    const QRectF r = QRectF(rect()).adjusted(1, 1, -1, -1);
    const int unit = look::gridUnit(this);
    const QColor white = enabled ? QColor(Qt::white)
                         : dark  ? QColor(0x8A, 0x8A, 0x8A)
                                 : QColor(0xF0, 0xF0, 0xF0);
    const QColor black = !enabled       ? (dark ? QColor(0x2A, 0x2A, 0x2A) : QColor(0x75, 0x75, 0x75))
                         : isDown()     ? QColor(0x44, 0x44, 0x44)
                         : underMouse() ? QColor(0x22, 0x22, 0x22)
                                        : QColor(Qt::black);
    // On a dark window, the black button needs an edge to be visible.
    painter.setPen(dark ? QPen(enabled ? QColor(0xB0, 0xB0, 0xB0) : QColor(0x55, 0x55, 0x55), 1.5)
                        : QPen(Qt::NoPen));
    painter.setBrush(black);
    painter.drawRoundedRect(r, unit / 2.0, unit / 2.0);

    const int side = symbolSide();
    painter.drawPixmap(QPointF(r.left() + unit * 1.5, r.center().y() - side / 2.0),
                       icons::pixmap(u"octagon-stop"_s, white, side, devicePixelRatioF()));

    const QFont large = largeFont();
    const QFontMetricsF largeMetrics(large);
    const QFontMetricsF smallMetrics(font());
    const double left = r.left() + unit * 2.5 + side;
    const double total =
        m_reach.isEmpty() ? largeMetrics.height() : largeMetrics.height() + smallMetrics.height();
    const double top = r.center().y() - total / 2;
    painter.setPen(white);
    painter.setFont(large);
    painter.drawText(QPointF(left, top + largeMetrics.ascent()), Common::tr("STOP ALL"));

    const QString key = tr("Esc");
    const double keyWidth = smallMetrics.horizontalAdvance(key) + unit;
    const QRectF cap(r.right() - unit - keyWidth,
                     top + (largeMetrics.height() - smallMetrics.height()) / 2 - 1, keyWidth,
                     smallMetrics.height() + 2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(white, 1));
    painter.drawRoundedRect(cap, 3, 3);
    painter.setFont(font());
    painter.drawText(cap, Qt::AlignCenter, key);
    if (!m_reach.isEmpty())
        painter.drawText(QPointF(left, top + largeMetrics.height() + smallMetrics.ascent()), m_reach);
    if (hasFocus()) {
        painter.setPen(QPen(white, 1, Qt::DotLine));
        painter.drawRoundedRect(r.adjusted(3, 3, -3, -3), unit / 2.0 - 2, unit / 2.0 - 2);
    }
}

}  // namespace nmc
