// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace nmc {

class LoopTestsDock;
class Requests;
class ResponseDock;
class Session;

/// Asks where to save the report about the tuning of the selected module, of which no single part of the
/// window knows all; does nothing unless that is a servo. `requests` must outlive the window. GUI thread.
void saveTuningReport(const Session& session, ResponseDock& responses, LoopTestsDock& tests,
                      Requests& requests, QWidget* window);

}  // namespace nmc
