// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/apicontroller.h"

#include <algorithm>
#include <utility>

#include "base/enumname.h"
#include "link/clock.h"
#include "model/intent/jog.h"
#include "model/module/modulescale.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/requests.h"
#include "widgets/common/sequencetexts.h"
#include "widgets/common/texts.h"
#include "widgets/common/travelwords.h"
#include "widgets/common/words.h"
#include "widgets/messages/messagemodel.h"

namespace nmc {

namespace {

constexpr auto kProtocol = "1.0";
constexpr qsizetype kLongestName = 60;
constexpr int kPublishInterval = 100;                            ///< ms
constexpr Duration kStillHeld = std::chrono::milliseconds(250);  ///< a jog after that is another press
constexpr std::uint64_t kMostSamples = 500;                      ///< of a module in one message

constexpr std::size_t kMostWaits = 64;  ///< pending, of one client

// Codes of JSON-RPC 2.0, and ours.
constexpr int kParseError = -32700, kInvalidRequest = -32600, kNoMethod = -32601, kBadParameters = -32602;
constexpr int kRefused = -32000, kNoControl = -32001, kNotGreeted = -32002;

[[nodiscard]] QByteArray lineOf(const api::Json& json) {
    return QByteArray::fromStdString(json.dump(-1, ' ', false, api::Json::error_handler_t::replace));
}

[[nodiscard]] api::Json notification(const char* method, api::Json parameters) {
    return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(parameters)}};
}

}  // namespace

ApiController::ApiController(MainWindow& window, const BusStore& store, BusWorker& worker,
                             Connection& connection, Commander& commander, MachineController& machine,
                             MessageController& messages, QObject* parent)
    : QObject(parent),
      m_window(window),
      m_store(store),
      m_worker(worker),
      m_connection(connection),
      m_commander(commander),
      m_machine(machine),
      m_messages(messages) {
    m_publishTimer.setInterval(kPublishInterval);
    m_publishTimer.setSingleShot(true);
    connect(&m_publishTimer, &QTimer::timeout, this, [this] {
        publishSamples();
        publishState();
    });
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
    connect(&m_commander.sequences(), &SequenceController::refused, this,
            [this](const std::vector<SequenceProblem>& problems) {
                m_notBegun = texts::sequenceNotBegun(problems.front()).headline;
            });
    connect(&m_store, &BusStore::happened, this, [this](const StoreEvent& event) {
        if (const auto* finished = std::get_if<bus::OperationFinished>(&event))
            noteFinished(*finished);
        // Nor may it go on where nobody but the panel itself has stopped the motors.
        if (std::holds_alternative<bus::StopFinished>(event))
            lose(texts::ControlLost::Stopped);
    });
    connect(&m_commander.procedures(), &ProcedureController::reported, this, &ApiController::noteEnded);
    connect(&m_window.messageModel(), &MessageModel::reported, this, &ApiController::publishEvent);

    const Requests* requests = &m_window.requests();
    connect(requests, &Requests::letProgramsIn, this, &ApiController::letIn);
    connect(requests, &Requests::endProgramControl, this, [this] { lose(texts::ControlLost::TakenBack); });
    connect(&m_window, &MainWindow::stopAllRequested, this, [this] { lose(texts::ControlLost::Stopped); });
    connect(requests, &Requests::intent, this,
            [this](ModuleIndex module, const Intent&) { noteCommand(module); });
    connect(requests, &Requests::hold, this,
            [this](const bus::HoldToMove& hold) { noteCommand(hold.module); });
    const auto several = [this] { noteCommand({}); };
    connect(requests, &Requests::groupCommand, this, several);
    connect(requests, &Requests::homeAll, this, several);
    connect(requests, &Requests::goToPoint, this, several);
    connect(requests, &Requests::goToPlace, this, several);
    connect(requests, &Requests::startSequence, this, several);
    connect(requests, &Requests::stopSequence, this, several);
}

// ---- the socket ----

void ApiController::letIn(bool on) {
    m_on = on;
    m_tried.clear();
    if (on)
        listen();
    else
        m_server.close();
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
        m_messages.report(texts::apiClosed(opened.error()));
    else
        m_messages.end(QStringLiteral("api"));
    showPrograms();
}

/// Everything that follows from a change of the chain.
void ApiController::follow() {
    if (!m_on)
        return;
    listen();
    if (m_store.link().phase != LinkPhase::Connected) {
        m_pending.clear();
        m_doneAt.clear();
        lose(texts::ControlLost::Disconnected);
    }
    answerWaits();
    if (!m_publishTimer.isActive())
        m_publishTimer.start();
}

