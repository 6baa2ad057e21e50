// SPDX-License-Identifier: MIT
#include "bus/engine.h"

#include <algorithm>

#include "bus/rejoin.h"
#include "protocol/baud.h"
#include "protocol/takes.h"

namespace nmc::bus {

namespace {

/// The modules whose motors the operation stops, or sets to another position. For Stop Here, an owed stop
/// holds the present position instead.
[[nodiscard]] std::vector<ModuleIndex> stoppedBy(const Operation& operation) {
    std::vector<ModuleIndex> stopped;
    for (const Order& order : operation.orders)
        if (stopManner(order.command))
            stopped.push_back(order.module);
    return stopped;
}

/// The modules to which the operation sends anything other than gains.
[[nodiscard]] std::vector<ModuleIndex> usedBy(const Operation& operation) {
    std::vector<ModuleIndex> used;
    for (const Order& order : operation.orders)
        if (!is<servo::SetGain>(order.command))
            used.push_back(order.module);
    return used;
}

/// True if the stop that is owed is gentler.
[[nodiscard]] bool endsMore(StopManner manner, const OwedStop& owed) {
    return firmer(manner, owed.target.manner()) != owed.target.manner();
}

}  // namespace

Engine::Engine(EngineConfig config) : m_config(config), m_line(config.adapterLatency, config.margin) {}

// ---- called from outside ----

void Engine::connect(TimePoint now) {
    begin(Discovery::Start::Look, now);
}

void Engine::restart(TimePoint now) {
    begin(m_config.readOnly ? Discovery::Start::Look : Discovery::Start::Restart, now);
}

/// The known chain is kept until another one is found, because a stop must reach some module.
void Engine::begin(Discovery::Start start, TimePoint now) {
    if (!findBrd(m_config.baud)) {  // before anything is reset for it
        m_events.emplace_back(ConnectFailed{ConnectFailure::RateChange, {}, m_config.baud});
        return;
    }
    // A search that is assigning addresses continues: a new one would take the modules that have one for the
    // whole chain.
    if (start == Discovery::Start::Look && m_search.givesAddresses())
        return;
    cancelAll(Change::Kind::Search);
    if (m_stops.running()) {
        m_recovery.dropDoubt();  // the stop continues, and comes first
    } else {
        interrupt(now);
        m_recovery.reset();
        m_again.reset();
    }
    m_line.statistics() = {};
    EngineConfig config = m_config;
    config.known = knownModules();
    m_search.begin(config, start);
    m_stops.onSearchBegun();
    proceed(now);
}

void Engine::submit(Operation operation, TimePoint now) {
    if (operation.orders.empty()) {
        m_events.emplace_back(rejected(operation, Outcome::Done));
        return;
    }
    const OperationFinished refused = rejected(operation, refusal());
    if (operation.path && accepting())
        return beginPath(operation, now);
    if (operation.trial && accepting())
        return beginTrial(operation, now);
    const std::vector<ModuleIndex> stopped = stoppedBy(operation);
    const std::vector<ModuleIndex> used = usedBy(operation);
    if (stopped.size() == operation.orders.size() && (oweStops(operation) || haltAtOnce(operation, now))) {
        m_events.emplace_back(rejected(operation, Outcome::Done));
        return proceed(now);
    }
    if (!accepting() || !m_operations.submit(std::move(operation))) {
        m_events.emplace_back(refused);
        return;
    }
    leavePath(stopped);
    m_trials.leave(used);
    proceed(now);
}

/// While the chain is being searched for or is lost, stops are sent all the same: blindly, and again until
/// they are confirmed. So is one that comes during a stop of all modules, which may be gentler. Not while the
/// line is lent, nor once it is no longer known which module has which address.
bool Engine::takesStopsOnly() const {
    return !settled() && !m_config.readOnly && !lent() && !m_search.givesAddresses();
}

bool Engine::oweStops(const Operation& operation) {
    const bool stopping = m_connected && !m_search.active();
    const auto fits = [&](const Order& order) {
        return stopping ? isAsOwed(order) : m_chain.has(order.module);
    };
    if (!takesStopsOnly() || !std::ranges::all_of(operation.orders, fits))
        return false;
    for (const Order& order : operation.orders)
        if (const StopManner manner = *stopManner(order.command); !stopping || mayOwe(order.module, manner))
            m_chain.owe(order.module, StopCause::GroupStop, manner);
    return true;
}

/// The command is what an owed stop would send. Stop Here is not: it has a position of its own. Neither is a
/// stop of a servo that is off: it switches the servo on.
bool Engine::isAsOwed(const Order& order) const {
    return m_chain.has(order.module) &&
           stopFor(m_chain.belief(order.module), *stopManner(order.command)) == order.command;
}

/// A stop that would have to wait, or leave a hold of its motor behind, takes the way of a stop of a group.
/// Returns false if it may go as an operation, or is not what an owed stop sends.
bool Engine::haltAtOnce(const Operation& operation, TimePoint now) {
    if (!accepting() ||
        !std::ranges::all_of(operation.orders, [this](const Order& order) { return isAsOwed(order); }))
        return false;
    const std::vector<ModuleIndex> stopped = stoppedBy(operation);
    const bool waits = !m_operations.empty() || (m_path.active() && !m_path.isFor(stopped)) ||
                       m_recovery.resyncing() || m_recovery.wants(now) || m_restartSearch.wants(now) ||
                       m_rate.active() || m_readdress.active();
    if (!waits && std::ranges::none_of(stopped, [this](ModuleIndex module) { return m_hold.holds(module); }))
        return false;
    for (const Order& order : operation.orders)
        haltAxes({order.module}, StopCause::GroupStop, *stopManner(order.command));
    return true;
}

void Engine::beginTrial(const Operation& operation, TimePoint now) {
    if (!m_trials.begin(operation))
        m_events.emplace_back(rejected(operation, Outcome::Forbidden));
    proceed(now);
}

void Engine::keepTrial(ModuleIndex module, TimePoint now) {
    m_trials.keep(module);
    proceed(now);
}

void Engine::submit(const GroupOperation& operation, TimePoint now) {
    const auto* command = std::get_if<GroupCommand>(&operation.what);
    if (command != nullptr && isStop(command->action) && (accepting() || takesStopsOnly()))
        m_events.emplace_back(stopGroup(operation, *command));
    else if (!accepting() || !m_operations.submit(operation))
        m_events.emplace_back(GroupFinished{operation.id, refusal(), operation.what, {}, false});
    else if (command != nullptr)
        m_trials.leave(membersOf(command->group));
    proceed(now);
}

/// Stops the known members: a module whose group is unknown is stopped at its own address, or with all
/// modules.
GroupFinished Engine::stopGroup(const GroupOperation& operation, const GroupCommand& command) {
    using enum GroupCommand::Action;
    const StopManner manner = command.action == MotorOff       ? StopManner::Off
                              : command.action == StopSmoothly ? StopManner::Smoothly
                                                               : StopManner::Abruptly;
    GroupFinished finished{operation.id, Outcome::Done, operation.what, {}, false};
    std::vector<ModuleIndex> members = membersOf(command.group);
    for (const ModuleIndex member : members)
        finished.members.push_back({member, MemberOutcome::Done});
    haltAxes(members, StopCause::GroupStop, manner);
    m_stops.sendTogether(std::move(members));
    if (finished.members.empty())
        finished.outcome = Outcome::Forbidden;
    return finished;
}

/// The modules that are known to obey this group's address.
std::vector<ModuleIndex> Engine::membersOf(std::uint8_t group) const {
    std::vector<ModuleIndex> members;
    for (const Chain::Module& module : m_chain.modules()) {
        const ModuleInfo& info = module.belief.info();
        if (!module.belief.restarted() && info.group && info.group->group == group)
            members.push_back(info.index);
    }
    return members;
}

void Engine::changeRate(std::uint32_t baud, TimePoint now) {
    m_rate.begin(baud, busy() || m_stops.due());
    proceed(now);
}

void Engine::readdress(ModuleIndex module, TimePoint now) {
    m_readdress.begin(module, busy());
    proceed(now);
}

void Engine::resetModule(ModuleIndex module, TimePoint now,
                         const std::optional<servo::HardReset>& configuration) {
    if (!configuration)
        m_readdress.beginReset(module, encode(HardReset{}), busy());
    else if (m_chain.has(module) &&
             takes(m_chain.belief(module).info().identity, ServoCommand(*configuration)))
        m_readdress.beginReset(module, encode(*configuration), busy());
    else
        m_events.emplace_back(ReaddressFailed{module, ReaddressFailed::Reason::NotNow});
    proceed(now);
}

void Engine::moveTo(ModuleIndex module, BusAddress address, TimePoint now) {
    m_readdress.beginMove(module, address, busy());
    proceed(now);
}

bool Engine::busy() const {
    return !accepting() || !m_operations.empty() || m_path.active() || m_hold.active() || m_rate.active() ||
           m_readdress.active() ||
           // Gains on trial have to be watched with every poll.
           std::ranges::any_of(m_chain.modules(),
                               [](const Chain::Module& module) { return module.trial.has_value(); });
}

void Engine::hold(const HoldToMove& hold, TimePoint now) {
    if (!accepting() || !m_chain.has(hold.module) || m_path.isFor({hold.module}))
        return m_hold.refuse(hold);
    if (m_operations.swings(hold.module) && m_operations.cancelFor({hold.module}))
        dropWorkOf(m_operations);
    m_trials.leave({hold.module});
    m_hold.hold(hold, now);
    proceed(now);
}

void Engine::release(TimePoint now) {
    m_hold.release();
    proceed(now);
}

bool Engine::stopUnasked(TimePoint now) {
    if (m_config.readOnly)
        return false;
    const bool asked = m_stops.stopping();
    stopAll(now);
    if (!asked)
        m_stops.noteUnasked();
    return true;
}

void Engine::stopAll(TimePoint now) {
    if (m_lending.delays(now))
        return;
    followProgram(TimePoint::max(), now);
    cancelAll(Change::Kind::StopAll);
    m_chain.schedule().unfocus();
    m_stopAsked = true;
    if (!m_chain.empty()) {
        if (m_search.active() || !m_connected)
            m_recovery.doubtLine();
        m_stops.stopAll(now);
        interrupt(now);
    } else if (m_search.active()) {
        m_stops.stopAllAfterSearch(now);
    } else {
        m_stops.stopAll(now);  // no module is known that could be stopped, and StopFinished reports that
    }
    proceed(now);
}

bool Engine::lend() {
    if (lent() || busy() || m_stops.due() || anythingMoves())
        return false;
    cancelAll(Change::Kind::Cancelled);
    m_recovery.reset();
    m_connected = false;
    m_lending.begin();
    return true;
}

bool Engine::hearsForProgram() const {
    const auto isProgram = [](const Work& work) { return work.ask.purpose == Purpose::Lent; };
    return passes() && (m_works.empty() ? !m_line.busy() : std::ranges::all_of(m_works, isProgram));
}

void Engine::onProgram(ByteSpan bytes, TimePoint now) {
    if (!passes())
        return;
    const ByteSpan passed = bytes.first(m_lending.passing(bytes));
    const TimePoint end = m_line.pass(passed, now);
    const bool incomplete = m_lending.onPassed(passed, m_line.timing().byteTime, end);
    followProgram(now, now);
    if (m_lending.cutBy() && !incomplete)
        return stopAll(now);
    proceed(now);
}

/// What the program sends by this time begins exchanges, and ends those before.
void Engine::followProgram(TimePoint by, TimePoint now) {
    while (const auto passed = m_lending.takePassed(by)) {
        if (!passed->whole) {
            m_line.overlook(passed->bytes, now);
            continue;
        }
        m_line.conclude(now);
        takeEnds(now);
        const PacketBytes packet{ByteSpan(passed->bytes)};
        const TimePoint latched = passed->start + m_line.timing().bytes(packet.size()) + kServoTick / 2;
        auto ask = m_lending.follow(packet, latched);
        if (!ask) {
            m_line.overlook(packet, now);
            continue;
        }
        Work work{std::move(*ask), &m_lending, 0, {}, now};
        if (work.ask.module) {
            work.before = m_chain.at(*work.ask.module);
            if (work.ask.command)
                m_chain.noteSent(*work.ask.module, *work.ask.command, latched);
        }
        m_line.overhear(work.ask.request, packet, passed->start, now);
        m_works.push_back(std::move(work));
    }
}

void Engine::onProgramRate(std::uint32_t baud) {
    if (passes())
        m_line.passRate(baud);
}

void Engine::letThrough(TimePoint now) {
    if (!m_lending.heldOff() || m_stops.stopping())
        return;
    interrupt(now);
    for (Chain::Module& module : m_chain.modules())
        module.owed.reset();
    m_recovery.reset();
    m_lending.begin();
}

void Engine::takeBack(TimePoint now) {
    const bool stops = m_lending.cutBy().has_value();
    followProgram(TimePoint::max(), now);
    interrupt(now);
    m_stops.onRenumbering();
    m_lending.end();
    // A stop that is under way goes on with the modules that are left, by their new numbers.
    if (stops || (m_lending.takeChanged() && m_stops.stopping()))
        stopAll(now);
}

void Engine::distrust(TimePoint now) {
    if (!m_connected || m_search.active() || m_chain.empty())
        return;
    if (!m_stops.running())  // a stop is not delayed by any doubt
        interrupt(now);
    m_recovery.distrust();
    proceed(now);
}

void Engine::watch(const std::vector<ModuleIndex>& modules) {
    m_watched = modules;
    m_chain.schedule().watch(modules);
}

void Engine::setStopOutputs(const std::vector<StopOutputs>& outputs) {
    m_stopOutputs = outputs;
    setForAll([&](Chain::Memory& module) {
        const std::size_t index = module.belief.info().index.value();
        module.belief.setStopOutputs(index < outputs.size() ? outputs[index] : StopOutputs{});
    });
}

void Engine::setTravelLimits(const std::vector<TravelLimits>& limits) {
    setForAll([&](Chain::Memory& module) {
        const std::size_t index = module.belief.info().index.value();
        module.travel.setLimits(index < limits.size() ? limits[index] : TravelLimits{});
    });
}

/// Also where the state before a command in flight is kept, which applies again if the module refuses it.
template <typename Set>
void Engine::setForAll(Set set) {
    for (Chain::Module& module : m_chain.modules())
        set(module);
    for (Work& work : m_works)
        if (work.before)
            set(*work.before);
}

void Engine::focus(std::optional<ModuleIndex> module, TimePoint now) {
    if (module && settled() && !m_path.active())  // a path needs all modules polled
        m_chain.schedule().focus(*module, now);
    else
        m_chain.schedule().unfocus();
}

void Engine::onBytes(ByteSpan bytes, TimePoint now) {
    if (m_line.onBytes(bytes, now))
        m_recovery.onByte();
    proceed(now);
}

void Engine::onDeadline(TimePoint now) {
    m_line.onDeadline(now);
    m_hold.expire(now);
    followProgram(now, now);
    if (m_lending.cutBy() && now >= *m_lending.cutBy())
        return stopAll(now);
    proceed(now);
}

std::optional<TimePoint> Engine::nextDeadline() const {
    const auto always = earliest(
        {m_line.deadline(), m_hold.expiry(), m_path.foreseeAt(), m_lending.due(), m_lending.cutBy()});
    if (!m_line.idle())
        return always;
    const auto onFreeLine = earliest({always, m_stops.due(), lent() ? std::nullopt : m_wellAgain.due()});
    if (!m_connected)
        return onFreeLine;
    return earliest({onFreeLine, m_trials.due(), m_path.due(), m_operations.due(), m_polls.due()});
}

std::vector<UnconfirmedStop> Engine::unconfirmedStops() const {
    std::vector<UnconfirmedStop> stops = m_config.unconfirmed;
    for (const Chain::Module& module : m_chain.modules())
        if (module.owed && !module.owed->target.stopped())
            stops.push_back({module.belief.info(), module.owed->target.manner()});
    return stops;
}

// ---- dispatch ----

void Engine::proceed(TimePoint now) {
    m_path.foresee(now);
    stopPath();
    // An owed stop does not wait for a quarantine.
    if (m_recovery.resyncing() && m_stops.anyUnsent(now))
        interrupt(now);
    do
        takeEnds(now);
    while (m_line.ready() && dispatch(now));
}

/// All priorities are defined here, in order. Returns false if there is nothing to do.
bool Engine::dispatch(TimePoint now) {
    if (m_line.idle())
        m_recovery.onFree();
    m_stopAsked = m_stopAsked && (m_stops.stopping() || m_stops.due());
    if (m_config.readOnly && m_stopAsked)
        m_line.permit(Line::Permit::QuestionsAndStops, m_chain.outputStops());
    else if (m_config.readOnly)
        m_line.permit(Line::Permit::Questions);
    const bool live = m_connected || m_search.active();
    Turn taken = Turn::Free;
    const auto offer = [&](bool may, auto&... tasks) {
        ((taken = may && taken == Turn::Free ? take(tasks, now) : taken), ...);
    };
    if (lent()) {
        offer(m_lending.heldOff(), m_lending, m_stops);
        takeFindings(now);
        return taken == Turn::Taken;
    }
    offer(true, m_wayBack);
    // A servo that swings is not seen at rest before its gains are restored.
    offer(m_stops.allSent() && !m_search.active(), m_trials);
    offer(true, m_stops);
    if (taken == Turn::Free)
        taken = repeat(true, now);
    offer(live, m_recovery, m_restartSearch);
    if (taken == Turn::Free)
        taken = repeat(false, now);
    offer(live, m_search, m_rate, m_readdress);
    // Also once the link has been given up: the gains from before are part of its stop.
    offer(!m_search.active(), m_trials);
    // Operations submitted for the module before a hold come first: a stop sent after the start would end the
    // motion while the hold considers it running.
    offer(live && !(m_hold.active() && m_operations.concerns(m_hold.module())), m_hold);
    offer(live, m_path, m_operations);
    offer(!m_search.active(), m_wellAgain);
    offer(live, m_polls);
    takeFindings(now);
    return taken == Turn::Taken;
}

Engine::Turn Engine::take(Task& task, TimePoint now) {
    if (!task.wants(now))
        return Turn::Free;
    // While the previous reply may still turn out to have surplus bytes, only an ordinary exchange may begin.
    if (!m_line.idle() && !task.pipelines())
        return Turn::Waits;
    Next next = task.next(now);
    if (std::holds_alternative<Idle>(next))
        return Turn::Free;
    if (auto* script = std::get_if<Line::Script>(&next))
        m_line.run(std::move(*script), now);
    else if (auto* ask = std::get_if<Ask>(&next))
        send({std::move(*ask), &task, 0, {}, {}}, now);
    return Turn::Taken;
}

Engine::Turn Engine::repeat(bool atOnce, TimePoint now) {
    if (m_again && m_again->task == &m_trials && m_trials.isOver(m_again->ask))
        m_again.reset();
    if (!m_again || m_again->ask.repeatAtOnce != atOnce)
        return Turn::Free;
    if (!m_line.idle())
        return Turn::Waits;
    if (atOnce)
        if (auto nulls = m_recovery.flush()) {
            m_line.run(std::move(*nulls), now);
            return Turn::Taken;
        }
    send(*std::exchange(m_again, std::nullopt), now);
    return Turn::Taken;
}

void Engine::send(Work work, TimePoint now) {
    const Ask& ask = work.ask;
    if (ask.module && ask.command) {
        const TimePoint latched = m_line.latchTime(ask.request.payload.data.size() + 4, now);
        work.before = m_chain.at(*ask.module);
        m_chain.noteSent(*ask.module, *ask.command, latched);
    }
    if (ask.retry)
        ++m_line.statistics().retries;
    m_line.begin(ask.request, now);
    work.sent = now;
    m_works.push_back(std::move(work));
}

// ---- consequences for all tasks ----

void Engine::takeFindings(TimePoint now) {
    stopPath();
    if (m_lending.takeChanged() && m_stops.stopping())
        m_stops.stopAll(now);  // of the modules as they are known by now
    m_trials.noteLosses();
    if (m_search.takeGivesAddresses()) {
        m_trials.forgetAll();
        m_chain.forgetStates();
    }
    if (auto ended = m_search.takeEnded())
        onSearchEnded(std::move(*ended), now);
    const Recovery::Findings findings = m_recovery.takeFindings();
    if (findings.lost)
        m_restartSearch.onLost();
    const bool inVain =
        m_again && m_again->ask.module && (findings.allLost || m_again->ask.module == findings.lost);
    if (inVain)  // it will not be answered
        deliver(*std::exchange(m_again, std::nullopt), ReplyEnd{}, now);
    if (findings.allLost)
        onLinkLost();
    for (const Recovery::GivenUp& what : findings.givenUp)
        giveUp(what, now);
    if (m_restartSearch.takeQuiet())
        goQuiet(now);
    if (m_wellAgain.takeWell())
        m_connected ? reinstate(now) : begin(Discovery::Start::Look, now);
    if (m_connected && m_line.echoes() && !std::exchange(m_echoReported, true))
        m_events.emplace_back(EchoNoticed{});
    if (m_line.takeForeign(now) && m_connected && !m_search.active())
        onForeignTraffic();
    for (const GroupMember& member : m_operations.takeHalfStarted())
        haltAxes({member.module}, StopCause::GroupHalfStarted, StopManner::Abruptly);
}

void Engine::onSearchEnded(SearchTask::Ended ended, TimePoint now) {
    if (const auto* found = std::get_if<ChainFound>(&ended.result)) {
        adopt(*found, ended.discovery, now);
    } else {
        m_connected = false;
        for (const Chain::Module& module : m_chain.modules())
            m_chain.schedule().lose(module.belief.info().index, now);
        // Any module that was seen at all can be sent a stop.
        if (m_stops.waits())
            m_chain = Chain(ended.discovery.modules(), m_line.baud(), m_config.readOnly);
        auto failed = std::get<ConnectFailed>(std::move(ended.result));
        if (failed.reason == ConnectFailure::NobodyAnswers && m_line.echoes())
            failed.reason = ConnectFailure::Echo;
        m_events.emplace_back(std::move(failed));
    }
    m_stops.onSearchOver(now);
}

/// The modules of the present chain, or of the chain last used at this port.
std::vector<ModuleInfo> Engine::knownModules() const {
    return m_chain.empty() ? m_config.known : m_chain.infos();
}

void Engine::adopt(ChainFound found, const Discovery& discovery, TimePoint now) {
    const std::vector<ModuleInfo> known = knownModules();
    found.readOnly = m_config.readOnly;
    found.replyGap = m_line.replyGap();
    const std::vector<ModuleInfo> seen = found.modules;
    const auto unaddressed = discovery.unaddressedIdentity();
    auto rejoined = found.attached ? rejoin(known, seen, unaddressed) : std::nullopt;
    if (rejoined && unaddressed && !m_chain.empty()) {
        rejoined->restarted = m_chain.restartedOf(rejoined->absent);
        if (rejoined->restarted && m_chain.belief(*rejoined->restarted).info().identity != *unaddressed)
            rejoined->restarted.reset();
    }
    if (rejoined) {
        found.modules = rejoined->modules;
        found.absent = rejoined->absent;
    }
    const Chain before = std::exchange(m_chain, Chain(found.modules, found.baud, found.readOnly));
    const auto knownBefore = [&](const ModuleInfo& info) -> const Chain::Module* {
        const auto same = std::ranges::find_if(before.modules(), [&](const Chain::Module& old) {
            return sameModule(old.belief.info(), info) && !old.belief.restarted();
        });
        return found.attached && same != before.modules().end() ? &*same : nullptr;
    };
    m_connected = true;
    m_recovery.reset();
    m_line.statistics() = {};  // the silence at the end of the chain was not an error
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleInfo info = module.belief.info();
        if (const Chain::Module* old = knownBefore(info)) {
            static_cast<Chain::Memory&>(module) = *old;
            module.belief.foundAgain(info.index);
            found.modules[info.index.value()].group = module.belief.info().group;
        } else if (found.attached) {
            module.attach();
        }
        if (isKnown(info.identity) && !found.readOnly)
            module.belief.onExecuted(ServoCommand(DefineStatus{standingItems(info.identity)}));
    }
    setStopOutputs(m_stopOutputs);
    m_chain.schedule().watch(m_watched);
    if (!found.readOnly)
        for (const UnconfirmedStop& stop : std::exchange(m_config.unconfirmed, {}))
            for (const ModuleInfo& info : found.modules)
                if (found.attached && sameModule(info, stop.module))
                    m_chain.owe(info.index, StopCause::ConnectionEnded, stop.manner);
    for (const Chain::Module& module : m_chain.modules())
        if (module.owed)
            found.commandedToStop.push_back(module.belief.info().index);
    m_events.emplace_back(found);
    for (const ModuleIndex module : found.absent) {
        if (rejoined->restarted == module)
            m_restartSearch.setRestarted(module, now);
        else
            m_recovery.lose(module, now);
        if (before.has(module) && before.schedule().sought(module))
            m_chain.schedule().noteSought(module);
    }
    if (!found.unaddressed)
        m_chain.schedule().noteSought();
    for (const Discovery::Heard& answer : discovery.heard())
        for (const ModuleInfo& info : found.modules)
            if (info.address == seen[answer.module.value()].address)
                takeHeard(info.index, answer.end);
    // A stop owed to a module that was found where it was remains owed; a module that was reset is off.
    if (!found.attached)
        return;
    m_trials.rejoin(before);
    for (const Chain::Module& module : before.modules())
        for (const ModuleInfo& info : found.modules)
            if (module.owed && info.address == module.belief.info().address)
                m_chain.owe(info.index, module.owed->cause, module.owed->target.manner());
}

