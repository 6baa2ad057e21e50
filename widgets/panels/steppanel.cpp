// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/steppanel.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/panels/axisbox.h"
#include "widgets/panels/homingbox.h"
#include "widgets/panels/panelhead.h"
#include "widgets/panels/stepdetailsbox.h"
#include "widgets/panels/stepiobox.h"
#include "widgets/panels/stepmotionbox.h"
#include "widgets/panels/stepparametersbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepPanel::StepPanel(QWidget* parent)
    : ModulePage(parent),
      m_head(new PanelHead(PanelHead::Drive::Stepper, this)),
      m_motion(new StepMotionBox(this)),
      m_pages(new QTabWidget(this)),
      m_parameters(new StepParametersBox(this)),
      m_io(new StepIoBox(this)),
      m_homing(new HomingBox(this, ModuleType::Step)),
      m_axis(new AxisBox(this, ModuleType::Step)),
      m_details(new StepDetailsBox(this)) {
    look::name(this, u"stepPanel"_s, tr("Stepper module"));
    look::name(m_pages, u"stepPages"_s, tr("Pages of the module"));
    m_pages->addTab(m_parameters, tr("Parameters"));
    m_pages->addTab(m_io, tr("I/O"));
    m_pages->addTab(m_homing, tr("Homing"));
    m_pages->addTab(m_axis, tr("Axis"));
    m_pages->addTab(m_details, tr("Details"));

    auto* motion = new QVBoxLayout;
    motion->addWidget(m_motion);
    layOut(m_head, motion, m_pages);

    connect(m_head, &PanelHead::intentRequested, this, &StepPanel::pass);
    connect(m_motion, &StepMotionBox::intentRequested, this, &StepPanel::pass);
    connect(m_parameters, &StepParametersBox::intentRequested, this, &StepPanel::pass);
    connect(m_io, &StepIoBox::intentRequested, this, &StepPanel::pass);
    connect(m_homing, &HomingBox::intentRequested, this, &StepPanel::pass);
    connect(m_homing, &HomingBox::settingsEdited, this, &StepPanel::passEdit);
    connect(m_axis, &AxisBox::settingsEdited, this, &StepPanel::passEdit);
    connect(m_details, &StepDetailsBox::intentRequested, this, &StepPanel::pass);
    connect(m_motion, &StepMotionBox::settingsEdited, this, &StepPanel::passEdit);
    connect(m_parameters, &StepParametersBox::settingsEdited, this, &StepPanel::passEdit);
    connect(m_io, &StepIoBox::settingsEdited, this, &StepPanel::passEdit);
    connect(m_motion, &StepMotionBox::holdRequested, this, &StepPanel::holdRequested);
    connect(m_motion, &StepMotionBox::holdReleased, this, &StepPanel::holdReleased);
}

void StepPanel::setBusy(bool busy) {
    m_head->setBusy(busy);
    m_motion->setBusy(busy);
    m_parameters->setBusy(busy);
    m_io->setBusy(busy);
    m_homing->setBusy(busy);
    m_details->setBusy(busy);
}

void StepPanel::showBoxes(const PanelView& view) {
    m_head->showModule(view);
    m_motion->showModule(view);
    m_parameters->showModule(view);
    m_io->showModule(view);
    m_homing->showModule(view);
    m_axis->showModule(view);
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
