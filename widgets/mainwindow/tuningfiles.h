// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

namespace nmc {

class LoopTestsDock;
class Requests;
class ResponseDock;
class Session;
struct TuningReport;

/// Saves the report about the tuning of the selected module, of which no single part of the window knows all.
/// GUI thread.
class TuningFiles : public QObject {
    Q_OBJECT

public:
    /// Everything must outlive it.
    TuningFiles(const Session& session, ResponseDock& responses, LoopTestsDock& tests, Requests& requests,
                QWidget* window);

private:
    [[nodiscard]] std::optional<TuningReport> report() const;
    void chooseReportFile();

    const Session& m_session;
    ResponseDock& m_responses;
    LoopTestsDock& m_tests;
    Requests& m_requests;
    QWidget* m_window;
};

}  // namespace nmc
