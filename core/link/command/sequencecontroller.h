// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "link/command/procedurecontroller.h"
#include "link/connection/busstore.h"
#include "link/dryrun/dryrun.h"
#include "link/files/backgroundjob.h"
#include "model/sequence/sequencerun.h"

namespace nmc {

/// Runs one sequence at a time: requests its next step whenever there is an event, and 20 times a second, and
/// carries it out like the panel's own requests. Predicts a sequence in the background. GUI thread.
class SequenceController : public QObject {
    Q_OBJECT

public:
    using Submit = std::function<bus::OperationId(std::vector<bus::Order>)>;

    SequenceController(BusStore& store, ProcedureController& procedures, Submit submit,
                       QObject* parent = nullptr);

    [[nodiscard]] bool running() const { return m_run && !m_run->report().over(); }
    /// The modules that take part in the running sequence.
    [[nodiscard]] std::set<ModuleIndex> parts() const {
        return running() ? m_run->parts() : std::set<ModuleIndex>{};
    }

    /// Does nothing while another sequence runs. refused() reports what prevents it from running.
    void begin(SequenceRun run);
    void pause() { apply(&SequenceRun::pause); }
    void resume() { apply(&SequenceRun::resume); }
    void step() { apply(&SequenceRun::step); }
    void stop() { apply(&SequenceRun::stop); }

    /// Starts a dry run of the sequence; foreseen() follows unless another one is requested.
    void foresee(const Machine& machine, const std::string& sequence, std::size_t row);
    void endForesight() { m_foresight.cancel(); }

    /// The user requests something of this module; `stops`: a stop of its motor.
    void takeOver(ModuleIndex module, bool stops) { apply(&SequenceRun::onTakenOver, module, stops); }
    /// A stop of all motors begins.
    void stopAll() { apply(&SequenceRun::onStopOfAll); }
    /// Returns false for the end of an operation that is not ours, or whose failure must be reported.
    bool take(const StoreEvent& event);

signals:
    void reported(const nmc::SequenceReport& report);
    void refused(const std::vector<nmc::SequenceProblem>& problems);
    void foreseen(const nmc::DryRun& dryRun);

private:
    [[nodiscard]] const std::string& name() const { return m_run->report().places.front().sequence; }
    template <typename... Of>
    void apply(void (SequenceRun::*what)(Of...), Of... of) {
        if (running())
            (*m_run.*what)(of...);
        advance();
    }
    void look();
    void advance();
    void obey(const SequenceRun::Ask& ask);
    void publish();

    BusStore& m_store;
    ProcedureController& m_procedures;
    Submit m_submit;
    QTimer m_timer;
    std::optional<SequenceRun> m_run;
    std::optional<SequenceReport> m_reported;
    std::vector<bus::OperationId> m_operations;
    std::vector<bus::OperationId> m_stops;  ///< those at the end of the run
    BackgroundJob m_foresight;
    std::shared_ptr<DryRun> m_foreseen;  ///< shared with the job
};

}  // namespace nmc
