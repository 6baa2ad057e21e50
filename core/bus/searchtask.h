// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <variant>

#include "bus/discovery.h"
#include "bus/task.h"

namespace nmc::bus {

/// Searches for the chain (discovery.h). The engine takes what was found, or why nothing was. A search that
/// fails because answers were wrong or late is repeated with more patience, as long as it has changed
/// nothing: the line may have been disturbed, or this computer busy, for a moment.
class SearchTask : public Task {
public:
    /// Number of searches until such a failure is reported.
    static constexpr unsigned kAttempts = 3;

    using Task::Task;

    void begin(const EngineConfig& config, Discovery::Start start);
    /// It has begun to assign addresses, and continues with that.
    [[nodiscard]] bool givesAddresses() const { return m_discovery && m_discovery->givesAddresses(); }
    [[nodiscard]] bool active() const { return m_discovery.has_value(); }

    /// The number of modules seen so far.
    [[nodiscard]] std::size_t seen() const { return m_discovery ? m_discovery->seen() : 0; }
    /// It has begun to assign addresses: what was known about the modules no longer holds. Returned once.
    [[nodiscard]] bool takeGivesAddresses() { return std::exchange(m_givesAddresses, false); }

    using Result = std::variant<ChainFound, ConnectFailed>;
    struct Ended {
        Result result;
        Discovery discovery;
    };
    /// The end of the search; returned once.
    [[nodiscard]] std::optional<Ended> takeEnded() { return std::exchange(m_ended, std::nullopt); }

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return active(); }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    void reportProgress();
    [[nodiscard]] bool takeLateBytes();
    [[nodiscard]] bool mayPass(const ConnectFailed& failed) const;
    [[nodiscard]] bool repeat(const ConnectFailed& failed);
    void end(Result result);

    EngineConfig m_config;
    Discovery::Start m_start = Discovery::Start::Look;
    std::optional<Discovery> m_discovery;
    unsigned m_failures = 0;
    std::uint64_t m_lateBytes = 0;  ///< that the line has counted until now
    bool m_late = false;            ///< an answer was too late in this search
    bool m_givesAddresses = false;  ///< the first address has been assigned; until taken, once per search
    std::optional<Ended> m_ended;
};

}  // namespace nmc::bus
