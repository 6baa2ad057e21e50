// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopepicture.h"

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>

#include "widgets/common/look.h"
#include "widgets/scope/scopestrips.h"

namespace nmc {

namespace {

constexpr double kSharpness = 2.0;  ///< pixels of a picture for one of the screen: it may be printed

constexpr double kMargin = 10.0;  ///< mm of a page

QSize sizeOf(const ScopeStrips& strips, const QStringList& caption) {
    const int unit = look::gridUnit(&strips);
    return {strips.width(),
            strips.height() + static_cast<int>(caption.size()) * strips.fontMetrics().lineSpacing() + unit};
}

void paint(QPainter& painter, ScopeStrips& strips, const QStringList& caption) {
    const QPalette& palette = strips.palette();
    painter.fillRect(QRect(QPoint(), sizeOf(strips, caption)), palette.color(QPalette::Base));
    painter.setPen(palette.color(QPalette::Text));
    painter.setFont(strips.font());
    const int unit = look::gridUnit(&strips);
    int y = unit / 2;
    for (const QString& line : caption) {
        painter.drawText(unit, y + strips.fontMetrics().ascent(), line);
        y += strips.fontMetrics().lineSpacing();
    }
    painter.translate(0, y + unit / 2);
    strips.renderTo(painter);
}

}  // namespace

QImage scopeImage(ScopeStrips& strips, const QStringList& caption) {
    QImage image((sizeOf(strips, caption).toSizeF() * kSharpness).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(kSharpness);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter, strips, caption);
    return image;
}

QByteArray scopeSvg(ScopeStrips& strips, const QStringList& caption) {
    QByteArray svg;
    QBuffer buffer(&svg);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(sizeOf(strips, caption));
    generator.setViewBox(QRect(QPoint(), sizeOf(strips, caption)));
    generator.setResolution(strips.logicalDpiX());
    generator.setTitle(caption.value(0));
    QPainter painter(&generator);
    paint(painter, strips, caption);
    painter.end();
    return svg;
}

QByteArray scopePdf(ScopeStrips& strips, const QStringList& caption) {
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    // That of the screen: its fonts and lines have the size that they have there, and are vectors anyway.
    writer.setResolution(strips.logicalDpiX());
    const QPageSize usual(strips.locale().measurementSystem() == QLocale::ImperialUSSystem ? QPageSize::Letter
                                                                                           : QPageSize::A4);
    writer.setPageLayout(
        {usual, QPageLayout::Landscape, {kMargin, kMargin, kMargin, kMargin}, QPageLayout::Millimeter});
    writer.setTitle(caption.value(0));
    QPainter painter(&writer);
    const QSizeF room = painter.viewport().size();
    const QSizeF size = sizeOf(strips, caption);
    const double scale = std::min(room.width() / size.width(), room.height() / size.height());
    painter.scale(scale, scale);
    paint(painter, strips, caption);
    painter.end();
    return pdf;
}

}  // namespace nmc
