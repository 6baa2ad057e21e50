// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

/// Keys of the settings in which the window stores what it remembers.
namespace nmc::settingskeys {

inline const QString kGeometry = QStringLiteral("window/geometry");
inline const QString kState = QStringLiteral("window/state");
inline const QString kLayout = QStringLiteral("window/layout");
inline const QString kScope = QStringLiteral("scope");
inline const QString kScopePresets = QStringLiteral("scope/presets");
inline const QString kLastPort = QStringLiteral("connection/port");
inline const QString kLastBaud = QStringLiteral("connection/baud");
inline const QString kSimulatorOpen = QStringLiteral("simulator/open");
inline const QString kSafetyRead = QStringLiteral("safety/understood");
inline const QString kColours = QStringLiteral("window/colours");
inline const QString kPrinter = QStringLiteral("print/printer");
inline const QString kSounds = QStringLiteral("sounds");
inline const QString kOperatorMode = QStringLiteral("operator/locked");
inline const QString kOperatorSalt = QStringLiteral("operator/salt");
inline const QString kOperatorPin = QStringLiteral("operator/pin");  ///< hash of the PIN
inline const QString kOperatorRights = QStringLiteral("operator/rights");

}  // namespace nmc::settingskeys
