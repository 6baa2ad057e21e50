// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/simulator/simulatordock.h"

#include <QAction>

#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/simulator/simulatorbench.h"

namespace nmc {

using namespace Qt::StringLiterals;

SimulatorDock::SimulatorDock(QWidget* parent) : QDockWidget(Common::tr("Simulator"), parent) {
    look::name(this, u"simulatorDock"_s, windowTitle());
    connect(toggleViewAction(), &QAction::triggered, this, &SimulatorDock::want);
}

void SimulatorDock::build() {
    m_bench = new SimulatorBench(this);
    connect(m_bench, &SimulatorBench::lineEntered, this, &SimulatorDock::lineEntered);
    setWidget(m_bench);
}

void SimulatorDock::setWanted(bool wanted) {
    m_wanted = wanted;
    appear();
}

void SimulatorDock::want(bool wanted) {
    m_wanted = wanted;
    emit wantedChanged(wanted);
}

void SimulatorDock::closeEvent(QCloseEvent* event) {
    QDockWidget::closeEvent(event);
    want(false);  // only the user closes it: hide() sends no close event
}

void SimulatorDock::appear() {
    toggleViewAction()->setVisible(m_attached.has_value());
    setVisible(m_attached && m_wanted);
}

void SimulatorDock::showLink(const LinkState& link) {
    const auto attached = link.simulated && link.isOpen() ? std::optional(link.connection) : std::nullopt;
    if (attached && m_bench == nullptr)
        build();
    if (attached && attached != m_attached)
        m_bench->begin();
    m_attached = attached;
    if (m_bench != nullptr)
        m_bench->offerModules(static_cast<int>(link.modules.size()));
    appear();
}

void SimulatorDock::showSelected(std::optional<ModuleIndex> module) {
    if (m_bench != nullptr)
        m_bench->showSelected(module);
}

void SimulatorDock::showAnswer(const QString& line, const QByteArray& json) {
    if (m_bench != nullptr)
        m_bench->showAnswer(line, json);
}

}  // namespace nmc
