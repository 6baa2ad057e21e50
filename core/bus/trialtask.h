// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "bus/chain.h"
#include "bus/task.h"

namespace nmc::bus {

/// Gains being tried, each on its servo: sends them, watches every position that the module reports, and
/// restores the previous gains at the first sign that the new ones do not hold it (trialwatch.h), when the
/// servo goes off, when the time is over, and when anything else is requested of the module, unless they have
/// been kept or others were set by then. This is done here because a loop runs away within milliseconds, and
/// the requesting thread may hang.
///
/// Commands without an answer are repeated for as long as the chain is there. Each trial ends in exactly one
/// OperationFinished: once the previous gains are in force, or it is unknown whether they are.
class TrialTask : public Task {
public:
    using Task::Task;

    /// Returns false if the module is not there, or gains are already being tried on it.
    [[nodiscard]] bool begin(const Operation& operation);
    /// Keeps the gains being tried, unless the trial has already ended.
    void keep(ModuleIndex module);
    /// Something else is requested of these modules.
    void leave(const std::vector<ModuleIndex>& modules);
    /// The module has other gains, or none.
    void forget(ModuleIndex module);
    /// The gains that this request of the task sets are not to be tried any more, nor sent again.
    [[nodiscard]] bool isOver(const Ask& ask) const;
    /// A module that restarted has no gains; one that does not answer gets the previous ones once it does.
    void noteLosses();
    void forgetAll();
    /// The chain was found again, unchanged: gains that must be restored still have to be.
    void rejoin(const Chain& before);

    /// Takes any report of a module.
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
};

}  // namespace nmc::bus
