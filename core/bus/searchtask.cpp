// SPDX-License-Identifier: MIT
#include "bus/searchtask.h"

namespace nmc::bus {

void SearchTask::begin(const EngineConfig& config, Discovery::Start start) {
    m_config = config;
    m_start = start;
    m_ended.reset();
    m_givesAddresses = false;
    m_discovery.emplace(m_config, m_start);
}

bool SearchTask::onChange(const Change& change) {
    const bool interrupted = m_discovery && change.kind == Change::Kind::Interrupted;
    if (interrupted && !m_discovery->resume())
        m_discovery.emplace(m_config, m_start);
    return interrupted;
}

Next SearchTask::next(TimePoint /*now*/) {
    reportProgress();
    const bool gaveAddresses = m_discovery->givesAddresses();
    Discovery::Next next = m_discovery->next();
    m_givesAddresses = m_givesAddresses || (!gaveAddresses && m_discovery->givesAddresses());
    reportProgress();
    if (auto* script = std::get_if<Line::Script>(&next))
        return std::move(*script);
    if (auto* ask = std::get_if<Ask>(&next))
        return std::move(*ask);
    if (auto* found = std::get_if<ChainFound>(&next))
        end(std::move(*found));
    else
        end(std::get<ConnectFailed>(std::move(next)));
    return Again{};
}

Line::Script SearchTask::onEnd(const Ask& /*ask*/, const ReplyEnd& end, TimePoint /*now*/) {
    if (m_discovery)
        m_discovery->onReply(end);
    return {};
}

void SearchTask::reportProgress() {
    if (const auto progress = m_discovery->takeProgress())
        m_events.emplace_back(*progress);
}

void SearchTask::end(Result result) {
    m_ended = Ended{std::move(result), *std::exchange(m_discovery, std::nullopt)};
}

}  // namespace nmc::bus
