// SPDX-License-Identifier: MIT
#include "link/connection/busstore.h"

#include <algorithm>

#include "bus/rejoin.h"

namespace nmc {

namespace {

constexpr int kDrainIntervalMs = 16;

/// The counters restart with each chain that is found.
[[nodiscard]] bool beganAnew(const bus::LinkStatistics& before, const bus::LinkStatistics& now) {
    return now.exchanges < before.exchanges || now.answered < before.answered ||
           now.errors() < before.errors() || now.wireTime < before.wireTime ||
           now.roundTripSum < before.roundTripSum;
}

/// A module of which nothing is known. The name of the work offset that was in use stays, so that the user
/// sees that its place is not known any more.
[[nodiscard]] ModuleState unknownModule(const ModuleState& before) {
    ModuleState module;
    module.home = before.home;
    module.home.restarted();
    return module;
}

}  // namespace

BusStore::BusStore(BusWorker& worker, QObject* parent) : QObject(parent), m_worker(worker) {
    m_drainTimer.setSingleShot(true);
    m_drainTimer.setInterval(kDrainIntervalMs);
    m_drainTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_drainTimer, &QTimer::timeout, this, &BusStore::drain);
    // Between two drains the worker's queue is not empty, so the worker emits nothing: at most one wake-up
    // per frame.
    connect(&m_worker, &BusWorker::eventsReady, this, [this] {
        if (!m_drainTimer.isActive())
            m_drainTimer.start();
    });
}

void BusStore::begin(const QString& port, bool simulated, std::uint32_t baud, bool readOnly) {
    forgetChain();
    m_link.phase = LinkPhase::Connecting;
    ++m_link.connection;
    m_link.unplugged = m_link.unplugged && m_link.port == port.toStdString();
    m_link.port = port.toStdString();
    m_link.simulated = simulated;
    m_link.readOnly = readOnly;
    m_link.baud = baud;
    m_lastStatistics = {};
    emit linkChanged();
}

const ModuleState* BusStore::module(ModuleIndex index) const {
    return known(index) ? &m_link.modules[index.value()] : nullptr;
}