/// Takes one of the replies that the search received from the module.
void Engine::takeHeard(ModuleIndex index, const ReplyEnd& end) {
    Chain::Module& module = m_chain.at(index);
    if (module.plausibility.check(end))
        return;
    if (const auto trusted = module.trust.confirm(end.report)) {
        module.belief.onStatus(*trusted, end.latched);
        publish(index, end, *trusted);
    }
}

void Engine::haltAxes(const std::vector<ModuleIndex>& modules, StopCause cause, StopManner manner) {
    notify({Change::Kind::Stopped, modules});
    for (const ModuleIndex module : modules)
        if (mayOwe(module, manner))
            m_chain.owe(module, cause, manner);
}

bool Engine::mayOwe(ModuleIndex module, StopManner manner) const {
    const auto& owed = m_chain.at(module).owed;
    return !owed || ofOperator(owed->cause) || endsMore(manner, *owed);
}

/// It is unknown which commands of the two hosts were lost, so what was requested here does not continue.
void Engine::onForeignTraffic() {
    ForeignTraffic event;
    for (const Chain::Module& module : m_chain.modules())
        if (module.ownMotion.commanded() && (module.belief.moving() || !module.belief.fresh()))
            event.commandedToStop.push_back(module.belief.info().index);
    haltAxes(event.commandedToStop, StopCause::ForeignTraffic, StopManner::Abruptly);
    cancelAll(Change::Kind::Cancelled);
    m_events.emplace_back(std::move(event));
}

