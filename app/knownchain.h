// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <QString>
#include <vector>

#include "bus/types.h"

/// The last chain at each port, with the identity at each address, stored in the settings. From it, a start
/// that finds fewer modules can determine which ones are missing (core/bus/rejoin.h). GUI thread.
namespace nmc {

/// In addressing order; empty: nothing is stored, or the entry is invalid.
[[nodiscard]] std::vector<bus::ModuleInfo> knownChain(const QSettings& settings, const QString& port);
/// The last rate of the chain if it is not in kBaudRows; otherwise 0.
[[nodiscard]] std::uint32_t knownRate(const QSettings& settings, const QString& port);
void rememberRate(QSettings& settings, const QString& port, std::uint32_t baud);
/// Replaces the previous entry.
void rememberChain(QSettings& settings, const QString& port, const std::vector<bus::ModuleInfo>& chain);

}  // namespace nmc
