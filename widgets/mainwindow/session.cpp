// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/session.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "model/module/modulescale.h"
#include "model/settings/pinsof.h"
#include "widgets/common/texts.h"

namespace nmc {

void Session::setLink(const LinkState& state) {
    LinkState next = state;
    if (next.unplugged)
        next.modules = m_link.modules;  // the last reports are all that is known
    const auto identity = [](const ModuleState& module) { return module.info.identity; };
    if (!std::ranges::equal(next.modules, m_link.modules, {}, identity, identity))
        m_machine = usable(m_usersMachine, next.modules);
    next.take(m_usersMachine);
    const LinkState before = std::exchange(m_link, asShown(std::move(next)));
    m_link.now = before.now;
    // One that is opened as soon as the last one has closed is not seen disconnected in between.
    const bool sameConnection = state.connection == before.connection;
    const LinkPhase phase = sameConnection ? before.phase : LinkPhase::Disconnected;
    const bool another = state.phase != before.phase || !sameConnection || state.port != before.port ||
                         state.simulated != before.simulated || state.readOnly != before.readOnly ||
                         state.lent != before.lent;
    if (state.phase != phase && state.phase == LinkPhase::Connecting) {
        m_procedures.clear();
        m_link.now.reset();
    }
    m_disconnectWhenStopped = m_disconnectWhenStopped && sameConnection && isOpen();
    m_live = liveModules();
    if (another)
        emit phaseChanged(phase);
    emit changed();
}

void Session::setMachine(const Machine& machine) {
    m_usersMachine = machine;
    m_machine = usable(machine, m_link.modules);
    m_link.take(m_usersMachine);
    QStringList names;
    for (const AxisSettings& axis : machine.axes)
        names.append(QString::fromStdString(axis.name));
    texts::setModuleNames(names);
    emit changed();
}

void Session::setProcedure(const ProcedureReport& report) {
    m_procedures.insert_or_assign(report.module, report);
    emit changed();
}

void Session::setNow(TimePoint now) {
    m_link.now = now;
    std::vector<bool> live = liveModules();
    if (std::exchange(m_live, live) != live)
        emit changed();
    else if (std::ranges::find(live, false) != live.end())
        emit aged();
}

void Session::select(ModuleIndex module) {
    if (std::exchange(m_selected, module.value()) != module.value())
        emit selectionChanged();
}

const ModuleState* Session::selected() const {
    const auto& modules = m_link.modules;
    return modules.empty() ? nullptr : &modules[std::min(m_selected, modules.size() - 1)];
}

std::vector<bool> Session::liveModules() const {
    std::vector<bool> live;
    for (const ModuleState& module : m_link.modules)
        live.push_back(isLive(m_link, module));
    return live;
}

std::optional<double> Session::ageOf(const ModuleState& module) const {
    if (!module.latest || isLive(m_link, module))
        return std::nullopt;
    return m_link.now ? toSeconds(*m_link.now - module.latestTime) : 0.0;
}

PanelView Session::viewOf(const ModuleState& module) const {
    const auto procedure = m_procedures.find(module.info.index);
    return {module,
            m_machine.axis(module.info.index),
            procedure != m_procedures.end() ? &procedure->second : nullptr,
            m_link.phase == LinkPhase::Connected || module.lookedFor,
            ageOf(module),
            namesakeOf(module.info.index)};
}

std::optional<ModuleIndex> Session::namesakeOf(ModuleIndex module) const {
    const std::string& name = m_machine.axis(module).name;
    if (name.empty())
        return std::nullopt;
    const auto found = std::ranges::find_if(m_link.modules, [&](const ModuleState& other) {
        return other.info.index != module && m_machine.axis(other.info.index).name == name;
    });
    return found != m_link.modules.end() ? std::optional(found->info.index) : std::nullopt;
}

std::vector<ScopeModule> Session::scopeModules() const {
    std::vector<ScopeModule> modules;
    for (const ModuleState& module : m_link.modules) {
        const AxisSettings& axis = m_machine.axis(module.info.index);
        modules.push_back({texts::moduleName(module.info.index), module.info.identity, scaleOf(module, axis),
                           axis.analog, travelRange(module), pinsOf(axis)});
    }
    return modules;
}

int Session::movingMotors() const {
    if (!isOpen())
        return 0;
    return static_cast<int>(std::ranges::count_if(m_link.modules, [this](const ModuleState& module) {
        // The last request to a motor that is on may have started it, although no status has shown that yet.
        const bool asked = module.awaited && module.driveOn();
        return module.stillMoves() || asked || procedureMoves(module.info.index);
    }));
}

/// A procedure may already have sent the command that starts the motor, although no status has shown that
/// yet.
bool Session::procedureMoves(ModuleIndex module) const {
    const auto found = m_procedures.find(module);
    return found != m_procedures.end() && !found->second.over() &&
           found->second.kind != ProcedureKind::TryGains;
}

std::function<QString()> Session::whileOpen(QString (*text)(int movingMotors)) const {
    return [this, text, connection = m_link.connection] {
        return isOpen() && m_link.connection == connection ? text(movingMotors()) : QString();
    };
}

void Session::stopFinished(bool allStopped) {
    if (std::exchange(m_disconnectWhenStopped, false) && allStopped)
        emit disconnectRequested();
}

}  // namespace nmc
