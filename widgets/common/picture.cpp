// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/picture.h"

#include <QApplication>
#include <QBuffer>
#include <QFontMetrics>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QWidget>

#include "widgets/common/palettes.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr double kPageMargin = 10.0;  ///< mm
/// A pixel of a picture is a CSS pixel: 1/96 inch on paper.
constexpr int kResolution = 96;
constexpr int kLetters = 12;  ///< font size in pixels: 9 pt on paper

[[nodiscard]] QFont paperFont() {
    QFont font = QApplication::font();
    font.setPixelSize(kLetters);
    return font;
}

[[nodiscard]] int captionHeight(const Picture& picture) {
    const QFontMetrics metrics(paperFont());
    return static_cast<int>(picture.caption.size()) * metrics.lineSpacing() + metrics.height();
}

[[nodiscard]] QSize sizeOf(const Picture& picture) {
    return picture.widget->size() + QSize(0, captionHeight(picture));
}

/// `size`: of the part that is painted below the caption.
void paint(QPainter& painter, const Picture& picture, const QSize& size) {
    const OnPaper paper(*picture.widget, size);
    const QPalette& palette = picture.widget->palette();
    const QFontMetrics metrics(paperFont());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRect(QPoint(), sizeOf(picture)), palette.color(QPalette::Base));
    painter.setPen(palette.color(QPalette::Text));
    painter.setFont(paperFont());
    int y = metrics.height() / 4;
    for (const QString& line : picture.caption) {
        painter.drawText(metrics.height() / 2, y + metrics.ascent(), line);
        y += metrics.lineSpacing();
    }
    painter.translate(0, y + metrics.height() / 2.0);
    picture.paint(painter);
}

/// As vector graphics.
[[nodiscard]] QByteArray svgOf(const Picture& picture) {
    QByteArray svg;
    QBuffer buffer(&svg);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(sizeOf(picture));
    generator.setViewBox(QRect(QPoint(), sizeOf(picture)));
    generator.setResolution(kResolution);
    QPainter painter(&generator);
    paint(painter, picture, picture.widget->size());
    painter.end();
    return svg;
}

}  // namespace

OnPaper::OnPaper(QWidget& widget, const QSize& size) : m_widget(widget), m_place(widget.geometry()) {
    if (widget.testAttribute(Qt::WA_SetPalette))
        m_palette = widget.palette();
    if (widget.testAttribute(Qt::WA_SetFont))
        m_font = widget.font();
    widget.setPalette(look::paletteOf(look::Colours::Light));
    widget.setFont(paperFont());
    if (size.isValid())
        widget.resize(size);
}

OnPaper::~OnPaper() {
    m_widget.setGeometry(m_place);
    // What was inherited from the window must be inherited again, so that it follows changes there.
    m_widget.setPalette(m_palette.value_or(QPalette()));
    m_widget.setFont(m_font.value_or(QFont()));
}

QImage imageOf(const Picture& picture) {
    QImage image((sizeOf(picture).toSizeF() * kSharpness).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(kSharpness);
    QPainter painter(&image);
    paint(painter, picture, picture.widget->size());
    return image;
}

QByteArray pngOf(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray pdfOf(const Picture& picture) {
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    const bool imperial = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    writer.setPageLayout({QPageSize(imperial ? QPageSize::Letter : QPageSize::A4),
                          QPageLayout::Landscape,
                          {kPageMargin, kPageMargin, kPageMargin, kPageMargin},
                          QPageLayout::Millimeter});
    writer.setTitle(picture.caption.value(0));
    QPainter painter(&writer);
    paint(painter, picture, painter.viewport().size() - QSize(0, captionHeight(picture)));
    painter.end();
    return pdf;
}

FileContent fileOf(const Picture& picture, const QString& suffix) {
    if (suffix == u"png"_s)
        return [image = imageOf(picture)] { return pngOf(image).toStdString(); };
    return [bytes = suffix == u"svg"_s ? svgOf(picture) : pdfOf(picture)] { return bytes.toStdString(); };
}

}  // namespace nmc
