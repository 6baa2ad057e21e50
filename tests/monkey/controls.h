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

/// What can be seen and reached of the program at this moment, whatever it is made of.
namespace nmc::monkey {

/// Somewhere on the screen to press, and how to call it.
struct Spot {
    QPointer<QWidget> window;
    QPoint at;  ///< on the screen
    QString name;
};

/// All that can be seen, in an order that is the same each time.
[[nodiscard]] QWidgetList windows();
/// Buttons, fields, tabs, rows, cells, menu entries: all that is enabled, and not covered. In a popup when
/// one is open, since it has the pointer to itself.
[[nodiscard]] QList<Spot> spots();
/// All shortcuts and mnemonics of controls that can be used now.
[[nodiscard]] QList<QKeySequence> shortcuts();
/// The motors that a control sets going: none, the selected one, the one of its row, or all.
struct Motors {
    bool any = false;
    bool all = false;
    std::optional<ModuleIndex> module{};  ///< where it is not the selected one

    friend bool operator==(const Motors&, const Motors&) = default;
};
/// What pressing that does, or what it is in.
[[nodiscard]] Motors startedBy(const QWidget* widget);
/// What a key does whose control can be used.
[[nodiscard]] Motors startedBy(const QKeySequence& keys);
/// Enter does in it what a button does.
[[nodiscard]] Motors startedByEnter(const QWidget* widget);
/// What files are chosen in; the way out of it leads to other people's files.
[[nodiscard]] bool inFileDialog(const QWidget* widget);

}  // namespace nmc::monkey
