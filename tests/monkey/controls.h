// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QPoint>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <optional>

#include "base/strong.h"

/// What can be seen and reached of the program at this moment, whatever it consists of.
namespace nmc::monkey {

/// A place on the screen that can be pressed, and its name.
struct Spot {
    QPointer<QWidget> window;
    QPoint at;  ///< on the screen
    QString name;
};

/// All that are visible, in an order that is the same each time.
[[nodiscard]] QWidgetList windows();
/// Buttons, fields, tabs, rows, cells, menu entries: everything that is enabled and not covered. If a popup
/// is open, only those in it, since it grabs the pointer.
[[nodiscard]] QList<Spot> spots();
/// All shortcuts and mnemonics of controls that can be used now.
[[nodiscard]] QList<QKeySequence> shortcuts();
/// The motors that a control sets in motion: none, the selected one, the one of its row, or all.
struct Motors {
    bool any = false;
    bool all = false;
    std::optional<ModuleIndex> module{};  ///< if it is not the selected one

    friend bool operator==(const Motors&, const Motors&) = default;
};
/// The motors that are started by pressing the widget, or by what it is part of.
[[nodiscard]] Motors startedBy(const QWidget* widget);
/// The motors that are started by these keys, if their control can be used.
[[nodiscard]] Motors startedBy(const QKeySequence& keys);
/// The motors that are started by Enter in the widget.
[[nodiscard]] Motors startedByEnter(const QWidget* widget);
/// True in a dialog in which files are chosen, from which other people's files could be reached.
[[nodiscard]] bool inFileDialog(const QWidget* widget);

}  // namespace nmc::monkey
