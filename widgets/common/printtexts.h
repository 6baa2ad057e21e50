// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/message.h"

/// What the table of texts has to say of printing.
namespace nmc::texts {

[[nodiscard]] QString lookingForPrinters();
/// There is none.
[[nodiscard]] QString noPrinter();
[[nodiscard]] Message sentToPrinter(const QString& printer);
/// `command`: what hands pages to the printer; it is not installed.
[[nodiscard]] Message noPrinting(const QString& command);
/// `details`: what it said.
[[nodiscard]] Message notPrinted(const QString& details);

}  // namespace nmc::texts