/// Commands may still get through (faults.md F-11). Nothing continues when they are answered again.
void Engine::onLinkLost() {
    std::vector<ModuleIndex> stopped;
    for (const Order& stop : m_chain.stops())
        stopped.push_back(stop.module);
    notify({Change::Kind::Stopped, stopped});
    for (const Order& stop : m_chain.stops())
        if (!m_chain.at(stop.module).owed)
            m_chain.owe(stop.module, StopCause::LinkGivenUp);
}

void Engine::giveUp(const Recovery::GivenUp& what, TimePoint now) {
    if (!what.module) {
        goQuiet(now);
        return m_wellAgain.begin(true, now);
    }
    // The module is stopped and no longer queried; the others continue.
    haltAxes({*what.module}, StopCause::LinkGivenUp, StopManner::Abruptly);
    m_recovery.dropDoubt(*what.module);
    m_recovery.lose(*what.module, now);
    m_chain.schedule().retire(*what.module);
    m_wellAgain.begin(false, now);
}

/// Reinstates the modules that were given up because of errors, and have answered without any since.
void Engine::reinstate(TimePoint now) {
    for (Chain::Module& module : m_chain.modules()) {
        const ModuleIndex index = module.belief.info().index;
        if (!m_chain.schedule().retired(index) || module.belief.restarted())
            continue;
        module.health = {};
        m_chain.schedule().recover(index, now);
        m_chain.hurryOwedStop(index, now);
        m_events.emplace_back(HealthChanged{LinkHealth::Good, 0, 0, index});
        m_events.emplace_back(ModuleUnresponsive{index, false});
    }
}

