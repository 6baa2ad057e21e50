// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/module/linkstate.h"
#include "model/module/modulestate.h"

/// All short words of the panel in one place: states, reasons, names, numbers.
namespace nmc::texts {

/// "Module 1", or "Module 3 "Z axis"" if the user has given it a name. Users count from 1.
[[nodiscard]] QString moduleName(ModuleIndex module);
/// "1", "3 "Z axis"": for sentences that say "module" themselves.
[[nodiscard]] QString moduleNumber(ModuleIndex module);
/// Sets the names of the modules for all texts from now on, like QLocale's default for all numbers. GUI
/// thread.
void setModuleNames(const QStringList& names);
/// "PIC-SERVO v4", "PIC-STEP v1", "type 7 v2".
[[nodiscard]] QString moduleType(const ModuleIdentity& identity);
/// "Holding", "Servo off", "Position error"...
[[nodiscard]] QString activity(Activity activity);
/// What the state means for the motor, in a sentence or two.
[[nodiscard]] QString activityMeaning(Activity activity, ModuleType type = ModuleType::Servo);
/// Why a request is not possible now.
[[nodiscard]] QString refusal(Refusal refusal);
/// Why the settings of its axis cannot be edited; empty if they can.
[[nodiscard]] QString whyLocked(const ModuleState& module);
[[nodiscard]] QString severity(Severity severity);
[[nodiscard]] QString stage(bus::ConnectStage stage);
/// The link in the status bar: "Connected to /dev/ttyUSB0 at 115 200 Bd, 5 modules".
[[nodiscard]] QString link(const LinkState& state);
/// "/dev/ttyUSB0", "Simulator", "Simulator (servo,servo@1)".
[[nodiscard]] QString portName(const QString& port);

/// The number with its digits in groups of three, separated by no-break spaces: 115 200.
[[nodiscard]] QString grouped(qint64 value);
/// A baud rate in running text, with plain spaces (interface.md).
[[nodiscard]] QString rate(quint32 baud);
/// A number with exactly `decimals` decimals, grouped, with the locale's decimal mark and a true minus sign,
/// but none before a 0.
[[nodiscard]] QString fixed(double value, int decimals);
/// A readout with `significant` significant digits, at most six of them decimals, as fixed() without its last
/// zeros.
[[nodiscard]] QString readout(double value, int significant = 4);
[[nodiscard]] QString countOfModules(int count);
/// "a, b and c"
[[nodiscard]] QString listOf(const QStringList& names);
/// "3, 4 and 5"
[[nodiscard]] QString listOfModules(const std::vector<ModuleIndex>& modules);

// ---- units; no number is shown without one ----
[[nodiscard]] QString unitCounts();
[[nodiscard]] QString unitSteps();
[[nodiscard]] QString unitVelocity();

}  // namespace nmc::texts
