// SPDX-License-Identifier: MIT
#include "bus/searchtask.h"

namespace nmc::bus {

void SearchTask::begin(const EngineConfig& config, Discovery::Start start) {
    m_config = config;
    m_start = start;
    m_ended.reset();
    m_failures = 0;
    m_givesAddresses = false;
    m_late = false;
    m_lateBytes = m_line.statistics().staleBytes;
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
        if (m_failures > 0 || m_discovery->expectsLateAnswers())
            ask->request.patience = kSchedulingDelay;
        return std::move(*ask);
    }
    if (auto* found = std::get_if<ChainFound>(&next))
        end(std::move(*found));
    else if (auto& failed = std::get<ConnectFailed>(next); !repeat(failed))
        end(std::move(failed));
    return Again{};
}

/// The line, or this computer, may have been disturbed for a moment.
bool SearchTask::mayPass(const ConnectFailed& failed) const {
    using enum ConnectFailure;
    if (m_discovery->givesAddresses())
        return failed.reason == Collision && m_discovery->addressed();
    if (failed.reason == Unaddressed || failed.reason == RateChange)
        return false;
    return failed.reason != NobodyAnswers || (m_late && !m_line.echoes());
}

bool SearchTask::repeat(const ConnectFailed& failed) {
    if (!mayPass(failed) || ++m_failures == kAttempts)
        return false;
    if (m_discovery->addressed())
        m_discovery->queryModules();
    else
        m_discovery.emplace(m_config, m_start);
    return true;
}

Line::Script SearchTask::onEnd(const Ask& /*ask*/, const ReplyEnd& end, TimePoint /*now*/) {
    if (!m_discovery)
        return {};
    if (takeLateBytes()) {
        m_late = true;
        m_discovery->onLateBytes();
    }
    m_discovery->onReply(end);
    return {};
}

/// Bytes outside of an exchange may be answers that came too late, unless they are an echo.
bool SearchTask::takeLateBytes() {
    const std::uint64_t before = std::exchange(m_lateBytes, m_line.statistics().staleBytes);
    return before != m_lateBytes && !m_line.echoes();
}

void SearchTask::reportProgress() {
    if (const auto progress = m_discovery->takeProgress())
        m_events.emplace_back(*progress);
}

void SearchTask::end(Result result) {
    m_ended = Ended{std::move(result), *std::exchange(m_discovery, std::nullopt)};
}

}  // namespace nmc::bus
