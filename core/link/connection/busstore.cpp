// SPDX-License-Identifier: MIT
#include "link/connection/busstore.h"

#include <algorithm>

namespace nmc {

namespace {

constexpr int kDrainIntervalMs = 16;

}  // namespace

BusStore::BusStore(BusWorker& worker, QObject* parent) : QObject(parent), m_worker(worker) {
    m_drainTimer.setSingleShot(true);
    m_drainTimer.setInterval(kDrainIntervalMs);
    m_drainTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_drainTimer, &QTimer::timeout, this, &BusStore::drain);
    // Between two drains the worker's queue is not empty, so it stays quiet: at most one wake-up a frame.
    connect(&m_worker, &BusWorker::eventsReady, this, [this] {
        if (!m_drainTimer.isActive())
            m_drainTimer.start();
    });
}

void BusStore::begin(const QString& port, bool simulated, std::uint32_t baud) {
    forgetChain();
    m_link.phase = LinkPhase::Connecting;
    m_link.port = port.toStdString();
    m_link.simulated = simulated;
    m_link.baud = baud;
    m_lastStatistics = {};
    emit linkChanged();
}

const ModuleState* BusStore::module(ModuleIndex index) const {
    return known(index) ? &m_link.modules[index.value()] : nullptr;
}

int BusStore::movingMotors() const {
    return static_cast<int>(std::count_if(m_link.modules.begin(), m_link.modules.end(),
                                          [](const ModuleState& module) { return module.moving(); }));
}

LinkFigures BusStore::pullFigures(TimePoint now) {
    LinkFigures figures;
    const bus::LinkStatistics statistics = m_worker.statistics();
    const double seconds = toSeconds(now - m_lastPull);
    if (seconds > 0.0 && m_lastPull != TimePoint{} && statistics.answered >= m_lastStatistics.answered) {
        const auto answered = static_cast<double>(statistics.answered - m_lastStatistics.answered);
        figures.exchangesPerSecond = answered / seconds;
        // A perfect line is reckoned with the mean wait for a tick; who falls in step with the ticks waits
        // less.
        figures.wireShare =
            std::min(1.0, toSeconds(statistics.wireTime - m_lastStatistics.wireTime) / seconds);
        figures.errorsPerSecond =
            static_cast<double>(statistics.errors() - m_lastStatistics.errors()) / seconds;
        if (answered > 0.0)
            figures.meanRoundTripMs =
                1e3 * toSeconds(statistics.roundTripSum - m_lastStatistics.roundTripSum) / answered;
    }
    pullRates(seconds);
    figures.errors = statistics.errors();
    figures.counters = statistics;
    m_lastStatistics = statistics;
    m_lastPull = now;
    return figures;
}

void BusStore::pullRates(double seconds) {
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        Record& record = m_records[i];
        const auto since = static_cast<double>(record.samples - record.samplesPulled);
        m_link.modules[i].repliesPerSecond =
            seconds > 0.0 && m_lastPull != TimePoint{} ? since / seconds : 0.0;
        record.samplesPulled = record.samples;
    }
}

void BusStore::drain() {
    const std::vector<WorkerEvent> events = m_worker.takeEvents();
    for (const WorkerEvent& event : events)
        take(event);
    if (!events.empty())
        emit linkChanged();
}

void BusStore::take(const WorkerEvent& event) {
    if (const auto* busEvent = std::get_if<bus::Event>(&event))
        take(*busEvent);
    else if (const auto* close = std::get_if<PortClosed>(&event))
        closed(*close);
    else if (const auto* answer = std::get_if<SimulatorAnswered>(&event))
        emit happened(*answer);
    else if (const auto* froze = std::get_if<PanelFroze>(&event))
        emit happened(*froze);
    else if (const auto* slept = std::get_if<MachineSlept>(&event))
        emit happened(*slept);
}

void BusStore::take(const bus::Event& event) {
    if (const auto* sample = std::get_if<bus::Sample>(&event)) {
        take(*sample);
    } else if (const auto* executed = std::get_if<bus::CommandExecuted>(&event)) {
        if (known(executed->module)) {
            m_link.modules[executed->module.value()].apply(*executed);
            m_records[executed->module.value()].feed.apply(*executed);
            noteGains(*executed);
        }
    } else if (const auto* progress = std::get_if<bus::ConnectProgress>(&event)) {
        m_link.phase = LinkPhase::Connecting;
        m_link.stage = progress->stage;
        m_link.found = progress->modules;
    } else if (const auto* chain = std::get_if<bus::ChainFound>(&event)) {
        found(*chain);
        emit happened(*chain);
    } else if (const auto* failed = std::get_if<bus::ConnectFailed>(&event)) {
        m_link.phase = LinkPhase::Lost;
        emit happened(*failed);
    } else if (const auto* silent = std::get_if<bus::ModuleSilence>(&event)) {
        silence(*silent);
    } else if (const auto* lost = std::get_if<bus::LinkLost>(&event)) {
        m_link.phase = LinkPhase::Lost;
        emit happened(*lost);
    } else if (const auto* finished = std::get_if<bus::OperationFinished>(&event)) {
        // It may have been carried out or not.
        if (finished->outcome == bus::Outcome::NoAnswer && known(finished->module)) {
            m_records[finished->module.value()].feed.doubt();
            doubtMotions({finished->module});
        }
        emit happened(*finished);
    } else if (const auto* stopped = std::get_if<bus::StopFinished>(&event)) {
        take(*stopped);
        emit happened(*stopped);
    } else if (const auto* owed = std::get_if<bus::OwedStopConfirmed>(&event)) {
        if (known(owed->module))
            m_link.modules[owed->module.value()].confirmedAtRest();
        emit happened(*owed);
    } else if (const auto* refused = std::get_if<bus::CommandRefused>(&event)) {
        emit happened(*refused);
    } else if (const auto* expired = std::get_if<bus::HoldExpired>(&event)) {
        emit happened(*expired);
    } else if (const auto* health = std::get_if<bus::HealthChanged>(&event)) {
        if (health->health == bus::LinkHealth::Lost && !health->module)
            m_link.phase = LinkPhase::Lost;
        emit happened(*health);
    } else if (const auto* restarted = std::get_if<bus::ModuleRestarted>(&event)) {
        if (restarted->quiet)
            m_link.phase = LinkPhase::Lost;
        if (known(restarted->module)) {
            m_link.modules[restarted->module.value()].restarted();
            m_records[restarted->module.value()].feed.doubt();
            doubtGains(restarted->module);
        }
        emit happened(*restarted);
    } else if (const auto* suspect = std::get_if<bus::MotionSuspect>(&event)) {
        emit happened(*suspect);
    } else if (const auto* group = std::get_if<bus::GroupFinished>(&event)) {
        emit happened(*group);
    } else if (const auto* changed = std::get_if<bus::GroupChanged>(&event)) {
        if (known(changed->module))
            m_link.modules[changed->module.value()].info.group = changed->place;
    } else if (const auto* rate = std::get_if<bus::RateChanged>(&event)) {
        m_link.baud = rate->baud;
        emit happened(*rate);
    } else if (const auto* kept = std::get_if<bus::RateChangeFailed>(&event)) {
        emit happened(*kept);
    }
}

