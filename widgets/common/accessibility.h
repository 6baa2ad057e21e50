// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

/// What is reported to assistive technology besides names, descriptions and the states that Qt reports by
/// itself.
namespace nmc::accessibility {

/// Makes the banner an alert, makes setBusy() work, and avoids a crash of Qt's scroll areas. Call it once per
/// program.
void setUp();

/// Has `words` read out now, wherever the focus is: they become the region's name, and an alert draws
/// attention to it. Qt 6.4 has no announcement of its own, and passes only the name to the desktop.
void announce(QWidget& region, const QString& words);

/// Reports whether a panel waits for something: a module's answer, or a chain that is being searched for. For
/// panels only; a control is disabled with a reason instead.
void setBusy(QWidget& panel, bool busy);

}  // namespace nmc::accessibility
