// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/apicontroller.h"

#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

#include "app/news.h"
#include "base/enumname.h"
#include "base/overloaded.h"
#include "link/clock.h"
#include "model/api/apistate.h"
#include "model/intent/jog.h"
#include "model/module/modulescale.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"

namespace nmc {

namespace {

constexpr qsizetype kLongestName = 60;
constexpr Duration kStillHeld = std::chrono::milliseconds(250);  ///< a jog after that is another press
constexpr std::size_t kMostWaits = 64;   ///< pending, of one client; and as many that are held back
constexpr qsizetype kLongestCall = 120;  ///< characters of it in a message

// Codes of JSON-RPC 2.0, and ours.
constexpr int kParseError = -32700, kInvalidRequest = -32600, kNoMethod = -32601, kBadParameters = -32602;
constexpr int kRefused = -32000, kNoControl = -32001, kNotGreeted = -32002;

[[nodiscard]] int codeOf(api::Problem::Kind kind) {
    switch (kind) {
        case api::Problem::Kind::NotJson:
            return kParseError;
        case api::Problem::Kind::InvalidRequest:
            return kInvalidRequest;
        case api::Problem::Kind::NoMethod:
            return kNoMethod;
        case api::Problem::Kind::FieldMissing:
        case api::Problem::Kind::FieldWrong:
        case api::Problem::Kind::AxisUnknown:
        case api::Problem::Kind::AxisAmbiguous:
        case api::Problem::Kind::SequenceUnknown:
            return kBadParameters;
        case api::Problem::Kind::NotAnOutput:
        case api::Problem::Kind::OutputsUnknown:
        case api::Problem::Kind::Refused:
            break;
    }
    return kRefused;
}

}  // namespace

ApiController::ApiController(const BusStore& store, BusWorker& worker, Connection& connection,
                             Commander& commander)
    : m_store(store), m_worker(worker), m_connection(connection), m_commander(commander) {
    connect(&m_server, &ApiServer::received, this, &ApiController::read);
    connect(&m_server, &ApiServer::vanished, this, &ApiController::gone);
    connect(&m_server, &ApiServer::overflowed, this, [this](Client client) {
        fail(client, {}, kParseError, QStringLiteral("A line is longer than 64 KiB."), "LineTooLong");
        m_server.cutOff(client);
    });
    connect(&m_server, &ApiServer::clientsChanged, this, &ApiController::showPrograms);
    connect(&m_store, &BusStore::linkChanged, this, &ApiController::follow);
    connect(&m_commander, &Commander::refused, this,
            [this](ModuleIndex, Refusal refusal, const Intent&) { m_refused = refusal; });
    connect(&m_commander, &Commander::aboutToMove, this,
            [this](bus::OperationId operation, const std::vector<ModuleIndex>& modules) {
                for (const ModuleIndex module : modules)
                    if (m_calling)
                        m_pending[module] = operation;
            });
    connect(&m_commander.sequences(), &SequenceController::refused, this,
            [this](const std::vector<SequenceProblem>& problems) {
                m_notBegun = texts::sequenceProblem(problems.front());
            });
    connect(&m_store, &BusStore::happened, this, [this](const StoreEvent& event) {
        endJogs(event);
        if (const auto* finished = std::get_if<bus::OperationFinished>(&event))
            noteFinished(*finished);
        // Nor may it go on if the panel itself has stopped the motors.
        if (std::holds_alternative<bus::StopFinished>(event)) {
            m_stopping = false;
            endControl(texts::ControlLost::Stopped);
            answerWaits();
        }
    });
    connect(&m_commander.sequences(), &SequenceController::reported, this, &ApiController::noteSequence);
    connect(&m_commander.procedures(), &ProcedureController::reported, this, &ApiController::noteEnded);
}

// ---- the socket ----

void ApiController::letIn(bool on) {
    m_on = on;
    m_tried.clear();
    if (on) {
        listen();
    } else {
        m_server.close();
        emit ended(QStringLiteral("api"));
    }
    showPrograms();
}

void ApiController::listen() {
    const LinkState& link = m_store.link();
    if (!m_on || link.port.empty())
        return;
    const QString port = link.simulated ? QStringLiteral("simulator") : QString::fromStdString(link.port);
    if (m_tried == port)
        return;
    m_tried = port;
    if (const auto opened = m_server.listen(ApiServer::pathFor(port)); !opened)
        emit reported(texts::apiClosed(opened.error()));
    else
        emit ended(QStringLiteral("api"));
    showPrograms();
}

/// Everything that follows from a change of the chain.
void ApiController::follow() {
    m_stateText.clear();
    listen();
    goOn();  // without a chain, what is held back is refused as it would be now
    const LinkState& link = m_store.link();
    if (whyNoChain(link)) {
        m_stopping = false;
        m_pending.clear();
        m_doneAt.clear();
        endControl(texts::ControlLost::Disconnected);
    }
    if (link.lent || !link.hasChain())
        for (auto& [client, session] : m_sessions)
            session.requests.clearMoved();
    answerWaits();
}

void ApiController::showPrograms() {
    m_stateText.clear();  // it names the program in control
    ProgramsShown shown{.on = m_on, .path = socket(), .failed = !m_tried.isEmpty() && !m_server.isOpen()};
    for (const auto& [client, session] : m_sessions)
        shown.connected += session.program.isEmpty() ? 0 : 1;
    if (m_control)
        shown.inControl = session(*m_control).program;
    emit changed(shown);
}

void ApiController::gone(Client client) {
    const auto found = m_sessions.find(client);
    if (found == m_sessions.end())
        return;
    const Session session = std::move(found->second);
    m_sessions.erase(found);
    m_feed.forget(client);
    if (m_asked && m_asked->client == client) {
        m_asked.reset();
        emit askingEnded();
    }
    if (m_control == client) {
        m_heldBack.clear();
        m_control.reset();
    }
    bool stops = false;
    if (!session.finishes) {
        if (session.requests.runsSequence() && m_commander.sequences().running()) {
            m_commander.sequences().stop();
            stops = true;
        }
        for (const ModuleIndex module : session.requests.moved())
            if (!rests(module))
                stops |= m_commander.stop(module);
    }
    if (!session.program.isEmpty())
        emit reported(texts::programGone(session.program, stops));
    showPrograms();
}

// ---- calls ----

void ApiController::read(Client client, const QByteArray& line) {
    m_sessions.try_emplace(client);
    const auto request = api::readRequest({line.data(), static_cast<std::size_t>(line.size())});
    if (!request)
        return refuse(client, request.error().id, request.error().problem);
    call(client, *request->method, request->parameters, request->id);
}

void ApiController::call(Client client, const api::Method& method, const Json& parameters, const Json& id) {
    const std::string& name = method.name;
    if (name == "hello")
        return greet(client, parameters, id);
    if (name == "stop")
        return stop(client, method, parameters, id);
    if (session(client).program.isEmpty())
        return fail(client, id, kNotGreeted, texts::helloFirst(), "HelloFirst");
    if (method.access != api::Access::Read)
        return command(client, method, parameters, id);
    if (name == "describe")
        return answer(client, id, api::describe());
    if (name == "subscribe") {
        m_feed.subscribe(client, parameters);
        return answer(client, id, Json::object());
    }
    if (name == "request_control")
        return ask(client, parameters, id);
    if (name == "release_control") {
        if (m_control == client) {
            cancelHeldBack({});
            m_control.reset();
            showPrograms();
        }
        return answer(client, id, Json::object());
    }
    // "state" and "wait"
    std::optional<ModuleIndex> module;
    if (parameters.contains("axis")) {
        const auto axis = api::axisOf(parameters, m_store.link(), m_store.machine());
        if (!axis)
            return refuse(client, id, axis.error());
        module = *axis;
    }
    if (name == "state")
        return module ? answer(client, id, stateOf(module)) : answerText(client, id, stateText());
    if (session(client).waits.size() >= kMostWaits)
        return failTooMany(client, id);
    session(client).waits.push_back({id, module, {}});
    answerWaits();
}

void ApiController::greet(Client client, const Json& parameters, const Json& id) {
    const QString theirs = QString::fromStdString(parameters.at("protocol").get<std::string>());
    const QString ours = QLatin1String(api::kProtocol);
    if (theirs.section(QLatin1Char('.'), 0, 0) != ours.section(QLatin1Char('.'), 0, 0))
        return fail(client, id, kNotGreeted, texts::otherProtocol(theirs, ours), "OtherProtocol");
    const QString name =
        QString::fromStdString(parameters.at("program").get<std::string>()).simplified().left(kLongestName);
    const bool first =
        std::exchange(session(client).program, name.isEmpty() ? QStringLiteral("?") : name).isEmpty();
    answer(client, id,
           {{"protocol", api::kProtocol},
            {"program", "NMC Panel " NMC_VERSION},
            {"chain", stateOf({})},
            {"capabilities", Json::array({"control", "subscribe", "samples"})},
            {"asks_user", !m_grantsUnasked}});
    if (first)
        emit reported(texts::programConnected(session(client).program));
    showPrograms();
}

// ---- the right to move motors ----

void ApiController::ask(Client client, const Json& parameters, const Json& id) {
    const std::string mode = parameters.value("on_disconnect", "stop");
    if (mode != "stop" && mode != "finish")
        return refuse(client, id, {api::Problem::Kind::FieldWrong, "on_disconnect"});
    if (const auto refusal = whyInaccessible(m_store.link()); refusal && refusal != Refusal::OperatorMode)
        return refuse(client, id, api::refused(*refusal));
    if ((m_control && m_control != client) || m_asked)
        return answer(client, id, {{"granted", false}, {"reason", m_asked ? "Asking" : "InUse"}});
    m_asked = Asked{client, id, mode == "finish"};
    if (m_control || m_grantsUnasked)
        return decide(client, true);
    emit controlAsked(client, session(client).program);
}

void ApiController::decide(Client client, bool may) {
    if (!isAsking(client))
        return;
    const Asked asked = *std::exchange(m_asked, std::nullopt);
    if (may) {
        m_control = client;
        session(client).finishes = asked.finishes;
    }
    Json result{{"granted", may}};
    if (!may)
        result["reason"] = "Refused";
    answer(client, asked.id, result);
    showPrograms();
}

void ApiController::endControl(texts::ControlLost why) {
    if (!m_control)
        return;
    cancelHeldBack({});
    const Client client = *std::exchange(m_control, std::nullopt);
    m_server.send(
        client, ApiFeed::notification("control_lost",
                                      ApiFeed::textOf({{"reason", texts::controlLost(why).toStdString()}})));
    showPrograms();
}

void ApiController::noteCommand(const std::set<ModuleIndex>& modules) {
    for (auto& [client, session] : m_sessions)
        for (const ModuleIndex module : modules)
            session.requests.clearMoved(module);
    endControl(texts::ControlLost::Commanded);
}

void ApiController::noteSequenceCommand() {
    for (auto& [client, session] : m_sessions)
        session.requests.sequenceTaken();
    noteCommand(m_commander.sequences().parts());
}

// ---- motors ----

void ApiController::setMoved(Client client, ModuleIndex module) {
    for (auto& [other, session] : m_sessions)
        session.requests.clearMoved(module);
    session(client).requests.setMoved(module);
}

/// Needs neither hello nor control.
void ApiController::stop(Client client, const api::Method& method, const Json& parameters, const Json& id) {
    if (!parameters.contains("axis")) {
        m_stopping = !whyNoChain(m_store.link());
        m_worker.stopAll();
        m_commander.endRuns();
        noteCall(client, method, parameters);
        endControl(texts::ControlLost::Stopped);
        if (!m_worker.isOpen())
            return refuse(client, id, api::refused(Refusal::NotConnected));
        return answer(client, id, {{"sent", true}});
    }
    command(client, method, parameters, id);
}

void ApiController::command(Client client, const api::Method& method, const Json& parameters,
                            const Json& id) {
    if (method.access == api::Access::Control && m_control != client)
        return fail(client, id, kNoControl, texts::noControl(), "NoControl");
    std::optional<ModuleIndex> module;
    if (parameters.contains("axis"))
        if (const auto axis = api::axisOf(parameters, m_store.link(), m_store.machine()))
            module = *axis;
    const bool staysHeld =
        method.name == "jog" && isHeld(session(client)) && session(client).held.module == module;
    if (method.access == api::Access::Stop || staysHeld || (m_heldBack.empty() && mayPlan(module)))
        return carryOut(client, method, parameters, id);
    if (m_heldBack.size() >= kMostWaits)
        return failTooMany(client, id);
    m_heldBack.push_back({&method, parameters, id, module, monotonicNow()});
}

/// What is planned depends on the state, which what was requested before may be about to change. Where
/// nothing can be sent anyway, planning says why.
bool ApiController::mayPlan(std::optional<ModuleIndex> index) const {
    return whyNoChain(m_store.link()) ||
           std::ranges::all_of(m_store.link().modules, [this, index](const ModuleState& module) {
               return (index && *index != module.info.index) || !module.isKnown() || module.silent ||
                      shows(module);
           });
}

void ApiController::goOn() {
    while (!m_calling && !m_heldBack.empty() && mayPlan(m_heldBack.front().module)) {
        const HeldBack next = std::move(m_heldBack.front());
        m_heldBack.pop_front();
        // Nobody can still be said to hold that button.
        if (next.method->name == "jog" && monotonicNow() - next.since >= kStillHeld)
            fail(*m_control, next.id, kRefused, texts::wasCancelled(), "NotCarriedOut");
        else
            carryOut(*m_control, *next.method, next.parameters, next.id);
    }
}

void ApiController::cancelHeldBack(std::optional<ModuleIndex> module) {
    std::erase_if(m_heldBack, [this, module](const HeldBack& each) {
        const bool cancelled = !module || each.concerns(*module);
        if (cancelled)
            fail(*m_control, each.id, kRefused, texts::wasCancelled(), "NotCarriedOut");
        return cancelled;
    });
}

void ApiController::carryOut(Client client, const api::Method& method, const Json& parameters,
                             const Json& id) {
    const QScopedValueRollback<bool> calling(m_calling, true);
    const bool stops = method.access == api::Access::Stop;
    if (const auto refusal = stops ? whyNoStop(m_store.link()) : whyNoChain(m_store.link()))
        return refuse(client, id, api::refused(*refusal));
    if (method.name != "jog" || !isHeld(session(client)))
        noteCall(client, method, parameters);
    if (method.make == nullptr)
        return run(client, method, parameters, id);
    const LinkState& link = m_store.link();
    std::optional<LinkState> beforeTrial;  // what set_gains leaves out is not taken from a trial
    for (const ModuleState& module : link.modules)
        if (const auto gains = m_commander.procedures().gainsBefore(module.info.index)) {
            if (!beforeTrial)
                beforeTrial = link;
            beforeTrial->modules[module.info.index.value()].gains = gains;
        }
    const auto call = api::callOf(method, parameters, beforeTrial ? *beforeTrial : link, m_store.machine());
    if (!call)
        return refuse(client, id, call.error());
    if (const auto* hold = std::get_if<bus::HoldToMove>(&call->what))
        return jog(client, *hold, id);
    request(client, *call, id);
}

/// Says who has requested what of motors.
void ApiController::noteCall(Client client, const api::Method& method, const Json& parameters) {
    const QString& program = session(client).program;
    emit reported(texts::programCalled(
        program.isEmpty() ? QStringLiteral("?") : program,
        QString::fromStdString(method.name + ' ' +
                               parameters.dump(-1, ' ', false, Json::error_handler_t::replace))
            .left(kLongestCall)));
}

void ApiController::request(Client client, const api::Call& call, const Json& id) {
    const Intent& intent = std::get<Intent>(call.what);
    if (isStop(intent))
        cancelHeldBack(call.module);
    const ModuleState& module = *m_store.module(call.module);
    const AxisScale scale = scaleOf(module, m_store.machine().axis(call.module));
    const auto why = [&](Refusal refusal) {
        refuse(client, id, api::refused(refusal), texts::refusal(refusal, intent, module, scale));
    };
    if (const auto orders = plan(intent, module); !orders)
        return why(orders.error());
    m_refused.reset();
    Session& session = this->session(client);
    session.requests.begin(call.module, intent);
    if (isHeld(session) && session.held.module == call.module) {
        m_worker.release();
        session.heldAt.reset();
    }
    m_connection.dropSearch();
    const auto operation = m_commander.carryOut(call.module, intent);
    if (m_refused)
        return why(*m_refused);
    if (isStop(intent))  // a search or moves that it has just cancelled were requested before
        session.requests.forget(call.module);
    else
        setMoved(client, call.module);
    for (auto& [other, each] : m_sessions)
        if (isStop(intent) && isHeld(each) && each.held.module == call.module)
            each.stopped = true;
    if (operation) {
        m_pending[call.module] = *operation;
        session.requests.setOperation(call.module, *operation);
    } else if (m_commander.procedures().running(call.module)) {
        session.requests.setProcedure(call.module);
    }
    answer(client, id, {{"accepted", true}});
}

void ApiController::jog(Client client, bus::HoldToMove hold, const Json& id) {
    Session& session = this->session(client);
    const bool same =
        isHeld(session) && session.held.module == hold.module && session.held.reverse == hold.reverse;
    if (same && session.stopped) {
        session.heldAt = monotonicNow();  // it goes on calling, and so the press goes on
        return fail(client, id, kRefused, texts::wasCancelled(), "NotCarriedOut");
    }
    hold.press = same ? session.held.press : nextPress();
    const ModuleState& module = *m_store.module(hold.module);
    const auto refusal = whyNot(hold, module);
    if (!refusal && !same)  // one that goes on does not keep the user from a search
        m_connection.dropSearch();
    if ((refusal && !same) || !m_commander.hold(hold)) {
        const Refusal reason = refusal.value_or(Refusal::Moving);
        const AxisScale scale = scaleOf(module, m_store.machine().axis(hold.module));
        return refuse(client, id, api::refused(reason),
                      texts::refusal(reason, intent::Move{runOf(hold)}, module, scale));
    }
    session.held = hold;
    session.heldAt = monotonicNow();
    session.stopped = false;
    session.requests.forget(hold.module);
    setMoved(client, hold.module);
    answer(client, id, {{"accepted", true}});
}

void ApiController::run(Client client, const api::Method& method, const Json& parameters, const Json& id) {
    const Machine& machine = m_store.machine();
    const std::string name = parameters.at("name").get<std::string>();
    const bool sequence = method.name == "start_sequence";
    const auto hasOne = [&name](const auto& all) {
        return std::ranges::any_of(all, [&name](const auto& one) { return one.name == name; });
    };
    if (!(sequence ? hasOne(machine.program.sequences) : hasOne(machine.program.points)))
        return refuse(client, id, {api::Problem::Kind::SequenceUnknown, "name"});
    if (m_commander.sequences().running())
        return refuse(client, id, api::refused(Refusal::Moving));
    m_connection.dropSearch();
    m_notBegun.reset();
    ProgramRequests& own = session(client).requests;
    own.beginSequence();
    SequenceRun run = sequence ? SequenceRun(machine, name, 0) : SequenceRun::toPoint(machine, name);
    const std::set<ModuleIndex> parts = run.parts();
    m_commander.sequences().begin(std::move(run));
    if (m_notBegun) {
        own.sequenceRefused();
        return fail(client, id, kRefused, *m_notBegun, "SequenceRefused");
    }
    for (auto& [other, session] : m_sessions) {
        if (other == client)
            continue;
        session.requests.sequenceTaken();
        // A motor that rests is moved by the sequence from now on, whichever program has moved it before.
        for (const ModuleIndex module : parts)
            if (!m_store.module(module)->moving())
                session.requests.clearMoved(module);
    }
    own.sequenceBegun();
    for (const ModuleIndex module : parts)
        own.forget(module);
    answer(client, id, {{"accepted", true}});
}

/// What the bus has ended goes on with another press only, also where the last call was in time by the clock
/// of this thread but not by that of the bus.
void ApiController::endJogs(const StoreEvent& event) {
    if (!endsHold(event))
        return;
    const auto ends = [&event](const bus::HoldToMove& held) {
        return std::visit(
            Overloaded{
                [&held](const bus::HoldExpired& expired) { return expired.press == held.press; },
                [&held](const AnyOf<bus::MotionSuspect, bus::HealthChanged> auto& news) {
                    const std::optional<ModuleIndex> only = news.module;
                    return !only || *only == held.module;
                },
                [](const auto&) { return true; },
            },
            event);
    };
    for (auto& [client, session] : m_sessions)
        if (isHeld(session) && ends(session.held))
            session.stopped = true;
}

bool ApiController::isHeld(const Session& session) {
    return session.heldAt && monotonicNow() - *session.heldAt < kStillHeld;
}

bool ApiController::rests(ModuleIndex index) const {
    const ModuleState* module = m_store.module(index);
    if (module == nullptr || !module->isKnown())  // what an unknown one does is never known
        return true;
    // A jog may have been requested only just now.
    const bool held = std::ranges::any_of(m_sessions, [index](const auto& each) {
        return isHeld(each.second) && each.second.held.module == index;
    });
    return !held && module->motionSeen() && shows(*module) && !module->moving() &&
           !m_commander.procedures().running(index) && !m_commander.sequences().parts().contains(index);
}

bool ApiController::shows(const ModuleState& module) const {
    const auto done = m_doneAt.find(module.info.index);
    return !module.awaited && !module.home.awaited() && !m_pending.contains(module.info.index) &&
           (done == m_doneAt.end() || module.latestTime > done->second);
}

/// An axis without a tolerance has arrived when it rests.
Arrival::State ApiController::arrivalOf(Pending& wait, const std::vector<ModuleIndex>& modules) const {
    Arrival::State all = Arrival::State::There;
    for (const ModuleIndex index : modules) {
        const ModuleState& module = *m_store.module(index);
        const ArrivalSettings& axis = m_store.machine().axis(index).arrival;
        if (axis.tolerance <= 0.0 || !module.driveOn() || !module.goal() || !module.latest ||
            !module.latest->position)
            continue;
        const Arrival::State state = wait.arrivals[index].look(module, *module.goal(), axis);
        if (state != Arrival::State::There && all != Arrival::State::Missed)
            all = state;
    }
    return all;
}

void ApiController::noteFinished(const bus::OperationFinished& finished) {
    // Null if the port had closed before the window heard of it: such a command ends without its chain.
    const ModuleState* module = m_store.module(finished.module);
    for (const ModuleState& each : m_store.link().modules) {
        const auto pending = m_pending.find(each.info.index);
        const bool requested = pending != m_pending.end() && pending->second == finished.id;
        if (requested)
            m_pending.erase(pending);
        if (requested || &each == module)
            m_doneAt[each.info.index] = each.latestTime;
    }
    for (auto& [client, session] : m_sessions)
        session.requests.onFinished(finished, module);
}

void ApiController::noteEnded(const ProcedureReport& report) {
    if (!report.over())
        return;
    std::optional<QString> failure;
    if (const ModuleState* module = m_store.module(report.module);
        module != nullptr && report.stage != ProcedureStage::Done) {
        const auto message =
            texts::procedureEnded(report, scaleOf(*module, m_store.machine().axis(report.module)));
        failure = message ? message->headline : texts::wasCancelled();
    }
    for (auto& [client, session] : m_sessions)
        session.requests.onProcedureOver(report.module, failure);
}

void ApiController::noteSequence(const SequenceReport& report) {
    if (!report.over())
        return;
    std::optional<QString> failure;
    if (report.stage != SequenceStage::Done) {
        const auto message = texts::sequenceOver(report);
        failure = message ? message->headline + u' ' + message->body : texts::wasCancelled();
    }
    for (auto& [client, session] : m_sessions)
        session.requests.onSequenceOver(failure);
}

void ApiController::answerWaits() {
    const bool connected = m_store.link().phase == LinkPhase::Connected;
    const auto isDone = [this](ModuleIndex module) {
        return rests(module) && std::ranges::none_of(m_heldBack, [module](const HeldBack& each) {
                   return each.concerns(module);
               });
    };
    for (auto& [client, session] : m_sessions) {
        std::vector<Pending> waiting;
        bool sequenceReported = false;
        for (Pending& wait : std::exchange(session.waits, {})) {
            const std::vector<ModuleIndex> modules = awaited(session, wait.module);
            const auto silent = std::ranges::any_of(modules, [this](ModuleIndex module) {
                return m_store.module(module) == nullptr || m_store.module(module)->silent;
            });
            if (!connected || silent)
                refuse(client, wait.id,
                       api::refused(connected ? Refusal::Unresponsive : Refusal::NotConnected));
            else if (m_stopping || (!wait.module && m_commander.sequences().running()) ||
                     !std::ranges::all_of(modules, isDone))
                waiting.push_back(std::move(wait));
            else if (const auto failure = failureOf(session.requests, modules, !wait.module)) {
                sequenceReported |= !wait.module;
                fail(client, wait.id, kRefused, *failure, "NotCarriedOut");
            } else if (const auto arrival = arrivalOf(wait, modules); arrival == Arrival::State::Underway)
                waiting.push_back(std::move(wait));
            else if (arrival == Arrival::State::Missed)
                fail(client, wait.id, kRefused, texts::didNotSettle(), "NotSettled");
            else {
                // What becomes of their goals from now on is not the fault of these requests.
                for (const ModuleIndex module : modules)
                    session.requests.forget(module);
                answer(client, wait.id, stateOf(wait.module));
            }
        }
        session.waits = std::move(waiting);
        if (sequenceReported)
            session.requests.clearSequenceFailure();
    }
}

ApiController::Json ApiController::stateOf(std::optional<ModuleIndex> module) const {
    const LinkState& link = m_store.link();
    if (module)
        return api::stateOf(asShown(link.modules[module->value()], link), m_store.machine().axis(*module));
    Json state = api::stateOf(asShown(link), m_store.machine());
    state["control"] = m_control ? Json(m_sessions.at(*m_control).program.toStdString()) : Json();
    return state;
}

/// All axes are those that answer, those that the client has moved, and those that may still move although
/// all motors were to stop.
std::vector<ModuleIndex> ApiController::awaited(const Session& session,
                                                std::optional<ModuleIndex> module) const {
    if (module)
        return {*module};
    std::vector<ModuleIndex> all;
    for (const ModuleState& each : m_store.link().modules)
        if (!each.silent || each.stopUnconfirmed || session.requests.moved().contains(each.info.index))
            all.push_back(each.info.index);
    return all;
}

std::optional<QString> ApiController::failureOf(const ProgramRequests& requests,
                                                const std::vector<ModuleIndex>& modules,
                                                bool withSequence) const {
    if (withSequence && requests.sequenceFailure())
        return requests.sequenceFailure();
    for (const ModuleIndex module : modules)
        if (auto failure = requests.failure(*m_store.module(module)))
            return failure;
    return std::nullopt;
}

const QByteArray& ApiController::stateText() {
    if (m_stateText.isEmpty())
        m_stateText = ApiFeed::textOf(stateOf({}));
    return m_stateText;
}

// ---- answers ----

/// A request without an id is not answered (JSON-RPC 2.0, notifications).
void ApiController::answerText(Client client, const Json& id, const QByteArray& result) {
    if (!id.is_null())
        m_server.send(client,
                      R"({"jsonrpc":"2.0","id":)" + ApiFeed::textOf(id) + R"(,"result":)" + result + '}');
}

void ApiController::answer(Client client, const Json& id, const Json& result) {
    answerText(client, id, ApiFeed::textOf(result));
}

void ApiController::refuse(Client client, const Json& id, const api::Problem& problem,
                           const QString& sentence) {
    const auto reason = problem.refusal ? enumName<Refusal::TooFar>(*problem.refusal)
                                        : enumName<api::Problem::Kind::Refused>(problem.kind);
    fail(client, id, codeOf(problem.kind), sentence.isEmpty() ? texts::apiProblem(problem) : sentence,
         reason);
}

void ApiController::failTooMany(Client client, const Json& id) {
    fail(client, id, kRefused, QStringLiteral("Too many calls are pending."), "TooMany");
}

void ApiController::fail(Client client, const Json& id, int code, const QString& sentence,
                         std::string_view reason) {
    if (id.is_null() && code != kParseError && code != kInvalidRequest)
        return;
    m_server.send(
        client,
        ApiFeed::textOf(
            {{"jsonrpc", "2.0"},
             {"id", id},
             {"error",
              {{"code", code}, {"message", sentence.toStdString()}, {"data", {{"reason", reason}}}}}}));
}

}  // namespace nmc
