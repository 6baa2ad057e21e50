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

/// Runs one sequence at a time: asks it what is next whenever there is news, and 20 times a second, and
/// carries that out as the panel's own requests are. Foresees a sequence in the background. GUI thread.
class SequenceController : public QObject {
    Q_OBJECT

public:
    using Submit = std::function<bus::OperationId(std::vector<bus::Order>)>;

    SequenceController(BusStore& store, ProcedureController& procedures, Submit submit,
                       QObject* parent = nullptr);

    [[nodiscard]] bool running() const { return m_run && !m_run->report().over(); }
    /// The modules of what runs.
    [[nodiscard]] std::set<ModuleIndex> parts() const {
        return running() ? m_run->parts() : std::set<ModuleIndex>{};
    }

    /// Nothing while another runs. What keeps it from running is told by refused().
    void start(const Machine& machine, const std::string& sequence, std::size_t row, bool singleStep);
    void goTo(const Machine& machine, const std::string& point);
    /// One axis after the other, by their recipes.
    void home(const Machine& machine, const std::vector<ModuleIndex>& axes);
    void pause();
    void resume();
    void step();
    void stop();

    /// A dry run of it; foreseen() follows, unless another one is asked for.
    void foresee(const Machine& machine, const std::string& sequence, std::size_t row);
    void endForesight() { m_foresight.cancel(); }

    /// The user wants something of this module; `stops`: that its motor stops.
    void takeOver(ModuleIndex module, bool stops);
    /// A stop of all motors begins.
    void stopAll();
    /// False for the end of an operation that is none of ours, or of one whose failure is to be told.
    bool take(const StoreEvent& event);

signals:
    void reported(const nmc::SequenceReport& report);
    void refused(const std::vector<nmc::SequenceProblem>& problems);
    void foreseen(const nmc::DryRun& dryRun);

private:
    void begin(Machine machine, const std::string& sequence, std::size_t row,
               const std::function<SequenceRun()>& make);
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
    BackgroundJob m_foresight;
    std::shared_ptr<DryRun> m_foreseen;  ///< shared with the job
};

}  // namespace nmc
