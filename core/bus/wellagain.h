// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "bus/chain.h"
#include "bus/task.h"

namespace nmc::bus {

/// After a link, or a single module, was given up because of errors: queries the identity of those given up,
/// one after the other, believes nothing else, and reports when all answers have been right for long enough
/// that another start is worthwhile. Only Read Status is sent, and no motor moves. Pure.
class WellAgain : public Task {
public:
    /// Required time without a wrong or missing answer.
    static constexpr Duration kWell = std::chrono::seconds(2);
    static constexpr Duration kBetween = std::chrono::milliseconds(100);

    using Task::Task;

    /// `whole`: the link was given up, and not single modules.
    void begin(bool whole, TimePoint now);
    /// The line is well again; returned once.
    [[nodiscard]] bool takeWell() { return std::exchange(m_well, false); }

    // ---- Task ----
    [[nodiscard]] bool wants(TimePoint now) const override { return m_due && now >= *m_due; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override {
        if (change.kind == Change::Kind::Search)
            m_due.reset();
        return false;
    }
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override { return m_due; }

private:
    [[nodiscard]] bool asks(const Chain::Module& module) const;

    bool m_whole = false;
    std::optional<TimePoint>
        m_due;  ///< of the next query, since begin(), until the line is well or another search
    std::optional<TimePoint> m_since;  ///< since when all answers have been right
    std::size_t m_at = 0;
    bool m_well = false;
};

}  // namespace nmc::bus
