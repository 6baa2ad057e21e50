// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace nmc::icons {

/// The icon of the program.
[[nodiscard]] QIcon window();
/// A line icon of resources/icons, drawn in the text colour of the application's palette at the time it is
/// painted.
[[nodiscard]] QIcon tinted(const QString& name);
/// A line icon in a given colour, for a place that has a colour of its own.
[[nodiscard]] QPixmap pixmap(const QString& name, const QColor& colour, int size, qreal devicePixelRatio);

}  // namespace nmc::icons
