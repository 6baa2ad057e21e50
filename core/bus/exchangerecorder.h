// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/exchangerecord.h"
#include "bus/line.h"
#include "bus/task.h"

namespace nmc::bus {

/// Keeps every exchange for the packet monitor while somebody looks at it; off at first, and then without
/// cost.
class ExchangeRecorder {
public:
    explicit ExchangeRecorder(Line& line) : m_line(line) {}

    void set(bool on);
    void add(const Ask& ask, const ReplyEnd& end, std::optional<Rejection> rejection);
    /// It went out, and nobody waits for its end any more.
    void addAbandoned(const Ask& ask, TimePoint sent, TimePoint now);
    /// What scripts sent since the last time, in front of what came after it; `purpose`: but for nulls.
    void addUnanswered(Purpose purpose);
    [[nodiscard]] std::vector<ExchangeRecord> take();

private:
    void add(const Ask& ask, const ReplyEnd& end, ExchangeEnd how, std::optional<Rejection> rejection);

    Line& m_line;
    bool m_on = false;  ///< as of set(); off, nothing is kept
    std::uint64_t m_recorded = 0;
    std::vector<ExchangeRecord> m_records;
};

}  // namespace nmc::bus
