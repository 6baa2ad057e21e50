// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QPalette>
#include <QStringList>
#include <functional>
#include <optional>

class QPainter;
class QWidget;

namespace nmc {

/// What a widget shows, to be taken out of the panel below lines that say what it is: dark upon white and in
/// letters of one size, whatever palette, font and scale the screen has. GUI thread, while the widget lives.
struct Picture {
    QWidget* widget;
    QStringList caption;
    std::function<void(QPainter&)> paint;  ///< of the widget, which is OnPaper meanwhile
};

/// Device pixels in a pixel of a picture.
inline constexpr double kSharpness = 2.0;

/// While it lives, a widget has the look of paper, and `size` where that is valid. Nothing of it is seen on
/// the screen, which is painted later.
class OnPaper {
public:
    explicit OnPaper(QWidget& widget, const QSize& size = {});
    ~OnPaper();
    Q_DISABLE_COPY_MOVE(OnPaper)

private:
    QWidget& m_widget;
    QRect m_place;
    std::optional<QPalette> m_palette;  ///< that the widget had of its own
    std::optional<QFont> m_font;
};

/// As large as the widget, and sharp enough to be printed.
[[nodiscard]] QImage imageOf(const Picture& picture);
[[nodiscard]] QByteArray pngOf(const QImage& image);
/// In vectors.
[[nodiscard]] QByteArray svgOf(const Picture& picture);
/// On a page, laid out for it, in vectors as well.
[[nodiscard]] QByteArray pdfOf(const Picture& picture);

}  // namespace nmc
