// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/task.h"

namespace nmc::bus {

/// Gains that are tried, each on its servo: sends them, watches every position that the module tells, and
/// sends those from before at the first sign that they do not hold it (trialwatch.h), when the servo goes
/// off, when the time is over, and when anything else is asked of the module; unless they were kept by then,
/// or others were set. Here, because a loop runs away within milliseconds, and whoever asked may hang.
///
/// What was not answered is sent again for as long as the chain is there. Each ends in exactly one
/// OperationFinished: once the gains from before are in force, or it is not known whether they are.
class TrialTask : public Task {
public:
    TrialTask(Chain& chain, std::vector<Event>& events) : m_chain(chain), m_events(events) {}

    /// False where the module is not there, or something is being tried on it.
    [[nodiscard]] bool begin(const Operation& operation);
    /// What is being tried stays; too late it does not.
    void keep(ModuleIndex module);
    /// Something else is asked of them.
    void leave(const std::vector<ModuleIndex>& modules);
    /// The module has other gains, or none.
    void forget(ModuleIndex module);
    /// Whoever restarted has no gains; whoever does not answer goes back to those from before once it does.
    void noteLosses();
    void forgetAll();
    /// The chain was found anew, as it was: what has to go back still has to.
    void rejoin(const Chain& before);

    /// What a module says, whoever asked it.
    void onReport(ModuleIndex module, const StatusReport& report, TimePoint latched);

    [[nodiscard]] bool wants(TimePoint now) const override;
    [[nodiscard]] std::optional<TimePoint> due() const override;
    [[nodiscard]] bool pipelines() const override { return true; }
    [[nodiscard]] Next next(TimePoint now) override;
    bool onChange(const Change& change) override;
    Line::Script onEnd(const Ask& ask, const ReplyEnd& end, TimePoint now) override;

private:
    void goBack(Trial& trial, std::optional<TrialEnd> why);
    void report(ModuleIndex module, Outcome outcome);

    Chain& m_chain;
    std::vector<Event>& m_events;
};

}  // namespace nmc::bus
