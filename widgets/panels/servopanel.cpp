// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/servopanel.h"

#include <QFormLayout>
#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/panels/axisbox.h"
#include "widgets/panels/detailsbox.h"
#include "widgets/panels/directioncheckbox.h"
#include "widgets/panels/gainsbox.h"
#include "widgets/panels/homingbox.h"
#include "widgets/panels/iobox.h"
#include "widgets/panels/jogbox.h"
#include "widgets/panels/motionbox.h"
#include "widgets/panels/panelhead.h"
#include "widgets/panels/pwmbox.h"
#include "widgets/panels/stepbybox.h"

namespace nmc {

using namespace Qt::StringLiterals;

ServoPanel::ServoPanel(QWidget* parent)
    : ModulePage(parent),
      m_head(new PanelHead(PanelHead::Drive::Servo, this)),
      m_motion(new MotionBox(this)),
      m_jog(new JogBox(this)),
      m_step(new StepByBox(this)),
      m_pages(new QTabWidget(this)),
      m_gains(new GainsBox(this)),
      m_io(new IoBox(this)),
      m_homing(new HomingBox(this)),
      m_pwm(new PwmBox(this)),
      m_axis(new AxisBox(this)),
      m_direction(new DirectionCheckBox(m_axis)),
      m_details(new DetailsBox(this)) {
    look::name(this, u"servoPanel"_s, tr("Servo module"));
    look::name(m_pages, u"servoPages"_s, tr("Pages of the module"));
    m_pages->addTab(m_gains, tr("Gains"));
    m_pages->addTab(m_io, tr("Limits && I/O"));
    m_pages->addTab(m_homing, tr("Homing"));
    m_pages->addTab(m_pwm, tr("PWM"));
    m_pages->addTab(m_axis, tr("Axis"));
    qobject_cast<QFormLayout*>(m_axis->layout())->addRow(m_direction);
    m_pages->addTab(m_details, tr("Details"));

    auto* left = new QVBoxLayout;
    left->setSpacing(look::gridUnit(this) / 2);
    left->addWidget(m_motion);
    left->addWidget(m_jog);
    left->addWidget(m_step);
    left->addStretch(1);
    layOut(m_head, left, m_pages);
    connectBoxes();
}

void ServoPanel::connectBoxes() {
    connect(m_head, &PanelHead::intentRequested, this, &ServoPanel::pass);
    connect(m_motion, &MotionBox::intentRequested, this, &ServoPanel::pass);
    connect(m_step, &StepByBox::intentRequested, this, &ServoPanel::pass);
    connect(m_step, &StepByBox::settingsEdited, this, &ServoPanel::passEdit);
    connect(m_io, &IoBox::intentRequested, this, &ServoPanel::pass);
    connect(m_pwm, &PwmBox::intentRequested, this, &ServoPanel::pass);
    connect(m_details, &DetailsBox::intentRequested, this, &ServoPanel::pass);
    connect(m_direction, &DirectionCheckBox::intentRequested, this, &ServoPanel::pass);
    connect(m_homing, &HomingBox::intentRequested, this, &ServoPanel::pass);
    connect(m_homing, &HomingBox::settingsEdited, this, &ServoPanel::passEdit);
    connect(m_gains, &GainsBox::applyRequested, this,
            [this](const servo::SetGain& gains) { pass(intent::ApplyGains{gains}); });
    connect(m_gains, &GainsBox::stepResponseWanted, this, &ServoPanel::stepResponseWanted);
    connect(m_jog, &JogBox::holdRequested, this, &ServoPanel::holdRequested);
    connect(m_jog, &JogBox::holdReleased, this, &ServoPanel::holdReleased);
    connect(m_motion, &MotionBox::accelerationEdited, m_jog, &JogBox::endHold);
    connect(m_motion, &MotionBox::settingsEdited, this, &ServoPanel::passEdit);
    connect(m_gains, &GainsBox::settingsEdited, this, &ServoPanel::passEdit);
    connect(m_axis, &AxisBox::settingsEdited, this, &ServoPanel::passEdit);
}

void ServoPanel::setBusy(bool busy) {
    m_head->setBusy(busy);
    m_motion->setBusy(busy);
    m_step->setBusy(busy);
    m_gains->setBusy(busy);
    m_io->setBusy(busy);
    m_pwm->setBusy(busy);
    m_homing->setBusy(busy);
    m_direction->setBusy(busy);
    m_details->setBusy(busy);
}

void ServoPanel::showBoxes(const PanelView& view) {
    m_head->showModule(view);
    m_motion->showModule(view);
    m_jog->showModule(view, m_motion->acceleration());
    m_step->showModule(view, {m_motion->velocity(), m_motion->acceleration()});
    m_gains->showModule(view);
    m_io->showModule(view);
    m_homing->showModule(view);
    m_pwm->showModule(view);
    m_axis->showModule(view);
    m_direction->showModule(view);
    m_details->showModule(view);
}

void ServoPanel::stageGains(const servo::SetGain& gains) {
    m_pages->setCurrentWidget(m_gains);
    m_gains->stage(gains);
}

void ServoPanel::resetSpeeds() {
    m_motion->forgetGoals();
    m_jog->resetSpeeds();
}

void ServoPanel::endHold() {
    m_jog->endHold();
}

void ServoPanel::setHoldInterval(int milliseconds) {
    m_jog->setHoldInterval(milliseconds);
}

}  // namespace nmc
