// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QObject;

namespace nmc {

/// Watches the whole application, for as long as `parent` exists: shortcuts of buttons act at once, no field
/// takes the key of a command, a held key triggers nothing again, and the wheel changes only the value that
/// has the focus. Call it before the first combo box accepts the focus from the wheel.
void installInputFilters(QObject* parent);

}  // namespace nmc