/// Stops all motors, where this connection is responsible for them, after which nothing is queried any more.
void Engine::goQuiet(TimePoint now) {
    m_connected = false;
    cancelAll(Change::Kind::GivenUp);
    m_again.reset();
    if (!m_stops.stopping() && !m_config.readOnly) {
        m_stops.stopAll(now);
        m_stops.noteUnasked();
    }
}

void Engine::notify(const Change& change) {
    for (Task* task : m_tasks)
        if (task->onChange(change))
            dropWorkOf(*task);
}

/// Nothing pending is begun any more, a motor that is held is owed its stop, and gains that are being tried
/// are restored.
void Engine::cancelAll(Change::Kind why) {
    if (m_again && m_again->task != &m_search)
        m_again.reset();
    notify({why});
}

void Engine::dropWorkOf(const Task& task) {
    if (m_again && m_again->task == &task)
        m_again.reset();
    for (Work& work : m_works)
        if (work.task == &task)
            work.task = nullptr;
    if (m_ending != nullptr && m_ending->task == &task)
        m_ending->task = nullptr;
}

/// Drops what is in flight. It remains open whether its command was carried out; the belief already allows
/// for both.
void Engine::interrupt(TimePoint now) {
    for (const Work& work : m_works)
        m_recorder.addAbandoned(work.ask, work.sent, now);
    m_line.abandon(now);
    m_works.clear();
    if (m_search.active())
        m_again.reset();
    notify({Change::Kind::Interrupted});
}