LinkFigures BusStore::pullFigures(TimePoint now) {
    LinkFigures figures;
    const bus::LinkStatistics statistics = m_worker.statistics();
    if (beganAnew(m_lastStatistics, statistics))
        m_lastStatistics = {};
    const double seconds = toSeconds(now - m_lastPull);
    if (seconds > 0.0 && m_lastPull != TimePoint{}) {
        const auto answered = static_cast<double>(statistics.answered - m_lastStatistics.answered);
        figures.exchangesPerSecond = answered / seconds;
        // The wire time assumes the mean wait for a tick; exchanges that fall in step with the ticks wait
        // less, hence the limit of 1.
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
    std::visit(Overloaded{
                   [this](const bus::Event& busEvent) { take(busEvent); },
                   [this](const PortOpened& opened) {
                       m_link.latency = opened.latency;
                       m_link.unplugged = false;
                   },
                   [this](const PortClosed& close) { closed(close); },
                   [this](const In<StoreEvent> auto& news) {
                       note(news);
                       emit happened(news);
                   },
               },
               event);
}

void BusStore::take(const bus::Event& event) {
    std::visit(Overloaded{
                   [this](const bus::Sample& sample) { take(sample); },
                   [this](const bus::CommandExecuted& command) { executed(command); },
                   [this](const bus::ConnectProgress& progress) {
                       m_link.phase = LinkPhase::Connecting;
                       m_link.stage = progress.stage;
                       using enum bus::ConnectStage;
                       m_link.looking =
                           progress.stage == Looking ||
                           (m_link.looking && progress.stage != Restarting && progress.stage != Addressing);
                       m_link.found = progress.modules;
                   },
                   [this](const bus::PathProgress& path) {
                       if (known(path.module))
                           m_link.modules[path.module.value()].path = path;
                   },
                   [this](const AnyOf<bus::ModulesSeen, bus::CommandUnanswered> auto& seen) { note(seen); },
                   [this](const bus::GroupChanged& changed) {
                       if (known(changed.module))
                           m_link.modules[changed.module.value()].info.group = changed.place;
                   },
                   [this](const In<StoreEvent> auto& news) {
                       note(news);
                       emit happened(news);
                   },
               },
               event);
}

void BusStore::executed(const bus::CommandExecuted& command) {
    if (!known(command.module))
        return;
    m_link.modules[command.module.value()].apply(command);
    m_records[command.module.value()].feed.apply(command);
    m_records[command.module.value()].open = false;
    if (const auto* gains = getIf<servo::SetGain>(command.command))
        m_history.noteGains({command.module, command.time, *gains});
}

template <typename Function>
void BusStore::change(ModuleIndex module, Function function) {
    if (!known(module))
        return;
    function(m_link.modules[module.value()]);
    emit linkChanged();
}

void BusStore::noteAsked(ModuleIndex module, bus::OperationId operation) {
    change(module, [operation](ModuleState& state) { state.awaited = operation; });
}

void BusStore::note(const bus::OperationFinished& finished) {
    if (known(finished.module))
        if (auto& awaited = m_link.modules[finished.module.value()].awaited; awaited == finished.id)
            awaited.reset();
    if (finished.outcome != bus::Outcome::Done && known(finished.module))
        m_records[finished.module.value()].feed.cancelled();
    // What was in flight when something cancelled it is as uncertain as what was never answered.
    if (finished.outcome == bus::Outcome::NoAnswer ||
        (finished.outcome == bus::Outcome::Cancelled && finished.sent))
        doubtCommand(finished.module, static_cast<CommandCode>(finished.commandByte & 0x0FU));
    for (const ModuleIndex module : finished.unloaded)
        if (known(module))
            m_link.modules[module.value()].forgetLoad();
}

void BusStore::note(const bus::CommandUnanswered& command) {
    doubtCommand(command.module, payloadOf(command.command).code);
}

void BusStore::doubtCommand(ModuleIndex index, CommandCode command) {
    if (!known(index))
        return;
    ModuleState& module = m_link.modules[index.value()];
    ScopeFeed& feed = m_records[index.value()].feed;
    feed.doubt();
    doubtMotions({index});
    doubtOutputs(index, command);
    if (command == CommandCode::ResetPosition || command == CommandCode::SaveAsHome)
        module.home.forget();
    if (command == CommandCode::ResetPosition)
        module.forgetLoad();
    if (command == CommandCode::SetGain && module.isServo()) {
        module.doubtGains();
        feed.doubtServoRate();
        doubtGains(index);
    }
}

/// The old values must not be sent with the next one as if they were still set.
void BusStore::doubtOutputs(ModuleIndex index, CommandCode command) {
    if (known(index) && m_link.modules[index.value()].isIo())
        m_link.modules[index.value()].pins.doubt(command);
}

void BusStore::note(const LineLent& lent) {
    const bool over = lent.state == LineLent::State::Left || lent.state == LineLent::State::Ended;
    m_link.lent.reset();
    if (!over)
        m_link.lent = LentLine{lent.path, lent.state != LineLent::State::Waiting,
                               lent.state == LineLent::State::HeldOff};
    for (ModuleState& module : m_link.modules)
        module.lent = !over;
}

/// A member whose answer to a group's Save as Home or Reset Position is missing has its home in doubt, and
/// its outputs after a start.
void BusStore::note(const bus::GroupFinished& finished) {
    const auto* command = std::get_if<bus::GroupCommand>(&finished.what);
    using enum bus::GroupCommand::Action;
    if (command == nullptr)
        return;
    for (const bus::GroupMember& member : finished.members) {
        const bool open =
            member.outcome == bus::MemberOutcome::Unknown || member.outcome == bus::MemberOutcome::NoAnswer;
        if (!open || !known(member.module))
            continue;
        m_records[member.module.value()].feed.doubt();
        if (command->action == SaveAsHome || command->action == ResetPosition)
            m_link.modules[member.module.value()].home.forget();
        else if (command->action == StartMotion)
            doubtOutputs(member.module, io::SynchOutput::kCode);
    }
}

/// Another host may have reset the counters, by so little that it looks like a motion.
void BusStore::note(const bus::ForeignTraffic& /*traffic*/) {
    for (ModuleState& module : m_link.modules)
        module.home.forget();
}

void BusStore::noteHome(ModuleIndex module, std::int32_t counts) {
    // Announced with the procedure's report, in the middle of which this is: an announcement from here would
    // make the procedure go on from itself.
    if (known(module))
        m_link.modules[module.value()].home.found(counts, m_link.modules[module.value()].latestTime);
}

void BusStore::noteFocus(std::optional<ModuleIndex> module) {
    m_link.focused = module;
}

void BusStore::declarePosition(ModuleIndex module, bool right) {
    change(module, [right](ModuleState& state) {
        right ? state.home.declare(state.latestTime) : state.home.forget();
    });
}

void BusStore::setMachine(const Machine& machine) {
    m_usersMachine = machine;
    useMachine();
    emit linkChanged();
}

void BusStore::useMachine() {
    m_machine = usable(m_usersMachine, m_link.modules);
    m_link.take(m_usersMachine);
}

void BusStore::offerHome(ModuleIndex module, std::int32_t counts) {
    change(module, [counts](ModuleState& state) { state.home.offer(counts); });
}

void BusStore::takeHome(ModuleIndex module) {
    change(module, [](ModuleState& state) { state.home.takeOffer(state.latestTime); });
}

void BusStore::dropHome(ModuleIndex module) {
    change(module, [](ModuleState& state) { state.home.dropOffer(); });
}

void BusStore::useWorkOffset(ModuleIndex module, const std::optional<WorkOffset>& offset,
                             const std::optional<std::int32_t>& home) {
    change(module, [&](ModuleState& state) { state.home.useWork(offset, home); });
}

void BusStore::setRights(const std::optional<OperatorRights>& rights) {
    m_link.rights = rights;
    for (ModuleState& module : m_link.modules)
        module.rights = rights;
    emit linkChanged();
}

void BusStore::note(const bus::OwedStopConfirmed& confirmed) {
    if (known(confirmed.module))
        m_link.modules[confirmed.module.value()].confirmedAtRest();
}

/// The goal and speed of another host's motion are unknown here.
void BusStore::note(const bus::ForeignMotion& motion) {
    if (!known(motion.module))
        return;
    m_records[motion.module.value()].feed.doubt();
    doubtMotions({motion.module});
}

void BusStore::note(const bus::HealthChanged& changed) {
    if (changed.health == bus::LinkHealth::Lost && !changed.module)
        lost(false);
}

void BusStore::lost(bool quiet) {
    m_link.phase = LinkPhase::Lost;
    m_link.quiet = quiet;
}

/// Nothing that was reported by or sent to the module before is valid any more.
void BusStore::note(const bus::Readdressed& readdressed) {
    if (!known(readdressed.module.index))
        return;
    ModuleState& module = m_link.modules[readdressed.module.index.value()];
    module = unknownModule(module);
    module.info = readdressed.module;
    module.readOnly = m_link.readOnly;
    useMachine();
    module.rights = m_link.rights;
}

void BusStore::note(const bus::ModuleRestarted& restarted) {
    if (restarted.quiet)
        lost(true);
    if (!known(restarted.module))
        return;
    m_link.modules[restarted.module.value()].silent = true;
    m_link.modules[restarted.module.value()].restarted();
    m_records[restarted.module.value()].feed.doubt();
    doubtGains(restarted.module);
}

void BusStore::take(const bus::Sample& sample) {
    if (!known(sample.module))
        return;
    ModuleState& module = m_link.modules[sample.module.value()];
    Record& record = m_records[sample.module.value()];
    ++record.samples;
    module.apply(sample);
    const std::size_t index = sample.module.value();
    const bool ofHistory = index < m_historyOf.size() && m_historyOf[index] == module.info.identity;
    if (const auto kept = record.feed.take(sample); kept && ofHistory)
        m_history.append(sample.module, *kept);
}

void BusStore::doubtMotions(const std::vector<ModuleIndex>& modules) {
    for (const ModuleIndex module : modules)
        if (known(module))
            m_link.modules[module.value()].doubtMotion();
}

void BusStore::note(const bus::StopFinished& stopped) {
    for (const ModuleIndex module : stopped.stopped)
        if (known(module))
            m_link.modules[module.value()].confirmedAtRest();
    for (const auto* missing : {&stopped.unreached, &stopped.unconfirmed, &stopped.noStopKnown}) {
        doubtMotions(*missing);
        for (const ModuleIndex module : *missing)
            if (known(module))  // no stop is repeated for one that has restarted
                m_link.modules[module.value()].stopUnconfirmed = !m_link.modules[module.value()].hasRestarted;
    }
    for (Record& record : m_records)
        record.open = true;
}

void BusStore::doubtGains(ModuleIndex module) {
    const auto& gains = m_history.gains();
    const auto last = std::find_if(gains.rbegin(), gains.rend(),
                                   [&](const GainsChange& change) { return change.module == module; });
    if (last != gains.rend() && last->gains)
        m_history.noteGains({module, m_history.end().value_or(last->time), std::nullopt});
}

void BusStore::note(const bus::ChainFound& chain) {
    setModules(chain);
    beginHistory(chain);
}

/// While a program gives addresses, the history stays that of the chain of before, until all have said what
/// they are.
void BusStore::note(const bus::ModulesSeen& seen) {
    const bus::ChainFound chain{.modules = seen.modules, .baud = seen.baud, .attached = true};
    setModules(chain);
    if (!seen.modules.empty() &&
        std::ranges::find(seen.modules, kUnheardModule, &bus::ModuleInfo::identity) == seen.modules.end())
        beginHistory(chain);
}

/// A module that answers at its address has not restarted since it was last seen, and a search without a
/// reset sends it nothing but queries. Within one connection its state is therefore kept, except that it is
/// unknown whether a motion continues.
void BusStore::setModules(const bus::ChainFound& chain) {
    const std::vector<ModuleState> before = std::move(m_link.modules);
    const std::vector<Record> recordsBefore = std::move(m_records);
    forgetChain();
    m_link.phase = LinkPhase::Connected;
    m_link.baud = chain.baud;
    m_link.readOnly = chain.readOnly;
    m_records.resize(chain.modules.size());
    for (const bus::ModuleInfo& info : chain.modules) {
        const auto same = std::ranges::find_if(before, [&](const ModuleState& old) {
            return bus::sameModule(old.info, info) && !old.hasRestarted;
        });
        const bool again = chain.attached && same != before.end();
        const std::size_t index = info.index.value();
        ModuleState module;
        if (again)
            module = *same;
        else if (index < before.size())
            module = unknownModule(before[index]);
        module.info = info;
        module.readOnly = chain.readOnly;
        module.lent = m_link.lent.has_value();
        module.rights = m_link.rights;
        Record& record = m_records[info.index.value()];
        if (again) {
            record = recordsBefore[static_cast<std::size_t>(same - before.begin())];
            record.feed.breakHere();
            if (record.open || module.moving())
                record.feed.doubt();
            module.doubtMotion();
        } else if (chain.attached) {
            module.attached();
            record.feed.attached();
        }
        module.silent = std::ranges::find(chain.absent, info.index) != chain.absent.end();
        m_link.modules.push_back(module);
    }
    useMachine();
}

/// The history of the same chain at the same port continues after a gap, so that what led to the trouble can
/// still be examined.
void BusStore::beginHistory(const bus::ChainFound& chain) {
    std::vector<ModuleIdentity> identities;
    for (const bus::ModuleInfo& info : chain.modules)
        identities.push_back(info.identity);
    if (m_historyPort == m_link.port && m_historyOf == identities) {
        for (const ModuleState& module : m_link.modules)
            if (!module.gains)
                doubtGains(module.info.index);
        return;
    }
    m_history = History(identities.size());
    m_historyPort = m_link.port;
    m_historyOf = std::move(identities);
}

void BusStore::note(const bus::ModuleUnresponsive& silence) {
    if (!known(silence.module))
        return;
    m_link.modules[silence.module.value()].silent = silence.silent;
    Record& record = m_records[silence.module.value()];
    record.feed.breakHere();
    if (silence.silent) {
        record.feed.doubt();
        doubtMotions({silence.module});
    } else if (m_link.phase == LinkPhase::Lost)
        m_link.phase = LinkPhase::Connected;
}

void BusStore::closed(const PortClosed& closed) {
    PortClosed news = closed;
    if (news.error && news.error->problem == PortProblem::Gone) {
        m_link.unplugged = true;
        news.error->moving = movingModules(m_link);
    }
    m_link.phase = LinkPhase::Disconnected;
    m_link.readOnly = false;
    m_link.lent.reset();
    forgetChain();
    emit happened(news);
}

void BusStore::forgetChain() {
    m_link.modules.clear();
    m_link.found = 0;
    m_link.quiet = false;
    m_records.clear();
}

}  // namespace nmc
