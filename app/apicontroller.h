// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "app/apifeed.h"
#include "app/connection.h"
#include "app/programrequests.h"
#include "link/api/apiserver.h"
#include "link/command/commander.h"
#include "link/connection/busstore.h"
#include "link/connection/busworker.h"
#include "model/api/apimethods.h"
#include "widgets/common/apitexts.h"

namespace nmc {

/// Lets other programs use the chain that this one is connected to (docs/api.md): answers their calls, gives
/// the right to move motors to one of them at a time, and takes it back. What they request of motors goes
/// through the same checks as what the user requests. It needs no window. GUI thread.
class ApiController : public QObject {
    Q_OBJECT

public:
    ApiController(const BusStore& store, BusWorker& worker, Connection& connection, Commander& commander);

    /// Opens the socket for the port of the present connection, and of every later one.
    void letIn(bool on);
    /// Empty while none is open.
    [[nodiscard]] QString socket() const { return m_server.isOpen() ? m_server.path() : QString(); }
    /// From now on, programs get the right to move motors without the user being asked.
    void grantUnasked() { m_grantsUnasked = true; }
    /// The user has commanded these motors.
    void noteCommand(const std::set<ModuleIndex>& modules);
    /// The user has started, continued or ended a sequence; call after that.
    void noteSequenceCommand();
    /// Takes the right to move motors back.
    void endControl(texts::ControlLost why);
    /// The user is being asked whether this client may move motors.
    [[nodiscard]] bool isAsking(ApiServer::Client client) const {
        return m_asked && m_asked->client == client;
    }
    /// The user's answer; too late if isAsking() is false.
    void decide(ApiServer::Client client, bool may);
    /// Sends a message to the programs that want events.
    void publish(const Message& message) { m_feed.publish(message); }

signals:
    void changed(const nmc::ProgramsShown& programs);
    /// decide() must follow, unless isAsking() becomes false.
    void controlAsked(nmc::ApiServer::Client client, const QString& program);
    /// isAsking() has become false without decide().
    void askingEnded();
    void reported(const nmc::Message& message);
    /// The message with this key is over.
    void ended(const QString& key);

private:
    using Json = api::Json;
    using Client = ApiServer::Client;
    /// A call that is answered later.
    struct Pending {
        Json id;
        std::optional<ModuleIndex> module;  ///< empty: all, and the sequence that runs
        std::map<ModuleIndex, Arrival> arrivals{};
    };
    struct Session {
        QString program{};      ///< empty until it has called hello
        bool finishes = false;  ///< its moves finish when it disappears
        ProgramRequests requests{};
        std::vector<Pending> waits{};
        bus::HoldToMove held{};  ///< the last jog
        std::optional<TimePoint> heldAt{};
        bool stopped = false;  ///< something else has ended this jog
    };
    /// A call of the client that has control, until what it is planned from shows what was done before.
    struct HeldBack {
        const api::Method* method;
        Json parameters;
        Json id;
        std::optional<ModuleIndex> module;  ///< empty: any
        TimePoint since;

        [[nodiscard]] bool concerns(ModuleIndex index) const { return !module || *module == index; }
    };
    struct Asked {
        Client client;
        Json id;
        bool finishes;  ///< Session::finishes, once it is granted
    };

    void follow();
    void listen();
    void read(Client client, const QByteArray& line);
    void gone(Client client);
    void call(Client client, const api::Method& method, const Json& parameters, const Json& id);
    void greet(Client client, const Json& parameters, const Json& id);
    void ask(Client client, const Json& parameters, const Json& id);
    void stop(Client client, const api::Method& method, const Json& parameters, const Json& id);
    void command(Client client, const api::Method& method, const Json& parameters, const Json& id);
    [[nodiscard]] bool mayPlan(std::optional<ModuleIndex> index) const;
    /// Carries out what is held back, as far as its modules show by now what was done before.
    void goOn();
    /// What is held back for this module, or for any of them.
    void cancelHeldBack(std::optional<ModuleIndex> module);
    void carryOut(Client client, const api::Method& method, const Json& parameters, const Json& id);
    void noteCall(Client client, const api::Method& method, const Json& parameters);
    void request(Client client, const api::Call& call, const Json& id);
    void jog(Client client, bus::HoldToMove hold, const Json& id);
    void run(Client client, const api::Method& method, const Json& parameters, const Json& id);
    void endJogs(const StoreEvent& event);
    void setMoved(Client client, ModuleIndex module);
    [[nodiscard]] static bool isHeld(const Session& session);
    [[nodiscard]] bool rests(ModuleIndex module) const;
    /// Its state shows what has been requested of it.
    [[nodiscard]] bool shows(const ModuleState& module) const;
    /// How far these modules, all at rest, are: Missed if any of them has missed its goal, Underway if any
    /// has not arrived yet.
    [[nodiscard]] Arrival::State arrivalOf(Pending& wait, const std::vector<ModuleIndex>& modules) const;
    void noteFinished(const bus::OperationFinished& finished);
    void noteEnded(const ProcedureReport& report);
    void noteSequence(const SequenceReport& report);
    void answerWaits();
    [[nodiscard]] std::vector<ModuleIndex> awaited(const Session& session,
                                                   std::optional<ModuleIndex> module) const;
    [[nodiscard]] std::optional<QString> failureOf(const ProgramRequests& requests,
                                                   const std::vector<ModuleIndex>& modules,
                                                   bool withSequence) const;

    /// What `state` returns for this module, or without one for the whole chain.
    [[nodiscard]] Json stateOf(std::optional<ModuleIndex> module) const;
    /// The text of the latter, which is made once for all programs that ask before something has changed.
    [[nodiscard]] const QByteArray& stateText();
    void answer(Client client, const Json& id, const Json& result);
    void answerText(Client client, const Json& id, const QByteArray& result);
    void refuse(Client client, const Json& id, const api::Problem& problem, const QString& sentence = {});
    void failTooMany(Client client, const Json& id);
    void fail(Client client, const Json& id, int code, const QString& sentence, std::string_view reason);
    [[nodiscard]] Session& session(Client client) { return m_sessions.at(client); }
    void showPrograms();

    const BusStore& m_store;
    BusWorker& m_worker;
    Connection& m_connection;
    Commander& m_commander;
    ApiServer m_server;
    QByteArray m_stateText;  ///< empty: to be made
    ApiFeed m_feed{m_store, m_server, [this] { return stateText(); }};
    std::map<Client, Session> m_sessions;
    std::optional<Client> m_control;
    std::optional<Asked> m_asked;                       ///< the user is being asked
    std::map<ModuleIndex, bus::OperationId> m_pending;  ///< the last one that a program's call began
    /// Only a status latched after this shows what was done (the reply to a command is older than its
    /// effect).
    std::map<ModuleIndex, TimePoint> m_doneAt;
    bool m_stopping = false;          ///< a program has requested a stop of all motors, which is not over yet
    std::deque<HeldBack> m_heldBack;  ///< in the order of their arrival
    bool m_calling = false;           ///< a call is being carried out
    std::optional<Refusal> m_refused;   ///< by Commander, during a call
    std::optional<QString> m_notBegun;  ///< why a sequence was refused during a call
    bool m_on = false;
    QString m_tried;  ///< the port whose socket was to be opened last
    bool m_grantsUnasked = false;
};

}  // namespace nmc