void ApiController::showPrograms() {
    ProgramsShown shown{.on = m_on, .path = m_server.isOpen() ? m_server.path() : QString()};
    for (const auto& [client, session] : m_sessions)
        shown.connected += session.program.isEmpty() ? 0 : 1;
    if (m_control)
        shown.inControl = session(*m_control).program;
    m_window.showPrograms(shown);
}

void ApiController::gone(Client client) {
    const auto found = m_sessions.find(client);
    if (found == m_sessions.end())
        return;
    const Session session = std::move(found->second);
    m_sessions.erase(found);
    if (m_asked && m_asked->client == client) {
        m_asked.reset();
        AskDialog::reviewAll(m_window);
    }
    if (m_control == client)
        m_control.reset();
    bool stops = false;
    if (!session.finishes) {
        if (session.runs && m_commander.sequences().running()) {
            m_commander.sequences().stop();
            stops = true;
        }
        for (const ModuleIndex module : session.moved)
            if (!rests(module)) {
                m_commander.carryOut(module, intent::StopSmoothly{});
                stops = true;
            }
    }
    if (!session.program.isEmpty())
        m_messages.report(texts::programGone(session.program, stops));
    showPrograms();
}

// ---- calls ----

void ApiController::read(Client client, const QByteArray& line) {
    m_sessions.try_emplace(client);
    const Json request = Json::parse(line.begin(), line.end(), nullptr, false);
    if (request.is_discarded())
        return fail(client, {}, kParseError, QStringLiteral("This line is not JSON."), "NotJson");
    const auto part = [&request](const char* name) {
        return request.is_object() && request.contains(name) ? request.at(name) : Json();
    };
    const Json id = part("id");
    const Json method = part("method");
    const Json parameters = part("params").is_null() ? Json::object() : part("params");
    if (!method.is_string() || !parameters.is_object() || id.is_structured() || id.is_boolean())
        return fail(client, {}, kInvalidRequest,
                    QStringLiteral("A request is an object with method, params (an object) and id."),
                    "InvalidRequest");
    call(client, method.get<std::string>(), parameters, id);
}

void ApiController::call(Client client, const std::string& name, const Json& parameters, const Json& id) {
    const api::Method* method = api::findMethod(name);
    if (method == nullptr)
        return fail(client, id, kNoMethod, QStringLiteral("There is no such method."), "NoMethod");
    if (const auto problem = api::problemOf(*method, parameters))
        return refuse(client, id, *problem);
    if (name == "hello")
        return greet(client, parameters, id);
    if (name == "stop")
        return stop(client, parameters, id);
    if (session(client).program.isEmpty())
        return fail(client, id, kNotGreeted, texts::helloFirst(), "HelloFirst");
    if (method->access != api::Access::Read)
        return command(client, *method, parameters, id);
    if (name == "describe")
        return answer(client, id, api::describe());
    if (name == "state") {
        Json state = api::stateOf(m_store.link(), m_machine.machine());
        state["control"] = m_control ? Json(session(*m_control).program.toStdString()) : Json();
        return answer(client, id, state);
    }
    if (name == "subscribe") {
        subscribe(client, parameters);
        return answer(client, id, Json::object());
    }
    if (name == "request_control")
        return ask(client, parameters, id);
    if (name == "release_control") {
        if (m_control == client) {
            m_control.reset();
            showPrograms();
        }
        return answer(client, id, Json::object());
    }
    // "wait"
    const auto axis = api::axisOf(parameters, m_store.link(), m_machine.machine());
    if (!axis)
        return refuse(client, id, axis.error());
    if (session(client).waits.size() >= kMostWaits)
        return fail(client, id, kRefused, QStringLiteral("Too many calls of wait are pending."), "TooMany");
    session(client).waits.push_back({id, *axis});
    answerWaits();
}

