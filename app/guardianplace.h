// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>

#include "link/guardian/guardian.h"

namespace nmc {

/// The folder beside the settings, which also records which motors move.
[[nodiscard]] QString guardFolder(const QSettings& settings);
/// Where the guardian's program is, seen from that of this process, and the file of its report. Creates the
/// folder of the latter.
[[nodiscard]] GuardianPlace guardianPlace(const QSettings& settings);

}  // namespace nmc