// ---- end of an exchange: whether it is believed, repeated, and reported ----

void Engine::takeEnds(TimePoint now) {
    while (auto end = m_line.takeEnd()) {
        onEnd(std::move(*end), now);
        takeFindings(now);
    }
    const bool connects = m_search.active() || m_rate.active();
    m_recorder.addUnanswered(passes()               ? Purpose::Lent
                             : connects             ? Purpose::Connect
                             : m_operations.empty() ? Purpose::Stop
                                                    : Purpose::Operation);
}

void Engine::onEnd(ReplyEnd end, TimePoint now) {
    Work work = std::move(m_works.front());
    m_works.pop_front();
    m_ending = &work;
    conclude(work, end, now);
    m_ending = nullptr;
}

/// What the answer shows may halt a module: the task then no longer waits for this end.
void Engine::conclude(Work& work, ReplyEnd& end, TimePoint now) {
    examine(work.ask, end);
    m_recorder.add(work.ask, end);
    count(end);
    if (m_connected)
        noteHealth(work.ask, end, now);
    const bool right = end.result == ReplyResult::Accepted;
    if (work.ask.believed && (right || !work.ask.handlesFailure))
        learn(work, end);
    if (work.ask.handlesFailure)
        return deliver(work, end, now);
    if (work.ask.reported && !right && end.result != ReplyResult::Refused)
        m_chain.noteUnanswered(*work.ask.module, end.latched);
    if (passes())
        return deliver(work, end, now);  // whatever follows is the program's affair
    if (unanswered(end.result))
        if (Line::Script script = m_recovery.onUnanswered(work.ask, end); !script.empty())
            m_line.run(std::move(script), now);
    if (repeats(work, end)) {
        ++m_line.statistics().retries;
        m_again = std::move(work);
        return;
    }
    deliver(work, end, now);
}

