// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QKeySequence>
#include <QPalette>

#include "model/module/modulestate.h"

class QAction;
class QApplication;
class QLabel;
class QWidget;

/// The common look of all widgets of the panel: colours by meaning, and digits that do not jump about.
/// Colours are computed from the present palette, so that light and dark need no switch.
namespace nmc::look {

/// Sets the style, the window icon, the application's name for the desktop, and accessibility. Call it once,
/// before the first widget is made.
void setUp(QApplication& application);

[[nodiscard]] bool isDark(const QPalette& palette);
/// WCAG contrast of two opaque colours, 1..21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);
/// The colour of secondary text: quieter than WindowText, but still 4.5:1 on the window and on fields.
[[nodiscard]] QColor mutedText(const QPalette& palette);
/// The colour of lines in frames and grids.
[[nodiscard]] QColor faintLine(const QPalette& palette);
/// The colours of Okabe and Ito: orange for attention, vermillion for a fault; normal is the text colour.
[[nodiscard]] QColor severityFill(Severity severity, const QPalette& palette);
/// The colour of a mark or text on severityFill().
[[nodiscard]] QColor onSeverityFill(Severity severity, const QPalette& palette);
/// A tint of a severity behind ordinary text; the text keeps 4.5:1.
[[nodiscard]] QColor severityTint(Severity severity, const QPalette& palette);

/// The colours of the curves of a plot, counted from 0; they repeat after kTraceColours.
inline constexpr int kTraceColours = 6;
[[nodiscard]] QColor traceColour(int trace, const QPalette& palette);

/// `base` if its digits are all equally wide, otherwise the system's fixed font at the same size.
[[nodiscard]] QFont tabular(const QFont& base);
/// `base` at `factor` times its size.
[[nodiscard]] QFont scaled(const QFont& base, double factor);
/// A length in device-independent pixels, at the screen's logical resolution.
[[nodiscard]] int millimetres(const QWidget* widget, double mm);
/// The spacing grid: half a line of text.
[[nodiscard]] int gridUnit(const QWidget* widget);

/// Like QLabel::setText(), but costs nothing if the text is unchanged.
void setText(QLabel* label, const QString& text);
/// Like setText(), for a number that changes all the time: the label grows with it but never shrinks, and the
/// layout around it stays as it is.
void setReadout(QLabel* label, const QString& text);
/// `old`: the value is out of date, and is shown struck out and pale.
void setOld(QLabel* label, bool old);
/// Makes a label for muted secondary text that follows the palette.
[[nodiscard]] QLabel* newMutedLabel(const QString& text, QWidget* parent, const QString& objectName = {});

/// Makes an action, for menus and for its key; `meaning` is its tool tip.
[[nodiscard]] QAction* newAction(QObject* parent, const QString& objectName, const QString& text,
                                 const QString& meaning = {}, const QKeySequence& key = {});

/// Keeps the space of the widget while it is hidden, so that nothing moves when it comes or goes.
void keepRoom(QWidget* widget);
/// Shows a window in front of the others, and gives it the keyboard.
void showInFront(QWidget* window);

/// Names a control for tests and for assistive technology in one go.
void name(QWidget* widget, const QString& objectName, const QString& accessibleName);
/// The object name of a widget that a window may have once for each type of module.
[[nodiscard]] QString nameFor(ModuleType type, const QString& objectName);
/// Names a label whose text changes. The text itself is read out as the name; `what` describes it.
void nameText(QLabel* label, const QString& objectName, const QString& what);

/// Enables the control with `meaning` as its tool tip, or disables it with `reason` unless that is empty.
/// Assistive technology gets the same text.
void setPossible(QWidget* control, const QString& reason, const QString& meaning);

}  // namespace nmc::look
