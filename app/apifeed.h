// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "link/api/apiserver.h"
#include "link/connection/busstore.h"
#include "model/api/apimethods.h"
#include "widgets/common/message.h"

namespace nmc {

/// What programs have subscribed to, as it is sent to them (docs/api.md, "Notifications"). State and samples
/// are dropped for a program that is behind; it then learns how many samples it has missed. They go to a few
/// programs at a time, so that a call does not wait until a hundred have got theirs. GUI thread.
class ApiFeed : public QObject {
    Q_OBJECT

public:
    /// `state`: returns the text of what the method of that name does.
    ApiFeed(const BusStore& store, ApiServer& server, std::function<QByteArray()> state);

    /// Replaces what the client subscribed to before. The parameters have been checked.
    void subscribe(ApiServer::Client client, const api::Json& parameters);
    void forget(ApiServer::Client client) { m_subscriptions.erase(client); }
    void publish(const Message& message);

    [[nodiscard]] static QByteArray textOf(const api::Json& json);
    /// A line as it is sent.
    [[nodiscard]] static QByteArray notification(const char* method, const QByteArray& parameters);

private:
    struct Subscription {
        bool state = false, events = false, samples = false;
        std::uint64_t missed = 0;  ///< samples that the client was too slow for
    };

    /// State and samples since the last round, and the programs that are still to get them.
    struct Round {
        std::vector<ApiServer::Client> due{};
        QByteArray state{};   ///< empty: none
        api::Json samples{};  ///< the parameters
        QByteArray line{};    ///< of the samples, for a program that has missed none; empty: there are none
        std::uint64_t count = 0;  ///< of the samples
    };

    void beginRound(bool withState);
    void addSamples();
    /// Goes on with the round, at most for this many programs.
    void serve(std::size_t programs);
    void sendSamples(ApiServer::Client client, Subscription& subscription);

    const BusStore& m_store;
    ApiServer& m_server;
    std::function<QByteArray()> m_state;
    std::map<ApiServer::Client, Subscription> m_subscriptions;
    QTimer m_pace;
    QTimer m_service;  ///< until all have got what is due
    Round m_round;
    std::vector<std::uint64_t> m_published;  ///< samples of each module
    std::optional<TimePoint> m_zero;         ///< of the history that they are in
};

}  // namespace nmc
