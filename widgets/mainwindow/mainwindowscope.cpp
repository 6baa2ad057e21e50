// SPDX-License-Identifier: GPL-3.0-or-later
// What the window hands to its scope.
#include <algorithm>
#include <utility>

#include "model/module/modulescale.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/scope/scopepanel.h"

namespace nmc {

/// Without a connection the scope still shows what was, and whose it was.
void MainWindow::showScopeModules() {
    if (m_link.modules.empty())
        return;
    std::vector<ScopeModule> modules;
    for (const ModuleState& module : m_link.modules) {
        const AxisSettings& axis = m_machine.axis(module.info.index);
        modules.push_back(
            {texts::moduleName(module.info.index), module.info.identity, scaleOf(module, axis), axis.analog});
    }
    m_scope->showModules(std::move(modules), selectedModule());
    m_scope->showSession(QString::fromStdString(m_link.port), m_link.simulated);
}

const std::vector<ScopeModule>& MainWindow::scopeModules() const {
    return m_scope->modules();
}

void MainWindow::showHistory(const History& history, TimePoint now) {
    m_scope->showHistory(history, now);
    if (m_link.phase != LinkPhase::Disconnected)
        showTime(now);
}

void MainWindow::showTime(TimePoint now) {
    m_link.now = now;
    if (liveModules() != m_live)
        showModules();
    else if (const ModuleState* module = selectedState(); module != nullptr && ageOf(*module).has_value())
        showSelected();
}

void MainWindow::showRecord(std::shared_ptr<const ScopeRecord> record) {
    showDockOf(*m_scope);
    m_scope->showRecord(std::move(record));
}

std::vector<ModuleIndex> MainWindow::watchedModules() const {
    std::vector<ModuleIndex> watched = m_scope->setup().fixedModules();
    const std::optional<ModuleIndex> selected = selectedModule();
    if (selected && std::find(watched.begin(), watched.end(), *selected) == watched.end())
        watched.push_back(*selected);
    return watched;
}

}  // namespace nmc
