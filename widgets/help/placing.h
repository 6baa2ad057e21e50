// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

class QDialog;

namespace nmc {

/// Sizes a dialog that is about to be shown and places it below the top of its main window, where STOP ALL
/// is: a dialog that is read for a while must not cover what may be needed at once.
void placeBelowTop(QDialog& dialog, QSize wanted);

}  // namespace nmc