void ApiController::greet(Client client, const Json& parameters, const Json& id) {
    const QString theirs = QString::fromStdString(parameters.at("protocol").get<std::string>());
    const QString ours = QLatin1String(kProtocol);
    if (theirs.section(QLatin1Char('.'), 0, 0) != ours.section(QLatin1Char('.'), 0, 0))
        return fail(client, id, kNotGreeted, texts::otherProtocol(theirs, ours), "OtherProtocol");
    const QString name =
        QString::fromStdString(parameters.at("program").get<std::string>()).simplified().left(kLongestName);
    const bool first =
        std::exchange(session(client).program, name.isEmpty() ? QStringLiteral("?") : name).isEmpty();
    answer(client, id,
           {{"protocol", kProtocol},
            {"program", "NMC Panel " NMC_VERSION},
            {"chain", api::stateOf(m_store.link(), m_machine.machine())},
            {"capabilities", Json::array({"control", "subscribe", "samples"})}});
    if (first)
        m_messages.report(texts::programConnected(session(client).program));
    showPrograms();
}

void ApiController::subscribe(Client client, const Json& parameters) {
    Session& session = this->session(client);
    session.state = parameters.value("state", false);
    session.events = parameters.value("events", false);
    session.samples = parameters.value("samples", false);
}

// ---- the right to move motors ----

void ApiController::ask(Client client, const Json& parameters, const Json& id) {
    const std::string mode = parameters.value("on_disconnect", "stop");
    if (mode != "stop" && mode != "finish")
        return refuse(client, id, {api::Problem::Kind::FieldWrong, "on_disconnect"});
    if (const auto refusal = whyInaccessible(m_store.link()); refusal && refusal != Refusal::OperatorMode)
        return refuse(client, id, api::refused(*refusal));
    if (m_control == client)
        return answer(client, id, {{"granted", true}});
    if (m_control || m_asked)
        return answer(client, id, {{"granted", false}});
    session(client).finishes = mode == "finish";
    m_asked = Asked{client, id};
    if (m_grantsUnasked)
        return grant(true);
    const auto asked = [this, client] { return m_asked && m_asked->client == client; };
    m_window.askForControl(session(client).program, asked, [this, asked](bool may) {
        if (asked())
            grant(may);
    });
}

void ApiController::grant(bool may) {
    const auto asked = std::exchange(m_asked, std::nullopt);
    if (!asked)
        return;
    if (may)
        m_control = asked->client;
    answer(asked->client, asked->id, {{"granted", may}});
    showPrograms();
}

void ApiController::lose(texts::ControlLost why) {
    if (!m_control)
        return;
    const Client client = *std::exchange(m_control, std::nullopt);
    m_server.send(client,
                  lineOf(notification("control_lost", {{"reason", texts::controlLost(why).toStdString()}})));
    showPrograms();
}

void ApiController::noteCommand(std::optional<ModuleIndex> module) {
    for (auto& [client, session] : m_sessions) {
        if (module) {
            session.moved.erase(*module);
        } else {
            session.moved.clear();
            session.runs = false;
        }
    }
    lose(texts::ControlLost::Commanded);
}

// ---- motors ----

void ApiController::noteMoved(Client client, ModuleIndex module) {
    for (auto& [other, session] : m_sessions)
        session.moved.erase(module);
    session(client).moved.insert(module);
}

/// Needs neither hello nor control.
void ApiController::stop(Client client, const Json& parameters, const Json& id) {
    if (!parameters.contains("axis")) {
        m_worker.stopAll();
        m_commander.endRuns();
        lose(texts::ControlLost::Stopped);
        return answer(client, id, {{"sent", true}});
    }
    command(client, *api::findMethod("stop"), parameters, id);
}

void ApiController::command(Client client, const api::Method& method, const Json& parameters,
                            const Json& id) {
    if (method.access == api::Access::Control && m_control != client)
        return fail(client, id, kNoControl, texts::noControl(), "NoControl");
    if (const auto refusal = whyNoChain(m_store.link()))
        return refuse(client, id, api::refused(*refusal));
    if (method.name != "jog" || !isHeld(client))
        m_messages.report(texts::programCalled(
            session(client).program.isEmpty() ? QStringLiteral("?") : session(client).program,
            QString::fromStdString(method.name + ' ' +
                                   parameters.dump(-1, ' ', false, Json::error_handler_t::replace))));
    if (method.name == "start_sequence" || method.name == "go_to_point")
        return run(client, method, parameters, id);
    const auto call = api::callOf(method.name, parameters, m_store.link(), m_machine.machine());
    if (!call)
        return refuse(client, id, call.error());
    if (const auto* hold = std::get_if<bus::HoldToMove>(&call->what))
        return jog(client, *hold, id);
    request(client, *call, id);
}

