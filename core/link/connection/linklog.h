// SPDX-License-Identifier: MIT
#pragma once

#include <QLoggingCategory>
#include <string>

#include "link/connection/busrequest.h"
#include "link/connection/workerevent.h"

/// Logging of the link for fault-finding: off by default, and then as cheap as a comparison.
/// QT_LOGGING_RULES="nmc.link*=true" switches it on. The lines are English, untranslated, and have no fixed
/// format.
namespace nmc {

Q_DECLARE_LOGGING_CATEGORY(linkLog)     ///< nmc.link: events of the bus thread except samples; GUI thread
Q_DECLARE_LOGGING_CATEGORY(portLog)     ///< nmc.link.port: events of a serial port; bus thread
Q_DECLARE_LOGGING_CATEGORY(requestLog)  ///< nmc.link.requests: requests to the bus thread; GUI thread

/// Formats one line; the line is empty for events that come with every exchange.
[[nodiscard]] std::string logLine(const WorkerEvent& event);
[[nodiscard]] std::string logLine(const BusRequest& request);

}  // namespace nmc
