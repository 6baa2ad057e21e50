// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messagecontroller.h"

#include <QDateTime>
#include <algorithm>

#include "link/clock.h"
#include "model/module/modulescale.h"
#include "widgets/common/positiontexts.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/messages/messagemodel.h"
#include "widgets/messages/messagepanel.h"

namespace nmc {

MessageController::MessageController(MainWindow& window, const BusStore& store,
                                     const ProcedureController& procedures, const PositionKeeper& positions,
                                     FlightController& flight, RecordingController& recordings,
                                     const QString& logFolder)
    : m_window(window),
      m_store(store),
      m_procedures(procedures),
      m_flight(flight),
      m_recordings(recordings),
      m_log(logFolder) {
    MessagePanel& panel = m_window.messages();
    const MessageModel& messages = m_window.messageModel();
    const auto logReport = [this](const MessageEntry& entry) { keepLog(messageLine(entry)); };
    connect(&messages, &MessageModel::reported, this, logReport);
    connect(&messages, &MessageModel::amended, this, logReport);
    connect(&messages, &MessageModel::ended, this,
            [this](const MessageEntry& entry) { keepLog(overLine(entry)); });
    connect(&m_log, &DayLog::failed, this, [this, &panel](const FileError& error) {
        report(texts::messagesNotKept(error));
        panel.showLogFile({});
    });
    connect(&m_log, &DayLog::kept, this, [this, &panel](const QString& path) {
        end(texts::key::kMessageLog);
        panel.showLogFile(path);
    });
    panel.showLogFile(m_log.file(QDateTime::currentDateTime()));
    connect(&m_store, &BusStore::linkChanged, this, &MessageController::look);
    connect(&m_procedures, &ProcedureController::reported, this, &MessageController::showEnd);
    connect(&positions, &PositionKeeper::offered, this, [this](const PositionMemory::Offer& offer) {
        report(texts::positionRemembered(offer, scaleOf(*m_store.module(offer.module))));
    });
    connect(&positions, &PositionKeeper::over, this,
            [this](ModuleIndex module) { end(texts::ofModule(texts::key::kPosition, module)); });
    connect(&positions, &PositionKeeper::failed, this,
            [this](const FileError& error) { report(texts::positionsNotKept(error)); });
}

void MessageController::keepLog(const QString& line) {
    m_log.write(line.toStdString(), QDateTime::currentDateTime());
}

AxisScale MessageController::scaleOf(const ModuleState& module) const {
    return nmc::scaleOf(module, m_store.machine().axis(module.info.index));
}

void MessageController::showEnd(const ProcedureReport& procedure) {
    if (!procedure.over())
        return end(texts::ofModule(texts::key::kProcedure, procedure.module));
    const ModuleState* module = m_store.module(procedure.module);
    if (module == nullptr)
        return;
    if (const auto message = texts::procedureEnded(procedure, scaleOf(*module)))
        reportOf(*message);
}

void MessageController::refused(ModuleIndex index, Refusal refusal, const Intent& intent) {
    const ModuleState& module = *m_store.module(index);
    reportOf(texts::notPossible(index, texts::refusal(refusal, intent, module, scaleOf(module))));
}

void MessageController::stoppedBeyondTravel(ModuleIndex module) {
    showEnd({.module = module,
             .kind = ProcedureKind::Approach,
             .stage = ProcedureStage::Failed,
             .failure = ProcedureFailure::SoftLimit});
}

void MessageController::look() {
    const LinkState& link = m_store.link();
    const std::vector<Message> all = texts::standing(
        link, monotonicNow(), [this](ModuleIndex module) { return m_procedures.running(module); });
    std::erase_if(m_standing, [&](const auto& entry) {
        const auto& [key, standing] = entry;
        const bool stands =
            standing.connection == link.connection && std::ranges::find(all, key, &Message::key) != all.end();
        // Nothing is known about a chain that is gone: a motor that may be moving may still be.
        if (stands || (link.modules.empty() && key == texts::ofModule(texts::key::kSilent, standing.module)))
            return false;
        end(key);
        return true;
    });
    for (const Message& message : all)
        if (m_standing.try_emplace(message.key, Standing{*message.module, link.connection}).second)
            report(recorded(message));
}

Message MessageController::recorded(Message message) {
    if (message.offers(MessageAction::ShowRecord)) {
        emit aboutToReport();
        message.record = m_flight.note(message.headline, message.module, monotonicNow());
        if (message.record == 0)
            message.actions.removeIf(
                [](const auto& action) { return action.id == MessageAction::ShowRecord; });
        m_recordings.note(message.headline);
    }
    return message;
}

void MessageController::report(const Message& message) {
    emit aboutToReport();
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

void MessageController::take(const StoreEvent& event) {
    std::visit([this](const auto& any) { on(any); }, event);
    if (std::holds_alternative<GuardianMissing>(event) && std::exchange(m_guardianMissed, true))
        return;
    for (const News& news : newsOf(event, m_store.link()))
        take(news);
}

void MessageController::take(const News& news) {
    const Message message = recorded(news.message);
    if (news.stop) {
        for (const ModuleIndex module : news.stopped)
            m_stopping[module] = {*news.stop, message.key};
        m_stopMessages[message.key] = message;
    }
    switch (news.until) {
        case News::Until::Cause:
            return report(message);
        case News::Until::ModuleObeys:
            return reportOf(message);
        case News::Until::ConnectionEnds:
            return reportOfChain(message);
    }
}

/// Conditions that persist are reported again.
void MessageController::on(const bus::ChainFound& /*found*/) {
    m_stopping.clear();
    m_unstopped.clear();
    endEvents(std::nullopt);
    end(texts::key::kBadLink);
}

void MessageController::on(const bus::OperationFinished& finished) {
    if (finished.outcome == bus::Outcome::Done)
        endEvents(finished.module);
}

void MessageController::on(const bus::OwedStopConfirmed& confirmed) {
    if (m_unstopped.erase(confirmed.module) != 0)
        amend(texts::key::kStop, {confirmed.module, bus::StopCause::StopAll});
    const auto reported = m_stopping.find(confirmed.module);
    if (reported == m_stopping.end())
        return;
    const auto& [cause, key] = reported->second;
    // A fault takes the place of what the user wanted, so its confirmation is that of both; any other stop
    // that the user wanted came later, and is not reported.
    if (bus::ofOperator(confirmed.cause) && confirmed.cause != cause)
        return;
    amend(key, {confirmed.module, cause});
    m_stopping.erase(reported);
}

void MessageController::amend(const QString& key, const bus::OwedStopConfirmed& confirmed) {
    Message& message = m_stopMessages[key];
    message.headline += u' ' + texts::stopConfirmed(confirmed);
    m_window.amendMessage(message);
}

void MessageController::on(const bus::StopFinished& finished) {
    // For example, a port without modules was closed: no stop was requested, and none was needed.
    if (finished.unasked && finished.reachedNobody())
        return;
    m_recordings.note(texts::stopOfAll());
    m_window.showLink(m_store.link());  // the stop may be due to a restart that came just before
    const unsigned record = m_flight.note(texts::stopOfAll(), {}, monotonicNow() - finished.took);
    m_stopMessages[texts::key::kStop] = m_window.showStopResult(finished, record);
    m_unstopped = {finished.unreached.begin(), finished.unreached.end()};
    m_unstopped.insert(finished.unconfirmed.begin(), finished.unconfirmed.end());
}

void MessageController::on(const bus::ModuleUnresponsive& silence) {
    if (!silence.silent)
        end(texts::key::kLink);
}

void MessageController::on(const bus::HealthChanged& changed) {
    if (changed.health == bus::LinkHealth::Good)
        end(texts::key::kBadLink);
}

void MessageController::on(const bus::Readdressed& /*readdressed*/) {
    end(texts::key::kUnaddressed);
}

void MessageController::on(const PortClosed& /*closed*/) {
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