void ApiController::request(Client client, const api::Call& call, const Json& id) {
    const Intent& intent = std::get<Intent>(call.what);
    const ModuleState& module = *m_store.module(call.module);
    const AxisScale scale = scaleOf(module, m_machine.machine().axis(call.module));
    const auto why = [&](Refusal refusal) {
        refuse(client, id, api::refused(refusal), texts::refusal(refusal, intent, module, scale));
    };
    if (const auto orders = plan(intent, module); !orders)
        return why(orders.error());
    m_refused.reset();
    Session& session = this->session(client);
    session.failures.erase(call.module);
    m_connection.dropSearch();
    const auto operation = m_commander.carryOut(call.module, intent);
    if (m_refused)
        return why(*m_refused);
    if (!isStop(intent))
        noteMoved(client, call.module);
    if (operation)
        m_pending[call.module] = session.operations[call.module] = *operation;
    answer(client, id, {{"accepted", true}});
}

void ApiController::jog(Client client, bus::HoldToMove hold, const Json& id) {
    Session& session = this->session(client);
    const bool same =
        isHeld(client) && session.held.module == hold.module && session.held.reverse == hold.reverse;
    hold.press = same ? session.held.press : nextPress();
    const ModuleState& module = *m_store.module(hold.module);
    if (const auto refusal = whyNot(hold, module); refusal && !same)
        return refuse(client, id, api::refused(*refusal));
    if (!m_commander.hold(hold))
        return refuse(client, id, api::refused(Refusal::Moving));
    session.held = hold;
    session.heldAt = monotonicNow();
    noteMoved(client, hold.module);
    answer(client, id, {{"accepted", true}});
}

void ApiController::run(Client client, const api::Method& method, const Json& parameters, const Json& id) {
    const Machine& machine = m_machine.machine();
    const std::string name = parameters.at("name").get<std::string>();
    const bool sequence = method.name == "start_sequence";
    const bool known = sequence ? std::ranges::any_of(machine.program.sequences,
                                                      [&](const Sequence& one) { return one.name == name; })
                                : std::ranges::any_of(machine.program.points,
                                                      [&](const Point& one) { return one.name == name; });
    if (!known)
        return refuse(client, id, {api::Problem::Kind::SequenceUnknown, "name"});
    if (m_commander.sequences().running())
        return refuse(client, id, api::refused(Refusal::Moving));
    m_notBegun.reset();
    if (sequence)
        m_commander.sequences().start(machine, name, 0, false);
    else
        m_commander.sequences().goTo(machine, name);
    if (m_notBegun)
        return fail(client, id, kRefused, *m_notBegun, "SequenceRefused");
    for (auto& [other, session] : m_sessions)
        session.runs = other == client;
    answer(client, id, {{"accepted", true}});
}

bool ApiController::isHeld(Client client) {
    const auto& at = session(client).heldAt;
    return at && monotonicNow() - *at < kStillHeld;
}

bool ApiController::rests(ModuleIndex index) const {
    const ModuleState* module = m_store.module(index);
    if (module == nullptr)
        return true;
    const auto done = m_doneAt.find(index);
    return !module->awaited && !m_pending.contains(index) &&
           (done == m_doneAt.end() || module->latestTime > done->second) && !module->moving() &&
           !m_commander.procedures().running(index) && !m_commander.sequences().parts().contains(index);
}

void ApiController::noteFinished(const bus::OperationFinished& finished) {
    if (const auto pending = m_pending.find(finished.module);
        pending != m_pending.end() && pending->second == finished.id) {
        m_pending.erase(pending);
        m_doneAt[finished.module] = m_store.module(finished.module)->latestTime;
    }
    if (finished.outcome == bus::Outcome::Done)
        return;
    for (auto& [client, session] : m_sessions)
        if (const auto own = session.operations.find(finished.module);
            own != session.operations.end() && own->second == finished.id)
            session.failures[finished.module] = texts::operationFailed(finished).headline;
}

void ApiController::noteEnded(const ProcedureReport& report) {
    const ModuleState* module = m_store.module(report.module);
    if (!report.over() || report.stage == ProcedureStage::Done || module == nullptr)
        return;
    const auto message =
        texts::procedureEnded(report, scaleOf(*module, m_machine.machine().axis(report.module)));
    for (auto& [client, session] : m_sessions)
        if (session.moved.contains(report.module))
            session.failures[report.module] = message ? message->headline : texts::wasCancelled();
}

