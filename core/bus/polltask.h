// SPDX-License-Identifier: MIT
#pragma once

#include "bus/chain.h"
#include "bus/recovery.h"
#include "bus/restartsearch.h"
#include "bus/task.h"

namespace nmc::bus {

/// The regular polls (pollschedule.h), when nothing else needs the line, and the rare ones to silent modules.
class PollTask : public Task {
public:
    PollTask(const Shared& shared, Recovery& recovery, RestartSearch& search)
        : Task(shared), m_recovery(recovery), m_search(search) {}

    [[nodiscard]] bool wants(TimePoint /*now*/) const override { return true; }
    [[nodiscard]] bool pipelines() const override { return true; }
    [[nodiscard]] Next next(TimePoint now) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;
    [[nodiscard]] std::optional<TimePoint> due() const override { return m_chain.schedule().nextDue(); }

private:
    Recovery& m_recovery;
    RestartSearch& m_search;
};

}  // namespace nmc::bus
