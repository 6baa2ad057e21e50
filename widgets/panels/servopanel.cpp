// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/servopanel.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/amplifierbox.h"
#include "widgets/panels/axisbox.h"
#include "widgets/panels/detailsbox.h"
#include "widgets/panels/expertbox.h"
#include "widgets/panels/firststeps.h"
#include "widgets/panels/gainsbox.h"
#include "widgets/panels/holdbutton.h"
#include "widgets/panels/homingbox.h"
#include "widgets/panels/iobox.h"
#include "widgets/panels/jogbox.h"
#include "widgets/panels/motionbox.h"
#include "widgets/panels/movebybox.h"
#include "widgets/panels/panelhead.h"
#include "widgets/panels/pwmbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

ServoPanel::ServoPanel(const PanelView& view, Requests& requests) : ModulePage(view, requests) {
    look::name(this, u"servoPanel"_s, tr("Servo module"));
    auto* head = new PanelHead(m_context, this);
    auto* motion = new MotionBox(m_context, this);
    auto* left = new QVBoxLayout;
    left->setSpacing(look::gridUnit(this) / 2);
    auto* jog = new JogBox(m_context, this);
    auto* moveBy = new MoveByBox(m_context, *motion, this);
    for (QWidget* box : std::initializer_list<QWidget*>{motion, jog, moveBy})
        left->addWidget(box);
    FormGrid::align({motion, jog, moveBy});
    connect(motion, &MotionBox::accelerationEdited, jog, &JogBox::endHold);
    left->addStretch(1);

    m_pages = new QTabWidget(this);
    look::name(m_pages, u"servoPages"_s, Common::tr("Pages of the module"));
    m_gains = new GainsBox(m_context, this);
    m_pages->addTab(m_gains, Common::tr("Gains"));
    m_pages->addTab(new IoBox(m_context, this), tr("Limits && I/O"));
    m_pages->addTab(new HomingBox(m_context, this), Common::tr("Homing"));
    m_pages->addTab(new PwmBox(m_context, this), Common::tr("PWM"));
    m_pages->addTab(new AxisBox(m_context, this), Common::tr("Axis"));
    if (isSc(m_context.state().info.identity))
        m_pages->addTab(new AmplifierBox(m_context, this), Common::tr("Amplifier"));
    m_pages->addTab(new DetailsBox(m_context, this), Common::tr("Details"));
    m_pages->addTab(new ExpertBox(m_context, this), Common::tr("Expert"));
    layOut(head, left, m_pages);
    m_steps = new FirstSteps(m_context, this);
    layout()->addWidget(m_steps);
    connect(m_steps, &FirstSteps::placeWanted, this, &ServoPanel::showPlaceOf);
    connect(m_gains, &GainsBox::responseWanted, this, &ServoPanel::responseWanted);
}

void ServoPanel::showPlaceOf(FirstStep step) {
    switch (step) {
        case FirstStep::FillInGains:
            return showCommand(u"fillGainsButton"_s);
        case FirstStep::ApplyGains:
            return showCommand(u"applyGainsButton"_s);
        case FirstStep::Enable:
            return showCommand(u"enableButton"_s);
        case FirstStep::Jog:
            return pointTo(*holdButton(false));
    }
}

void ServoPanel::resizeEvent(QResizeEvent* event) {
    ModulePage::resizeEvent(event);
    m_steps->giveRoomBack();
}

int ServoPanel::spareHeight() const {
    const int motions = ModulePage::spareHeight();
    const auto* apply = m_gains->findChild<QWidget*>(u"applyGainsButton"_s);
    if (m_steps->isHidden() || !m_gains->isVisible())
        return motions;
    const int bottom = apply->mapTo(m_gains, QPoint(0, apply->height() + look::gridUnit(this))).y();
    return qMin(motions, m_gains->parentWidget()->height() - bottom);
}

void ServoPanel::revealTuning() {
    reveal(*m_gains);
}

void ServoPanel::stageGains(const servo::SetGain& gains) {
    reveal(*m_gains);
    m_gains->stage(gains);
}

}  // namespace nmc
