// SPDX-License-Identifier: MIT
#pragma once

#include <QLoggingCategory>
#include <string>

#include "bus/types.h"
#include "link/connection/workerevent.h"

/// What the link does, for whoever looks for a fault: off by default, and then as cheap as a comparison.
/// QT_LOGGING_RULES="nmc.link*=true" switches it on. English, untranslated, in no fixed form.
namespace nmc {

Q_DECLARE_LOGGING_CATEGORY(linkLog)     ///< nmc.link: what the bus thread tells, but for samples; GUI thread
Q_DECLARE_LOGGING_CATEGORY(portLog)     ///< nmc.link.port: what happens to a serial port; bus thread
Q_DECLARE_LOGGING_CATEGORY(requestLog)  ///< nmc.link.requests: what is asked of the bus thread; GUI thread

/// One line; empty for what comes with every exchange.
[[nodiscard]] std::string logLine(const WorkerEvent& event);
[[nodiscard]] std::string logLine(const bus::Operation& operation);
[[nodiscard]] std::string logLine(const bus::GroupOperation& operation);

}  // namespace nmc
