// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QPalette>
#include <QStringList>
#include <functional>
#include <optional>

#include "widgets/common/filedialog.h"

class QPainter;
class QWidget;

namespace nmc {

/// What a widget shows, for use outside the panel, below a caption: dark on white and in letters of one size,
/// whatever palette, font and scale the screen has. GUI thread; valid while the widget exists.
struct Picture {
    QWidget* widget;
    QStringList caption;
    std::function<void(QPainter&)> paint;  ///< paints the widget, which is OnPaper meanwhile
};

/// Device pixels per pixel of a picture.
inline constexpr double kSharpness = 2.0;

/// While it exists, a widget looks as on paper, and has `size` if that is valid. The screen, which is painted
/// later, shows nothing of this.
class OnPaper {
public:
    explicit OnPaper(QWidget& widget, const QSize& size = {});
    ~OnPaper();
    Q_DISABLE_COPY_MOVE(OnPaper)

private:
    QWidget& m_widget;
    QRect m_place;
    std::optional<QPalette> m_palette;  ///< the widget's own; empty: inherited
    std::optional<QFont> m_font;
};

/// As large as the widget, and sharp enough to be printed.
[[nodiscard]] QImage imageOf(const Picture& picture);
[[nodiscard]] QByteArray pngOf(const QImage& image);
/// As vector graphics on a page, laid out for the page.
[[nodiscard]] QByteArray pdfOf(const Picture& picture);
/// The file with this suffix: "png", "svg" for vector graphics, or "pdf". The picture is taken at once.
[[nodiscard]] FileContent fileOf(const Picture& picture, const QString& suffix);

}  // namespace nmc
