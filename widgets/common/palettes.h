// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

class QStyle;
class QWidget;

/// The palettes that the user can choose from. The rest of the look is computed from the present palette
/// (common/look.h), so the palette can change at any time.
namespace nmc::look {

enum class Colours : quint8 {
    System,  ///< the desktop's
    Light,
    Dark,
    HighContrast,  ///< white on black, selections black on yellow
};

/// Empty for System, which has no palette of its own.
[[nodiscard]] QPalette paletteOf(Colours colours);
/// Applies to the whole program, at any time. GUI thread.
void useColours(Colours colours);

/// A colour between two others: `shareOfB` of the second, from 0 to 1.
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, float shareOfB);
/// True if text and window contrast almost as much as colours can.
[[nodiscard]] bool isHighContrast(const QPalette& palette);
/// The background of a selected row whose text keeps its own colours.
[[nodiscard]] QColor selectionTint(const QPalette& palette);
/// Makes the placeholder text in this window as readable as other secondary text, and makes selected text
/// black or white if the desktop's palette gives it too little contrast. Call it again after each change of
/// the window's palette.
void adoptReadable(QWidget* window);

/// Fusion, with frames that have a contrast of 3:1 in every palette, and labels and tool tips without markup.
[[nodiscard]] QStyle* newStyle();

}  // namespace nmc::look
