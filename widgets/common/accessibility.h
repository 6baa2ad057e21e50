// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

/// What assistive technology is told besides names, descriptions and the states that Qt tells by itself.
namespace nmc::accessibility {

/// The banner is an alert to it, what setBusy() was called for is busy, and a scroll area survives it; once
/// for each program.
void setUp();

/// `words` are read out now, wherever the focus is: they become the region's name, and an alert says that
/// there is one. Qt 6.4 has no announcement of its own, and tells the desktop of the name only.
void announce(QWidget& region, const QString& words);

/// Waits for something: a module's answer, a chain that is being looked for. Of a panel, not of a control,
/// which is disabled with a reason.
void setBusy(QWidget& panel, bool busy);

}  // namespace nmc::accessibility
