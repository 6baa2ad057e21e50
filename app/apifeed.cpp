// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/apifeed.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/enumname.h"

namespace nmc {

using api::Json;

namespace {

constexpr int kPublishInterval = 100;  ///< ms
constexpr int kServiceInterval = 5;    ///< ms
constexpr std::size_t kServedAtOnce = 8;
static_assert(ApiServer::kMostClients / kServedAtOnce * kServiceInterval < kPublishInterval,
              "a round is over before the next one");
constexpr std::uint64_t kMostSamples = 500;  ///< of a module in one message

}  // namespace

ApiFeed::ApiFeed(const BusStore& store, ApiServer& server, std::function<QByteArray()> state)
    : m_store(store), m_server(server), m_state(std::move(state)) {
    m_pace.setInterval(kPublishInterval);
    m_pace.setSingleShot(true);
    connect(&m_pace, &QTimer::timeout, this, [this] {
        beginRound(true);
        serve(kServedAtOnce);
    });
    m_service.setInterval(kServiceInterval);
    connect(&m_service, &QTimer::timeout, this, [this] { serve(kServedAtOnce); });
    connect(&m_store, &BusStore::linkChanged, this, [this] {
        if (m_server.isOpen() && !m_pace.isActive())
            m_pace.start();
    });
}

QByteArray ApiFeed::textOf(const Json& json) {
    return QByteArray::fromStdString(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

QByteArray ApiFeed::notification(const char* method, const QByteArray& parameters) {
    return R"({"jsonrpc":"2.0","method":")" + QByteArray(method) + R"(","params":)" + parameters + '}';
}

void ApiFeed::subscribe(ApiServer::Client client, const Json& parameters) {
    // So that the client gets no samples from before.
    beginRound(false);
    serve(m_round.due.size());
    Subscription& subscription = m_subscriptions[client];
    subscription.state = parameters.value("state", false);
    subscription.events = parameters.value("events", false);
    subscription.samples = parameters.value("samples", false);
    if (!subscription.samples)
        subscription.missed = 0;  // it has missed none of those that it may want later
}

void ApiFeed::beginRound(bool withState) {
    serve(m_round.due.size());
    m_round = {};
    addSamples();
    const auto wantsState = [](const auto& each) { return each.second.state; };
    if (withState && std::ranges::any_of(m_subscriptions, wantsState))
        m_round.state = notification("state", m_state());
    for (const auto& [client, subscription] : m_subscriptions)
        m_round.due.push_back(client);
    if (!m_round.due.empty())
        m_service.start();
}

void ApiFeed::serve(std::size_t programs) {
    for (; programs > 0 && !m_round.due.empty(); --programs) {
        const ApiServer::Client client = m_round.due.back();
        m_round.due.pop_back();
        const auto found = m_subscriptions.find(client);
        if (found == m_subscriptions.end())
            continue;
        if (found->second.samples && !m_round.line.isEmpty())
            sendSamples(client, found->second);
        if (found->second.state && !m_round.state.isEmpty())
            m_server.offer(client, m_round.state);
    }
    if (m_round.due.empty())
        m_service.stop();
}

/// One line for all clients, however many they are.
void ApiFeed::addSamples() {
    const History& history = m_store.history();
    const TimePoint zero = history.zero().value_or(TimePoint{});
    const auto known = [](float value) { return value == value ? Json(value) : Json(); };
    const bool wanted =
        std::ranges::any_of(m_subscriptions, [](const auto& each) { return each.second.samples; });
    // Another chain has a history of its own, of which nothing has been published.
    if (std::exchange(m_zero, history.zero()) != history.zero())
        m_published.clear();
    m_published.resize(history.modules());
    Json modules = Json::array();
    for (std::size_t i = 0; i < history.modules(); ++i) {
        const ModuleHistory& module = *history.module(ModuleIndex(static_cast<std::uint8_t>(i)));
        if (!wanted) {
            m_published[i] = module.count();
            continue;
        }
        Json rows = Json::array();
        m_published[i] = module.visitSince(
            m_published[i],
            [&](const ScopeSample& sample) {
                rows.push_back({toSeconds(sample.time - zero),
                                sample.io ? Json(sample.counter()) : Json(sample.position),
                                known(sample.error), known(sample.velocity), sample.status, sample.aux,
                                sample.analog, sample.gapBefore, sample.io ? Json(sample.counted) : Json()});
            },
            kMostSamples);
        m_round.count += rows.size();
        if (!rows.empty())
            modules.push_back({{"axis", i + 1}, {"rows", std::move(rows)}});
    }
    if (modules.empty())
        return;
    m_round.samples = {{"missed", 0}, {"modules", std::move(modules)}};
    m_round.line = notification("samples", textOf(m_round.samples));
}

void ApiFeed::sendSamples(ApiServer::Client client, Subscription& subscription) {
    const auto withCount = [this](std::uint64_t missed) {
        m_round.samples["missed"] = missed;
        return notification("samples", textOf(m_round.samples));
    };
    // No line is written out for a program that is not reading.
    const bool sent =
        m_server.hasRoom(client, m_round.line.size()) &&
        m_server.offer(client, subscription.missed == 0 ? m_round.line : withCount(subscription.missed));
    subscription.missed = sent ? 0 : subscription.missed + m_round.count;
}

void ApiFeed::publish(const Message& message) {
    std::optional<QByteArray> line;
    for (const auto& [client, subscription] : m_subscriptions) {
        if (!subscription.events)
            continue;
        if (!line)
            line = notification("event",
                                textOf({{"severity", enumName<Severity::Fault>(message.severity)},
                                        {"axis", message.module ? Json(message.module->value() + 1) : Json()},
                                        {"text", message.headline.toStdString()},
                                        {"detail", message.body.toStdString()}}));
        m_server.send(client, *line);
    }
}

}  // namespace nmc
