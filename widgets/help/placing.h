// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

class QDialog;

namespace nmc {

/// Sizes a dialog that is about to be shown and puts it below the top of its main window, which has STOP ALL
/// in it: what is read for a while covers nothing that may be needed at once.
void placeBelowTop(QDialog& dialog, QSize wanted);

}  // namespace nmc
