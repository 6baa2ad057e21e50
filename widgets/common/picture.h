// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QPalette>
#include <QStringList>
#include <functional>

class QPainter;
class QWidget;

namespace nmc {

/// Something that paints itself, to be taken out of the panel below lines that say what it is: in the colours
/// and at the size of the screen.
struct Picture {
    QSize size;  ///< of what is painted
    QPalette palette;
    QFont font;
    int dpi = 96;  ///< of the screen
    QStringList caption;
    std::function<void(QPainter&)> paint;
};
/// Of a widget that paints itself by `paint`.
[[nodiscard]] Picture pictureOf(const QWidget& widget, const QStringList& caption,
                                const std::function<void(QPainter&)>& paint);

/// Twice as sharp as the screen: it may be printed.
[[nodiscard]] QImage imageOf(const Picture& picture);
[[nodiscard]] QByteArray pngOf(const QImage& image);
/// In vectors.
[[nodiscard]] QByteArray svgOf(const Picture& picture);
/// On a page, in vectors as well.
[[nodiscard]] QByteArray pdfOf(const Picture& picture);

}  // namespace nmc
