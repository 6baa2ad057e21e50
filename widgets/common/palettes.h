// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

class QStyle;
class QWidget;

/// The palettes that the user can choose from. Everything else of the look is computed from the one in force
/// (common/look.h), so that another can come at any time.
namespace nmc::look {

enum class Colours : quint8 {
    System,  ///< the desktop's
    Light,
    Dark,
    HighContrast,  ///< white upon black, selections black upon yellow
};

/// Of all but System, which has none of its own: an empty one.
[[nodiscard]] QPalette paletteOf(Colours colours);
/// For the whole program, at any time. GUI thread.
void useColours(Colours colours);

/// Text and window differ as much as colours can.
[[nodiscard]] bool isHighContrast(const QPalette& palette);
/// Behind the text of a selected row that keeps its own colours.
[[nodiscard]] QColor selectionTint(const QPalette& palette);
/// What stands in empty fields of this window is as readable as other secondary text; and where a desktop's
/// palette has text upon its highlight that can't be read well, it is black or white. Again with each change
/// of its palette.
void adoptReadable(QWidget* window);

/// Fusion, with frames that have 3:1 upon whatever palette there is.
[[nodiscard]] QStyle* newStyle();

}  // namespace nmc::look
