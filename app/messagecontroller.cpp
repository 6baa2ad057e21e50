// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messagecontroller.h"

#include <algorithm>

#include "link/clock.h"
#include "widgets/common/texts.h"

namespace nmc {

MessageController::MessageController(MainWindow& window, const BusStore& store,
                                     const ProcedureController& procedures, FlightController& flight,
                                     RecordingController& recordings, QObject* parent)
    : QObject(parent),
      m_window(window),
      m_store(store),
      m_procedures(procedures),
      m_flight(flight),
      m_recordings(recordings) {}

void MessageController::look() {
    const LinkState& link = m_store.link();
    const std::vector<Message> all = texts::standing(
        link, monotonicNow(), [this](ModuleIndex module) { return m_procedures.running(module); });
    std::erase_if(m_standing, [&](const auto& told) {
        const auto& [key, standing] = told;
        const bool stands =
            standing.connection == link.connection && std::ranges::find(all, key, &Message::key) != all.end();
        // Nothing is known about a chain that is gone: a motor that may be moving may still be.
        if (stands || (link.modules.empty() && key == texts::key::silent(standing.module)))
            return false;
        end(key);
        return true;
    });
    for (const Message& message : all)
        if (m_standing.try_emplace(message.key, Standing{*message.module, link.connection}).second)
            report(message);
}

void MessageController::report(const Message& message) {
    emit aboutToReport();
    if (message.offers(MessageAction::ShowRecord)) {
        m_flight.note(message.key, message.headline, message.module, monotonicNow());
        m_recordings.note(message.headline);
    }
    m_window.showMessage(message);
}

void MessageController::reportOf(const Message& message) {
    report(message);
    m_events[message.key] = message.module;
}

void MessageController::reportOfChain(const Message& message) {
    report(message);
    m_events[message.key] = std::nullopt;
}

void MessageController::noteStop(const Message& message, bus::StopCause cause,
                                 const std::vector<ModuleIndex>& modules) {
    for (const ModuleIndex module : modules)
        m_stopping[{cause, module}] = message.key;
    m_stopMessages[message.key] = message;
}

void MessageController::stopConfirmed(const bus::OwedStopConfirmed& confirmed) {
    const auto told = m_stopping.find({confirmed.cause, confirmed.module});
    if (told == m_stopping.end())
        return;
    Message& message = m_stopMessages[told->second];
    message.headline += u' ' + texts::stopConfirmed(confirmed);
    m_window.amendMessage(message);
    m_stopping.erase(told);
}

void MessageController::obeyed(ModuleIndex module) {
    endEvents(module);
}

void MessageController::chainFound() {
    m_stopping.clear();
    endEvents(std::nullopt);
}

void MessageController::connectionEnded() {
    endEvents(std::nullopt);
}

/// Ends the messages of a module that obeys again; without a module, all of them.
void MessageController::endEvents(std::optional<ModuleIndex> obeyed) {
    std::erase_if(m_events, [&](const auto& event) {
        const bool over = !obeyed || event.second == obeyed;
        if (over)
            end(event.first);
        return over;
    });
}

}  // namespace nmc
