// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

#include "model/module/modulestate.h"

class QApplication;
class QLabel;
class QWidget;

/// What every widget of the panel has in common to look at: colours by meaning, digits that do not dance.
/// Colours are computed from the palette at hand, so that light and dark need no switch.
namespace nmc::look {

/// Fusion, the window icon, and whose window it is to the desktop; call once, before the first widget is
/// made.
void setUp(QApplication& application);

[[nodiscard]] bool isDark(const QPalette& palette);
/// WCAG contrast of two opaque colours, 1..21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);
/// Secondary text: quieter than WindowText, still 4.5:1 on the window and on fields.
[[nodiscard]] QColor mutedText(const QPalette& palette);
/// A line between things, for frames and grids.
[[nodiscard]] QColor faintLine(const QPalette& palette);
/// Okabe-Ito: normal is the text's own colour, attention orange, fault vermillion.
[[nodiscard]] QColor severityFill(Severity severity, const QPalette& palette);
/// For a mark or words upon severityFill.
[[nodiscard]] QColor onSeverityFill(Severity severity, const QPalette& palette);
/// A tint of a severity behind ordinary text; the text keeps 4.5:1.
[[nodiscard]] QColor severityTint(Severity severity, const QPalette& palette);

/// Of the curves of a plot, from 0 on; they begin anew after kTraceColours.
inline constexpr int kTraceColours = 6;
[[nodiscard]] QColor traceColour(int trace, const QPalette& palette);

/// `base` where its digits are all equally wide, else the system's fixed font at that size.
[[nodiscard]] QFont tabular(const QFont& base);
/// `base` at `factor` times its size.
[[nodiscard]] QFont scaled(const QFont& base, double factor);
/// Device-independent pixels of a length at the screen's logical resolution.
[[nodiscard]] int millimetres(const QWidget* widget, double mm);
/// The spacing grid: half a line of text.
[[nodiscard]] int gridUnit(const QWidget* widget);

/// setText that costs nothing when there is no news.
void setText(QLabel* label, const QString& text);
/// The same of a number that changes all the time: the label grows with it, never shrinks, and what is laid
/// out around it stays as it is.
void setReadout(QLabel* label, const QString& text);
/// Struck out and pale: what it shows was so once, and may not be so now.
void setOld(QLabel* label, bool old);
/// Quiet secondary text that follows the palette.
[[nodiscard]] QLabel* newMutedLabel(const QString& text, QWidget* parent);

/// Nothing around it moves when it comes or goes.
void keepRoom(QWidget* widget);

/// Names a control for tests and for assistive technology in one go.
void name(QWidget* widget, const QString& objectName, const QString& accessibleName);
/// The object name of what there may be one of for each type of module in a window.
[[nodiscard]] QString nameFor(ModuleType type, const QString& objectName);
/// Of a text that changes: its name, as it is read out, is what it says; `what` describes it.
void nameText(QLabel* label, const QString& objectName, const QString& what);

/// Enabled, with `meaning` as tool tip, or disabled with the reason; both for assistive technology as well.
void setPossible(QWidget* control, const QString& reason, const QString& meaning);

}  // namespace nmc::look
