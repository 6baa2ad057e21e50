// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/stepperpanel.h"

#include <QTabWidget>
#include <QVBoxLayout>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/panels/axisbox.h"
#include "widgets/panels/detailsbox.h"
#include "widgets/panels/expertbox.h"
#include "widgets/panels/homingbox.h"
#include "widgets/panels/jogbox.h"
#include "widgets/panels/movebybox.h"
#include "widgets/panels/panelhead.h"
#include "widgets/panels/stepperiobox.h"
#include "widgets/panels/steppermotionbox.h"
#include "widgets/panels/stepperparametersbox.h"

namespace nmc {

using namespace Qt::StringLiterals;

StepperPanel::StepperPanel(const PanelView& view, Requests& requests) : ModulePage(view, requests) {
    look::name(this, u"stepperPanel"_s, tr("Stepper module"));
    auto* head = new PanelHead(m_context, this);
    auto* motion = new StepperMotionBox(m_context, this);
    auto* jog = new JogBox(m_context, this);
    auto* moveBy = new MoveByBox(m_context, *motion, this);
    connect(motion, &StepperMotionBox::modeChosen, jog, &JogBox::endHold);
    auto* left = new QVBoxLayout;
    left->setSpacing(look::gridUnit(this) / 2);
    for (QWidget* box : std::initializer_list<QWidget*>{motion, jog, moveBy})
        left->addWidget(box);
    FormGrid::align({motion, jog, moveBy});
    left->addStretch(1);
    auto* pages = new QTabWidget(this);
    look::name(pages, u"stepperPages"_s, Common::tr("Pages of the module"));
    pages->addTab(new StepperParametersBox(m_context, this), Common::tr("Parameters"));
    pages->addTab(new StepperIoBox(m_context, this), tr("I/O"));
    pages->addTab(new HomingBox(m_context, this), Common::tr("Homing"));
    pages->addTab(new AxisBox(m_context, this), Common::tr("Axis"));
    pages->addTab(new DetailsBox(m_context, this), Common::tr("Details"));
    pages->addTab(new ExpertBox(m_context, this), Common::tr("Expert"));
    layOut(head, left, pages);
}

}  // namespace nmc