/// Rejects a reply that is implausible although its sum is right.
void Engine::examine(const Ask& ask, ReplyEnd& end) {
    if (end.result == ReplyResult::Refused && uniform({end.bytes.data(), end.bytes.size()}))
        end.rejection = Rejection::Uniform;
    else if (end.result == ReplyResult::Accepted && ask.module)
        end.rejection = m_chain.at(*ask.module).plausibility.check(end);
    if (end.rejection)
        end.result = ReplyResult::Rejected;
}

void Engine::count(const ReplyEnd& end) {
    LinkStatistics& statistics = m_line.statistics();
    if (end.rejection)
        ++statistics.rejections[static_cast<std::size_t>(*end.rejection)];
    switch (end.result) {
        case ReplyResult::Accepted:
            ++statistics.answered;
            statistics.roundTripSum += end.arrived - end.sent;
            statistics.roundTripMax = std::max(statistics.roundTripMax, end.arrived - end.sent);
            statistics.wireTime += end.wireTime;
            return;
        case ReplyResult::Refused:
            ++statistics.refused;
            return;
        case ReplyResult::Unresponsive:
        case ReplyResult::Partial:
            ++statistics.timeouts;
            return;
        case ReplyResult::BadChecksum:
            ++statistics.badChecksum;
            return;
        case ReplyResult::Rejected:
            ++statistics.rejected;
            return;
        case ReplyResult::Abandoned:
        case ReplyResult::NotAsked:
            return;
    }
}

