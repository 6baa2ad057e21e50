// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "model/module/linkstate.h"
#include "model/procedure/procedure.h"
#include "model/settings/machine.h"
#include "widgets/panels/panelview.h"
#include "widgets/scope/scopemodule.h"

namespace nmc {

/// What the window shows, as values: connection, machine and procedures as they may be shown, how old that
/// is, and what follows for the user. Knows no widget. GUI thread.
class Session : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    using Procedures = std::map<ModuleIndex, ProcedureReport>;

    void setLink(const LinkState& state);
    /// From here on its names are the ones in all texts.
    void setMachine(const Machine& machine);
    /// The last one of each module is kept, until another chain is looked for.
    void setProcedure(const ProcedureReport& report);
    /// It is as late as that: what was said may be old by now.
    void setNow(TimePoint now);

    [[nodiscard]] const LinkState& link() const { return m_link; }
    [[nodiscard]] const Machine& machine() const { return m_machine; }
    [[nodiscard]] const Procedures& procedures() const { return m_procedures; }

    [[nodiscard]] bool isOpen() const { return m_link.phase != LinkPhase::Disconnected; }
    /// Null for none.
    [[nodiscard]] const ModuleState* module(std::optional<ModuleIndex> index) const;
    /// What its panel shows; valid until the next call that sets something.
    [[nodiscard]] PanelView viewOf(const ModuleState& module) const;
    /// What the scope knows of them.
    [[nodiscard]] std::vector<ScopeModule> scopeModules() const;
    /// Those that are seen to move, and those that a procedure moves, or is about to.
    [[nodiscard]] int movingMotors() const;
    /// A connection that only looks leaves them as they are.
    [[nodiscard]] bool leavingStopsMotors() const { return !m_link.readOnly && movingMotors() > 0; }
    /// Of a question that stands until this connection is gone: what it says now.
    [[nodiscard]] std::function<QString()> whileOpen(QString (*text)(int movingMotors)) const;

    /// The stop that was asked for is to end this connection, if all stop.
    void disconnectWhenStopped() { m_disconnectWhenStopped = true; }
    void stopFinished(bool allStopped);

signals:
    /// Another connection, or another phase of it; changed() follows.
    void phaseChanged(nmc::LinkPhase before);
    void changed();
    /// Only the age of what is shown.
    void aged();
    void disconnectRequested();

private:
    [[nodiscard]] std::optional<double> ageOf(const ModuleState& module) const;
    [[nodiscard]] std::vector<bool> liveModules() const;
    [[nodiscard]] bool procedureMoves(ModuleIndex module) const;

    LinkState m_link;          ///< as it may be shown
    std::vector<bool> m_live;  ///< of its modules, as they were told of last
    Machine m_machine;
    Procedures m_procedures;
    bool m_disconnectWhenStopped = false;
};

}  // namespace nmc
