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

/// What the window shows, as values: connection, machine and procedures as they may be shown, their age, and
/// what follows for the user. Uses no widget. GUI thread.
class Session : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    using Procedures = std::map<ModuleIndex, ProcedureReport>;

    void setLink(const LinkState& state);
    /// From now on, all texts contain its names.
    void setMachine(const Machine& machine);
    /// The last report of each module is kept until another chain is searched for.
    void setProcedure(const ProcedureReport& report);
    /// Sets the present time: the last reports may have become old by now.
    void setNow(TimePoint now);

    [[nodiscard]] const LinkState& link() const { return m_link; }
    /// The machine as usable() for the modules that are shown.
    [[nodiscard]] const Machine& machine() const { return m_machine; }
    [[nodiscard]] const Procedures& procedures() const { return m_procedures; }

    [[nodiscard]] bool isOpen() const { return m_link.isOpen(); }
    /// The user has selected a module: panel, scope and simulator show it, and it is polled most.
    void select(ModuleIndex module);
    /// Null while there is no module. The first of a chain is selected until the user selects another; in a
    /// later chain, the module at the same place is, or the last one.
    [[nodiscard]] const ModuleState* selected() const;
    /// What the module's panel shows; valid until the next call that sets something.
    [[nodiscard]] PanelView viewOf(const ModuleState& module) const;
    /// How the scope reads the modules.
    [[nodiscard]] std::vector<ScopeModule> scopeModules() const;
    /// Number of motors that are seen to move, may just have been started, or are moved by a procedure or
    /// about to be.
    [[nodiscard]] int movingMotors() const;
    /// A read-only connection leaves the motors as they are.
    [[nodiscard]] bool leavingStopsMotors() const { return !m_link.readOnly && movingMotors() > 0; }
    /// Returns a function for a question that stays open until this connection has ended: it returns the
    /// question's present text, which is empty after that.
    [[nodiscard]] std::function<QString()> whileOpen(QString (*text)(int movingMotors)) const;

    /// The stop that was requested is to end this connection if all motors stop.
    void disconnectWhenStopped() { m_disconnectWhenStopped = true; }
    void stopFinished(bool allStopped);

signals:
    void selectionChanged();
    /// The connection or its phase has changed; changed() follows. `before`: its phase, Disconnected if there
    /// was another connection.
    void phaseChanged(nmc::LinkPhase before);
    void changed();
    /// Only the age of what is shown has changed.
    void aged();
    void disconnectRequested();

private:
    [[nodiscard]] std::optional<ModuleIndex> namesakeOf(ModuleIndex module) const;
    [[nodiscard]] std::optional<double> ageOf(const ModuleState& module) const;
    [[nodiscard]] std::vector<bool> liveModules() const;
    [[nodiscard]] bool procedureMoves(ModuleIndex module) const;

    std::size_t m_selected = 0;  ///< its place in the chain; kept while there is none
    LinkState m_link;            ///< as it may be shown
    std::vector<bool> m_live;    ///< of its modules, as last reported by a signal
    Machine m_usersMachine;
    Machine m_machine;
    Procedures m_procedures;
    bool m_disconnectWhenStopped = false;
};

}  // namespace nmc