/// Every exchange that expects an answer fills or empties the buckets. Silence does so only once its module
/// answers again; until then the module counts as missing, and is reported as such.
void Engine::noteHealth(const Ask& ask, const ReplyEnd& end, TimePoint now) {
    const bool right = end.result == ReplyResult::Accepted;
    if (!ask.module || (!right && end.bytes.empty()))
        return;
    for (const Recovery::GivenUp& what : m_recovery.note(*ask.module, right))
        giveUp(what, now);
}

/// Uses up one retry, if the retry table allows one.
bool Engine::repeats(Work& work, const ReplyEnd& end) {
    if (end.result == ReplyResult::Accepted || work.task == nullptr)
        return false;
    const bool over = work.task == &m_trials && m_trials.isOver(work.ask);
    if (end.result == ReplyResult::Refused) {
        ++work.refusals;
        const auto attempt = static_cast<std::uint8_t>(work.refusals + work.ask.refusedBefore);
        if (work.ask.module)
            m_events.emplace_back(CommandRefused{*work.ask.module, attempt});
        return !over && work.refusals < work.ask.refusedAttempts;
    }
    if (over || work.ask.silentRepeats == 0)
        return false;
    --work.ask.silentRepeats;
    return true;
}

void Engine::deliver(const Work& work, const ReplyEnd& end, TimePoint now) {
    if (work.task == nullptr)
        return;
    if (Line::Script script = work.task->onEnd(work.ask, end, now); !script.empty() && m_line.idle())
        m_line.run(std::move(script), now);
}

