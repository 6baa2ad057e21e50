// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "bus/exchangerecord.h"
#include "bus/line.h"
#include "bus/task.h"

namespace nmc::bus {

/// Records every exchange for the packet monitor while it is shown; initially off, at no cost.
class ExchangeRecorder {
public:
    explicit ExchangeRecorder(Line& line) : m_line(line) {}

    void set(bool on);
    void add(const Ask& ask, const ReplyEnd& end);
    /// Adds an exchange that was sent, but whose end is not awaited any more.
    void addAbandoned(const Ask& ask, TimePoint sent, TimePoint now);
    /// Adds what scripts have sent since the last call, before what followed; `purpose` applies to packets
    /// other than nulls.
    void addUnanswered(Purpose purpose);
    [[nodiscard]] std::vector<ExchangeRecord> take() { return std::exchange(m_records, {}); }

private:
    Line& m_line;
    bool m_on = false;  ///< see set(); nothing is recorded while off
    std::uint64_t m_recorded = 0;
    std::vector<ExchangeRecord> m_records;
};

}  // namespace nmc::bus
