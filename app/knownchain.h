// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>
#include <vector>

#include "bus/types.h"

/// The chain that was there last, port by port, in the settings: what each address was. A start that finds
/// fewer modules knows by it which ones are missing (core/bus/rejoin.h). GUI thread.
namespace nmc {

/// In the order of addressing; empty: nothing is known, or what stands there is none of ours.
[[nodiscard]] std::vector<bus::ModuleInfo> knownChain(const QSettings& settings, const QString& port);
/// The rate it was left at, where it is none of kBaudRows; 0: one of them.
[[nodiscard]] std::uint32_t knownRate(const QSettings& settings, const QString& port);
void rememberRate(QSettings& settings, const QString& port, std::uint32_t baud);
/// In place of the one before.
void rememberChain(QSettings& settings, const QString& port, const std::vector<bus::ModuleInfo>& chain);

}  // namespace nmc