void Engine::learn(const Work& work, const ReplyEnd& end) {
    const Ask& ask = work.ask;
    if (!ask.module || unanswered(end.result))
        return;
    Chain::Module& module = m_chain.at(*ask.module);
    if (end.result == ReplyResult::Refused) {
        module.trust.interrupt();
        if (work.before)
            static_cast<Chain::Memory&>(module) = *work.before;
        // The load that is waiting is not the one requested.
        if (ask.command &&
            (is<servo::LoadTrajectory>(*ask.command) || is<stepper::LoadTrajectory>(*ask.command)))
            module.belief.forgetLoad();
        return;
    }
    // The status comes first: the reply to a command does not yet show the command's effect.
    // A program that always asks for the same items would never be believed to have stopped its motor.
    const auto trusted =
        ask.purpose == Purpose::Lent ? std::optional(end.report) : module.trust.confirm(end.report);
    if (trusted)
        module.belief.onStatus(*trusted, end.latched);
    if (ask.command) {
        module.belief.onExecuted(*ask.command, &end.report);
        module.plausibility.onAnswered(*ask.command);
    }
    if (ask.command && is<servo::SetGain>(*ask.command) && work.task != &m_trials)
        m_trials.forget(*ask.module);
    if (work.task != nullptr)
        work.task->onAnswer(ask, end);
    if (trusted) {
        m_path.onReport(*ask.module, end);
        m_trials.onReport(*ask.module, *trusted, end.latched);
    }
    if (ask.reported)
        m_events.emplace_back(CommandExecuted{*ask.module, end.latched, *ask.command, end.late,
                                              m_chain.takeUnanswered(*ask.module, end.latched),
                                              work.task == &m_trials});
    if (ask.request.payload.code == CommandCode::SetAddress)
        m_events.emplace_back(GroupChanged{*ask.module, module.belief.info().group});
    if (trusted && ask.purpose == Purpose::Poll)
        m_operations.notePoll(*ask.module, end);
    // A late reply that is taken for the answer to a stop must not be shown, nor be a reason for another
    // stop.
    if (trusted && (ask.purpose == Purpose::Lent || !m_recovery.quarantineDue()))
        publish(*ask.module, end, *trusted);
}

void Engine::publish(ModuleIndex module, const ReplyEnd& end, const StatusReport& trusted) {
    Chain::Module& known = m_chain.at(module);
    m_events.emplace_back(Sample{module, end.latched, trusted, end.late, end.report.status,
                                 known.plausibility.takeJump(), known.unanswered.has_value()});
    if (m_config.readOnly || lent())
        return;  // whatever moves there is for others to start and to stop
    // On an attached chain, a motor may move at will; its velocity shows it.
    const bool mayMove = known.belief.mayMove() && !known.belief.pwmUnknown();
    if (known.ownMotion.onReport(end.report, end.latched, mayMove))
        m_events.emplace_back(ForeignMotion{module, trusted.position.value_or(0)});
    // A stop that is owed already does as well, unless this one has to be firmer.
    if (const auto manner = known.travel.onReport(trusted, end.latched, known.belief);
        manner && (!known.owed || endsMore(*manner, *known.owed))) {
        m_events.emplace_back(StoppedBeforeLimit{module});
        haltAxes({module}, StopCause::TravelLimit, *manner);
    }
    const auto reason = known.watch.onReport(trusted, end.latched, known.belief.servoRegisters().servoRate);
    if (!reason)
        return;
    m_events.emplace_back(MotionSuspect{module, *reason, trusted.position.value_or(0)});
    // A motor that runs the wrong way would continue with its servo on.
    const bool off = *reason == MotionSuspect::Reason::WrongWay || !m_chain.belief(module).on();
    haltAxes({module}, StopCause::MotionSuspect, off ? StopManner::Off : StopManner::Abruptly);
}

// ---- paths: their beginning, and stops at their end ----

void Engine::beginPath(const Operation& operation, TimePoint now) {
    const auto motion = [&](const PathAxis& axis) {
        return m_hold.holds(axis.module) || m_operations.swings(axis.module);
    };
    const auto& axes = operation.path->axes;
    if (std::ranges::any_of(axes, motion) || !m_path.begin(operation)) {
        m_events.emplace_back(rejected(operation, Outcome::Forbidden));
    } else {
        m_chain.schedule().unfocus();
        for (const PathAxis& axis : axes)
            m_trials.leave({axis.module});
    }
    proceed(now);
}

void Engine::leavePath(const std::vector<ModuleIndex>& stopped) {
    if (!m_path.isFor(stopped))
        return;
    m_path.overtake(stopped);
    dropWorkOf(m_path);
}

void Engine::stopPath() {
    m_path.noteSilence();
    PathTask::Stops stops = m_path.takeStops();
    if (stops.modules.empty())
        return;
    dropWorkOf(m_path);
    for (const ModuleIndex module : stops.modules)
        m_chain.owe(module, StopCause::PathEnded, stops.manner);
    m_stops.sendTogether(std::move(stops.modules));
}

}  // namespace nmc::bus