void ApiController::answerWaits() {
    const bool connected = m_store.link().phase == LinkPhase::Connected;
    for (auto& [client, session] : m_sessions) {
        std::vector<Pending> waiting;
        for (Pending& wait : std::exchange(session.waits, {})) {
            const ModuleState* module = m_store.module(wait.module);
            if (!connected || module == nullptr || module->silent)
                refuse(client, wait.id,
                       api::refused(connected ? Refusal::Unresponsive : Refusal::NotConnected));
            else if (!rests(wait.module))
                waiting.push_back(std::move(wait));
            else if (const auto failure = session.failures.find(wait.module);
                     failure != session.failures.end())
                fail(client, wait.id, kRefused, failure->second, "NotCarriedOut");
            else
                answer(client, wait.id, api::stateOf(*module, m_machine.machine().axis(wait.module)));
        }
        session.waits = std::move(waiting);
    }
}

// ---- what is sent without being asked for ----

void ApiController::publishState() {
    std::optional<QByteArray> line;
    for (const auto& [client, session] : m_sessions) {
        if (!session.state)
            continue;
        if (!line)
            line = lineOf(notification("state", api::stateOf(m_store.link(), m_machine.machine())));
        m_server.offer(client, *line);
    }
}

/// One line for all clients, however many they are.
void ApiController::publishSamples() {
    const History& history = m_store.history();
    const TimePoint zero = history.zero().value_or(TimePoint{});
    const auto known = [](float value) { return value == value ? Json(value) : Json(); };
    const bool wanted = std::ranges::any_of(m_sessions, [](const auto& each) { return each.second.samples; });
    m_published.resize(history.modules());
    std::size_t count = 0;
    Json modules = Json::array();
    for (std::size_t i = 0; i < history.modules(); ++i) {
        const ModuleHistory& module = *history.module(ModuleIndex(static_cast<std::uint8_t>(i)));
        if (!wanted || module.count() < m_published[i]) {
            m_published[i] = module.count();
            continue;
        }
        Json rows = Json::array();
        m_published[i] = module.visitSince(
            m_published[i],
            [&](const ScopeSample& sample) {
                rows.push_back({toSeconds(sample.time - zero), sample.position, known(sample.error),
                                known(sample.velocity)});
            },
            kMostSamples);
        count += rows.size();
        if (!rows.empty())
            modules.push_back({{"axis", i + 1}, {"rows", std::move(rows)}});
    }
    if (modules.empty())
        return;
    Json parameters{{"missed", 0}, {"modules", std::move(modules)}};
    const QByteArray line = lineOf(notification("samples", parameters));
    for (auto& [client, session] : m_sessions) {
        if (!session.samples)
            continue;
        parameters["missed"] = session.missed;
        const bool sent =
            m_server.offer(client, session.missed == 0 ? line : lineOf(notification("samples", parameters)));
        session.missed = sent ? 0 : session.missed + count;
    }
}

void ApiController::publishEvent(const MessageEntry& entry) {
    const Message& message = entry.message;
    std::optional<QByteArray> line;
    for (const auto& [client, session] : m_sessions) {
        if (!session.events)
            continue;
        if (!line)
            line = lineOf(
                notification("event", {{"severity", enumName<Severity::Fault>(message.severity)},
                                       {"axis", message.module ? Json(message.module->value() + 1) : Json()},
                                       {"text", message.headline.toStdString()},
                                       {"detail", message.body.toStdString()}}));
        m_server.send(client, *line);
    }
}

// ---- answers ----

/// A request without an id is not answered (JSON-RPC 2.0, notifications).
void ApiController::answer(Client client, const Json& id, const Json& result) {
    if (!id.is_null())
        m_server.send(client, lineOf({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}}));
}

void ApiController::refuse(Client client, const Json& id, const api::Problem& problem,
                           const QString& sentence) {
    const bool refused = problem.kind == api::Problem::Kind::Refused;
    const auto reason = refused ? enumName<Refusal::TooFar>(*problem.refusal)
                                : enumName<api::Problem::Kind::Refused>(problem.kind);
    fail(client, id, refused ? kRefused : kBadParameters,
         sentence.isEmpty() ? texts::apiProblem(problem) : sentence, reason);
}

void ApiController::fail(Client client, const Json& id, int code, const QString& sentence,
                         std::string_view reason) {
    if (id.is_null() && code != kParseError && code != kInvalidRequest)
        return;
    m_server.send(
        client,
        lineOf({{"jsonrpc", "2.0"},
                {"id", id},
                {"error",
                 {{"code", code}, {"message", sentence.toStdString()}, {"data", {{"reason", reason}}}}}}));
}

}  // namespace nmc
