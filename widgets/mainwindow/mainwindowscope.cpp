// SPDX-License-Identifier: GPL-3.0-or-later
// What the window passes to its scope.
#include <algorithm>
#include <utility>

#include "widgets/axes/axesdock.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/scope/scopepanel.h"

namespace nmc {

/// Without a connection, the scope still shows the last samples, and whose they are.
void MainWindow::showScopeModules() {
    const LinkState& link = m_session.link();
    if (link.modules.empty())
        return;
    m_scope->showModules(m_session.scopeModules(), selectedModule());
    m_scope->showSession(QString::fromStdString(link.port), link.simulated);
}

const std::vector<ScopeModule>& MainWindow::scopeModules() const {
    return m_scope->modules();
}

void MainWindow::showHistory(const History& history, TimePoint now) {
    m_scope->showHistory(history, now);
    if (m_session.isOpen())
        showTime(now);
}

void MainWindow::showTime(TimePoint now) {
    m_session.setNow(now);
}

void MainWindow::showRecord(std::shared_ptr<const ScopeRecord> record) {
    showDockOf(*m_scope);
    m_scope->showRecord(std::move(record));
}

void MainWindow::showUnder(std::shared_ptr<const ScopeRecord> record) {
    showDockOf(*m_scope);
    m_scope->showUnder(std::move(record));
}

std::vector<ModuleIndex> MainWindow::watchedModules() const {
    std::vector<ModuleIndex> watched = m_scope->setup().fixedModules();
    if (m_axes->seen())
        for (const ModuleState& module : m_session.link().modules)
            if (std::find(watched.begin(), watched.end(), module.info.index) == watched.end())
                watched.push_back(module.info.index);
    const std::optional<ModuleIndex> selected = selectedModule();
    if (selected && std::find(watched.begin(), watched.end(), *selected) == watched.end())
        watched.push_back(*selected);
    return watched;
}

}  // namespace nmc
