// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/steppanel.h"

#include <QHBoxLayout>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/panels/panelhead.h"
#include "widgets/panels/stepdetailsbox.h"
#include "widgets/panels/stepiobox.h"
#include "widgets/panels/stepmotionbox.h"
#include "widgets/panels/stepparametersbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// Stops are never held back; everything else waits for the answer to the click before.
bool isStop(const Intent& intent) {
    return std::holds_alternative<intent::StopSmoothly>(intent) ||
           std::holds_alternative<intent::StopAbruptly>(intent) ||
           std::holds_alternative<intent::MotorOff>(intent);
}
}  // namespace

StepPanel::StepPanel(QWidget* parent)
    : QWidget(parent),
      m_head(new PanelHead(PanelHead::Drive::Stepper, this)),
      m_motion(new StepMotionBox(this)),
      m_pages(new QTabWidget(this)),
      m_parameters(new StepParametersBox(this)),
      m_io(new StepIoBox(this)),
      m_details(new StepDetailsBox(this)) {
    look::name(this, u"stepPanel"_s, tr("Stepper module"));
    look::name(m_pages, u"stepPages"_s, tr("Parameters, inputs and outputs, details"));
    m_pages->setDocumentMode(true);
    m_pages->addTab(m_parameters, tr("Parameters"));
    m_pages->addTab(m_io, tr("I/O"));
    m_pages->addTab(m_details, tr("Details"));  // homing goes before it
    m_pages->tabBar()->setAccessibleName(tr("Pages of the module"));
    m_pages->tabBar()->setObjectName(u"stepPagesBar"_s);

    const int unit = look::gridUnit(this);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(unit * 3 / 2);
    columns->addWidget(m_motion, 5);
    columns->addWidget(m_pages, 4);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(unit, unit / 2, unit, unit);
    layout->setSpacing(unit / 2);
    layout->addWidget(m_head);
    layout->addLayout(columns, 1);

    connect(m_head, &PanelHead::intentRequested, this, &StepPanel::pass);
    connect(m_motion, &StepMotionBox::intentRequested, this, &StepPanel::pass);
    connect(m_parameters, &StepParametersBox::intentRequested, this, &StepPanel::pass);
    connect(m_io, &StepIoBox::intentRequested, this, &StepPanel::pass);
    connect(m_details, &StepDetailsBox::intentRequested, this, &StepPanel::pass);
    connect(m_motion, &StepMotionBox::settingsEdited, this, &StepPanel::passSettings);
    connect(m_parameters, &StepParametersBox::settingsEdited, this, &StepPanel::passSettings);
    connect(m_io, &StepIoBox::settingsEdited, this, &StepPanel::passSettings);
    connect(m_motion, &StepMotionBox::holdRequested, this, &StepPanel::holdRequested);
    connect(m_motion, &StepMotionBox::holdReleased, this, &StepPanel::holdReleased);
}

void StepPanel::pass(const Intent& intent) {
    if (!isStop(intent)) {
        if (m_askedAt.has_value())
            return;
        m_askedAt = m_latestTime;
        setBusy(true);
    }
    emit intentRequested(m_module, intent);
}

void StepPanel::passSettings(const AxisSettings& settings) {
    emit settingsEdited(m_module, settings);
}

void StepPanel::setBusy(bool busy) {
    m_head->setBusy(busy);
    m_motion->setBusy(busy);
    m_parameters->setBusy(busy);
    m_io->setBusy(busy);
    m_details->setBusy(busy);
}

void StepPanel::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    if (m_askedAt.has_value() &&
        (module.info.index != m_module || module.latestTime != *m_askedAt || !view.connected)) {
        m_askedAt.reset();
        setBusy(false);
    }
    m_module = module.info.index;
    m_latestTime = module.latestTime;
    const auto why = [module, connected = view.connected](Request request) {
        return connected ? whyNot(request, module) : std::optional(Refusal::NotConnected);
    };
    m_head->showModule(module, why, view.age);
    m_motion->showModule(view);
    m_parameters->showModule(view);
    m_io->showModule(view);
    m_details->showModule(view);
}

void StepPanel::resetSpeeds() {
    m_motion->resetSpeeds();
}

void StepPanel::endHold() {
    m_motion->endHold();
}

void StepPanel::setHoldInterval(int milliseconds) {
    m_motion->setHoldInterval(milliseconds);
}

}  // namespace nmc
