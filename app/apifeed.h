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
/// are dropped for a program that is behind; it then learns how many samples it has missed. GUI thread.
class ApiFeed : public QObject {
    Q_OBJECT

public:
    /// `state`: returns what the method of that name does.
    ApiFeed(const BusStore& store, ApiServer& server, std::function<api::Json()> state);

    /// Replaces what the client subscribed to before. The parameters have been checked.
    void subscribe(ApiServer::Client client, const api::Json& parameters);
    void forget(ApiServer::Client client) { m_subscriptions.erase(client); }
    void publish(const Message& message);

    /// A line as it is sent.
    [[nodiscard]] static QByteArray lineOf(const api::Json& json);
    [[nodiscard]] static QByteArray notification(const char* method, api::Json parameters);

private:
    struct Subscription {
        bool state = false, events = false, samples = false;
        std::uint64_t missed = 0;  ///< samples that the client was too slow for
    };

    void publishState();
    void publishSamples();

    const BusStore& m_store;
    ApiServer& m_server;
    std::function<api::Json()> m_state;
    std::map<ApiServer::Client, Subscription> m_subscriptions;
    QTimer m_pace;
    std::vector<std::uint64_t> m_published;  ///< samples of each module
    std::optional<TimePoint> m_zero;         ///< of the history that they are in
};

}  // namespace nmc
