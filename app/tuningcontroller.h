// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "link/files/backgroundjob.h"
#include "widgets/response/modelbox.h"

namespace nmc {

class MainWindow;
class ResponseDock;

/// Identifies motors and suggests gains in background threads: identification takes some tenths of a second,
/// and a suggestion up to as long with every move of a slider. GUI thread.
class TuningController : public QObject {
    Q_OBJECT

public:
    explicit TuningController(MainWindow& window);

private:
    struct Search {
        ModuleIndex module;
        std::vector<ResponseRecord> runs;
        FoundMotor found = tl::unexpected(IdentifyFailure::TooFewSamples);
    };
    struct Advice {
        SuggestionTask task;
        Suggestion suggestion;
    };

    void identify(ModuleIndex module, const std::vector<ResponseRecord>& runs);
    void suggest(const SuggestionTask& task);
    void suggested();

    ResponseDock& m_dock;
    BackgroundJob m_searching;
    BackgroundJob m_advising;
    std::shared_ptr<Search> m_search;
    std::shared_ptr<Advice> m_advice;
    std::optional<SuggestionTask> m_next;  ///< requested while another was in progress
};

}  // namespace nmc