void BusStore::take(const bus::Sample& sample) {
    if (!known(sample.module))
        return;
    ModuleState& module = m_link.modules[sample.module.value()];
    Record& record = m_records[sample.module.value()];
    ++record.samples;
    const bool wasOff = module.switchedItselfOff;
    const bool wasLimited = module.currentWasLimited();
    module.apply(sample);
    if (const auto kept = record.feed.take(sample))
        m_history.append(sample.module, *kept);
    if (module.switchedItselfOff && !wasOff)
        emit happened(ServoWentOff{sample.module, module.activity(), module.latest->position.value_or(0)});
    if (module.currentWasLimited() != wasLimited)
        emit happened(CurrentLimited{sample.module, !wasLimited});
}

void BusStore::doubtMotions(const std::vector<ModuleIndex>& modules) {
    for (const ModuleIndex module : modules)
        if (known(module))
            m_link.modules[module.value()].doubtMotion();
}

void BusStore::take(const bus::StopFinished& stopped) {
    for (const ModuleIndex module : stopped.stopped)
        if (known(module))
            m_link.modules[module.value()].confirmedAtRest();
    doubtMotions(stopped.unreached);
    doubtMotions(stopped.unconfirmed);
}

void BusStore::noteGains(const bus::CommandExecuted& executed) {
    const auto* servoCommand = std::get_if<ServoCommand>(&executed.command);
    if (servoCommand == nullptr)
        return;
    if (const auto* gains = std::get_if<servo::SetGain>(servoCommand))
        m_history.noteGains({executed.module, executed.time, *gains});
}

void BusStore::doubtGains(ModuleIndex module) {
    const auto& gains = m_history.gains();
    const auto last = std::find_if(gains.rbegin(), gains.rend(),
                                   [&](const GainsChange& change) { return change.module == module; });
    if (last != gains.rend() && last->gains)
        m_history.noteGains({module, m_history.end().value_or(last->time), std::nullopt});
}

void BusStore::found(const bus::ChainFound& chain) {
    forgetChain();
    m_link.phase = LinkPhase::Connected;
    m_link.baud = chain.baud;
    for (const bus::ModuleInfo& info : chain.modules) {
        ModuleState module;
        module.info = info;
        if (chain.attached)
            module.attached();
        m_link.modules.push_back(module);
    }
    m_records.resize(chain.modules.size());
    beginHistory(chain);
}

/// The same chain at the same port goes on with its history, behind a gap: what led to the trouble is still
/// there to be looked at.
void BusStore::beginHistory(const bus::ChainFound& chain) {
    std::vector<ModuleIdentity> identities;
    for (const bus::ModuleInfo& info : chain.modules)
        identities.push_back(info.identity);
    if (m_historyPort == m_link.port && m_historyOf == identities) {
        for (const bus::ModuleInfo& info : chain.modules)
            doubtGains(info.index);
        return;
    }
    m_history = History(identities.size());
    m_historyPort = m_link.port;
    m_historyOf = std::move(identities);
}

void BusStore::silence(const bus::ModuleSilence& silence) {
    if (known(silence.module)) {
        m_link.modules[silence.module.value()].silent = silence.silent;
        Record& record = m_records[silence.module.value()];
        record.feed.breakHere();
        if (silence.silent) {
            record.feed.doubt();
            doubtMotions({silence.module});
        }
        if (!silence.silent && m_link.phase == LinkPhase::Lost)
            m_link.phase = LinkPhase::Connected;
    }
    emit happened(silence);
}

void BusStore::closed(const PortClosed& closed) {
    PortClosed news = closed;
    if (news.error && news.error->problem == PortProblem::Gone)
        news.error->movingMotors = movingMotors();
    m_link.phase = LinkPhase::Disconnected;
    forgetChain();
    emit happened(news);
}

void BusStore::forgetChain() {
    m_link.modules.clear();
    m_link.found = 0;
    m_records.clear();
}

}  // namespace nmc
