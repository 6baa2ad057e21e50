// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/picture.h"

#include <QBuffer>
#include <QFontMetrics>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QWidget>
#include <algorithm>

namespace nmc {

namespace {

constexpr double kSharpness = 2.0;
constexpr double kMargin = 10.0;  ///< mm of a page

[[nodiscard]] QSize sizeOf(const Picture& picture) {
    const QFontMetrics metrics(picture.font);
    const int lines = static_cast<int>(picture.caption.size()) * metrics.lineSpacing();
    return {picture.size.width(), picture.size.height() + lines + metrics.height()};
}

void paint(QPainter& painter, const Picture& picture) {
    const QFontMetrics metrics(picture.font);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRect(QPoint(), sizeOf(picture)), picture.palette.color(QPalette::Base));
    painter.setPen(picture.palette.color(QPalette::Text));
    painter.setFont(picture.font);
    int y = metrics.height() / 4;
    for (const QString& line : picture.caption) {
        painter.drawText(metrics.height() / 2, y + metrics.ascent(), line);
        y += metrics.lineSpacing();
    }
    painter.translate(0, y + metrics.height() / 2.0);
    picture.paint(painter);
}

}  // namespace

Picture pictureOf(const QWidget& widget, const QStringList& caption,
                  const std::function<void(QPainter&)>& paint) {
    return {widget.size(), widget.palette(), widget.font(), widget.logicalDpiX(), caption, paint};
}

QImage imageOf(const Picture& picture) {
    QImage image((sizeOf(picture).toSizeF() * kSharpness).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(kSharpness);
    QPainter painter(&image);
    paint(painter, picture);
    return image;
}

QByteArray pngOf(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray svgOf(const Picture& picture) {
    QByteArray svg;
    QBuffer buffer(&svg);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(sizeOf(picture));
    generator.setViewBox(QRect(QPoint(), sizeOf(picture)));
    generator.setResolution(picture.dpi);
    generator.setTitle(picture.caption.value(0));
    QPainter painter(&generator);
    paint(painter, picture);
    painter.end();
    return svg;
}

QByteArray pdfOf(const Picture& picture) {
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    // That of the screen: its fonts and lines have the size that they have there, and are vectors anyway.
    writer.setResolution(picture.dpi);
    const bool imperial = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    writer.setPageLayout({QPageSize(imperial ? QPageSize::Letter : QPageSize::A4),
                          QPageLayout::Landscape,
                          {kMargin, kMargin, kMargin, kMargin},
                          QPageLayout::Millimeter});
    writer.setTitle(picture.caption.value(0));
    QPainter painter(&writer);
    const QSizeF room = painter.viewport().size();
    const QSizeF size = sizeOf(picture);
    const double scale = std::min(room.width() / size.width(), room.height() / size.height());
    painter.scale(scale, scale);
    paint(painter, picture);
    painter.end();
    return pdf;
}

}  // namespace nmc
