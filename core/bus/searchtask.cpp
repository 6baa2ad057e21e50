// SPDX-License-Identifier: MIT
#include "bus/searchtask.h"

namespace nmc::bus {

void SearchTask::begin(const EngineConfig& config, Discovery::Start start) {
    m_config = config;
    m_start = start;
    m_ended.reset();
    m_failures = 0;
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
    if (auto* ask = std::get_if<Ask>(&next)) {
        if (m_failures > 0)
            ask->request.patience = kSchedulingDelay;
        return std::move(*ask);
    }
    if (auto* found = std::get_if<ChainFound>(&next))
        end(std::move(*found));
    else if (auto& failed = std::get<ConnectFailed>(next); repeats(failed))
        m_discovery.emplace(m_config, m_start);
    else
        end(std::move(failed));
    return Again{};
}

bool SearchTask::repeats(const ConnectFailed& failed) {
    using enum ConnectFailure;
    if (m_discovery->givesAddresses() || failed.reason == Unaddressed || failed.reason == RateChange)
        return false;
    // Bytes outside of an exchange may be answers that came too late, unless they are an echo.
    const bool heard = m_line.statistics().staleBytes > 0 && !m_line.echoes();
    if (failed.reason == NobodyAnswers && !heard)
        return false;
    return ++m_failures < kAttempts;
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
