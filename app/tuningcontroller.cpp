// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tuningcontroller.h"

#include <utility>

#include "widgets/common/requests.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/response/responsedock.h"

namespace nmc {

TuningController::TuningController(MainWindow& window) : m_dock(window.stepResponses()) {
    connect(&window.requests(), &Requests::identify, this, &TuningController::identify);
    connect(&window.requests(), &Requests::suggest, this, &TuningController::suggest);
    connect(&m_searching, &BackgroundJob::ended, this, [this] {
        const auto search = m_search;  // the next one may begin
        m_dock.page().model().showMotor(search->module, search->found);
    });
    connect(&m_advising, &BackgroundJob::ended, this, &TuningController::suggested);
}

void TuningController::identify(ModuleIndex module, const std::vector<ResponseRecord>& runs) {
    m_searching.cancel();  // it was for modules that are gone
    m_search = std::make_shared<Search>(Search{module, runs});
    m_searching.start([search = m_search](const BackgroundJob::Cancelled&) {
        search->found = nmc::identify(search->runs);
    });
}

void TuningController::suggest(const SuggestionTask& task) {
    if (m_advising.isBusy()) {
        m_next = task;
        return;
    }
    m_advice = std::make_shared<Advice>(Advice{task, {}});
    m_advising.start([advice = m_advice](const BackgroundJob::Cancelled&) {
        const SuggestionTask& asked = advice->task;
        Suggestion& found = advice->suggestion;
        found.id = asked.id;
        found.gains = nmc::suggest(asked.motor, asked.wish, asked.now, asked.taken.goal - asked.taken.from);
        if (found.gains)
            found.prediction = predict(asked.motor, *found.gains, asked.taken.from, asked.taken.goal,
                                       asked.taken.record, asked.bandPercent);
    });
}

void TuningController::suggested() {
    const Suggestion suggestion = m_advice->suggestion;
    if (const auto next = std::exchange(m_next, std::nullopt))
        suggest(*next);
    m_dock.page().model().showSuggestion(suggestion);
}

}  // namespace nmc
