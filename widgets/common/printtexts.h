// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/message.h"

/// The part of the table of texts about printing.
namespace nmc::texts {

[[nodiscard]] QString lookingForPrinters();
[[nodiscard]] QString noPrinter();
[[nodiscard]] Message sentToPrinter(const QString& printer);
/// `command`: the program that passes pages to the printer; it is not installed.
[[nodiscard]] Message noPrinting(const QString& command);
/// `details`: the output of the print system.
[[nodiscard]] Message notPrinted(const QString& details);

}  // namespace nmc::texts
