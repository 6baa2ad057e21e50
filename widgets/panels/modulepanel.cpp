// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepanel.h"

#include <QLabel>

#include "widgets/common/look.h"
#include "widgets/panels/genericpanel.h"
#include "widgets/panels/servopanel.h"
#include "widgets/panels/steppanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

ModulePanel::ModulePanel(QWidget* parent)
    : QStackedWidget(parent),
      m_empty(look::newMutedLabel({}, this)),
      m_servo(new ServoPanel(this)),
      m_stepper(new StepPanel(this)),
      m_generic(new GenericPanel(this)) {
    look::name(this, u"modulePanel"_s, tr("Selected module"));
    m_empty->setObjectName(u"emptyPanel"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setFont(look::scaled(font(), 1.2));
    addWidget(m_empty);
    addWidget(m_servo);
    addWidget(m_stepper);
    addWidget(m_generic);
    setCurrentWidget(m_servo);
    bringUp(m_empty);
    connect(m_generic, &GenericPanel::intentRequested, this, &ModulePanel::intentRequested);
    for (ModulePage* page : pages()) {
        connect(page, &ModulePage::intentRequested, this, &ModulePanel::intentRequested);
        connect(page, &ModulePage::holdRequested, this, &ModulePanel::holdRequested);
        connect(page, &ModulePage::holdReleased, this, &ModulePanel::holdReleased);
        connect(page, &ModulePage::settingsEdited, this, &ModulePanel::settingsEdited);
    }
}

std::array<ModulePage*, 2> ModulePanel::pages() const {
    return {m_servo, m_stepper};
}

void ModulePanel::resetSpeeds() {
    for (ModulePage* page : pages())
        page->resetSpeeds();
}

void ModulePanel::endHold() {
    for (ModulePage* page : pages())
        page->endHold();
}

void ModulePanel::setHoldInterval(int milliseconds) {
    for (ModulePage* page : pages())
        page->setHoldInterval(milliseconds);
}

void ModulePanel::bringUp(QWidget* page) {
    if (page == currentWidget())
        return;
    for (int i = 0; i < count(); ++i) {
        const auto policy = widget(i) == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        widget(i)->setSizePolicy(policy, policy);
    }
    setCurrentWidget(page);
}

void ModulePanel::showModule(const PanelView& view) {
    if (view.module.isServo()) {
        m_stepper->endHold();
        m_servo->showModule(view);
        bringUp(m_servo);
    } else if (view.module.isStepper()) {
        m_servo->endHold();
        m_stepper->showModule(view);
        bringUp(m_stepper);
    } else {
        endHold();
        m_generic->showModule(view);
        bringUp(m_generic);
    }
}

void ModulePanel::showNothing(const QString& text) {
    endHold();
    look::setText(m_empty, text);
    bringUp(m_empty);
}

}  // namespace nmc
