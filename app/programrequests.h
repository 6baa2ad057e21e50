// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <set>

#include "bus/types.h"
#include "model/intent/intent.h"
#include "model/module/modulestate.h"

namespace nmc {

/// What one program has last requested of each motor, and of the sequences, and what became of it: `wait`
/// reports the latter (docs/api.md). GUI thread.
class ProgramRequests {
public:
    // ---- motors ----

    /// It is about to request this.
    void begin(ModuleIndex module, const Intent& intent);
    /// The request is carried out by this operation.
    void setOperation(ModuleIndex module, bus::OperationId operation) { m_operations[module] = operation; }
    /// It is carried out by the procedure that runs with the module.
    void setProcedure(ModuleIndex module) { m_procedures.insert(module); }
    /// It has requested something else of this module, or knows that its last request is done: what becomes
    /// of that is of no interest.
    void forget(ModuleIndex module);

    /// It moves this motor, and nobody else has commanded it since.
    void setMoved(ModuleIndex module) { m_moved.insert(module); }
    void clearMoved(ModuleIndex module) { m_moved.erase(module); }
    /// Another host may have commanded all motors.
    void clearMoved() { m_moved.clear(); }
    [[nodiscard]] const std::set<ModuleIndex>& moved() const { return m_moved; }

    // ---- sequences ----

    /// It is about to start one, which is then refused or begun, and may be over as soon as it begins.
    void beginSequence() { m_awaitsEnd = true; }
    void sequenceRefused() { m_awaitsEnd = false; }
    void sequenceBegun();
    /// The user or another program has commanded it, or starts another.
    void sequenceTaken() { m_runs = false; }
    /// It has started the sequence that runs, which nobody else has commanded since.
    [[nodiscard]] bool runsSequence() const { return m_runs; }

    // ---- what became of it ----

    /// `module`: its state, null if it is gone.
    void onFinished(const bus::OperationFinished& finished, const ModuleState* module);
    /// A procedure of this motor has ended. `failure`: why it was not done, if it was not.
    void onProcedureOver(ModuleIndex module, const std::optional<QString>& failure);
    /// `failure`: why it was not done, if it was not.
    void onSequenceOver(const std::optional<QString>& failure);

    /// Why the last request of this motor was not carried out to the end, if it was not.
    [[nodiscard]] std::optional<QString> failure(const ModuleState& module) const;
    /// The same for its last sequence, until clearSequenceFailure().
    [[nodiscard]] const std::optional<QString>& sequenceFailure() const { return m_sequenceFailure; }
    void clearSequenceFailure() { m_sequenceFailure.reset(); }

private:
    std::set<ModuleIndex> m_moved;
    std::map<ModuleIndex, bus::OperationId> m_operations;
    std::map<ModuleIndex, QString> m_failures;
    /// Where its last request to a module leads, once that is known.
    std::map<ModuleIndex, std::optional<std::int32_t>> m_goals;
    /// Its last request to these is carried out by a procedure, which has not ended.
    std::set<ModuleIndex> m_procedures;
    bool m_runs = false;       ///< see runsSequence()
    bool m_awaitsEnd = false;  ///< it has started the sequence that runs
    std::optional<QString> m_sequenceFailure;
};

}  // namespace nmc
