// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepanel.h"

#include <QLabel>

#include "widgets/common/look.h"
#include "widgets/panels/genericpanel.h"
#include "widgets/panels/servopanel.h"
#include "widgets/panels/steppanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
/// What is built late still comes where it stands, and not behind everything.
void keepTabOrder(QWidget* before, QWidget* page) {
    QList<QWidget*> controls;
    for (QWidget* next = page->nextInFocusChain(); next != page; next = next->nextInFocusChain())
        if (page->isAncestorOf(next))
            controls.append(next);
    for (QWidget* control : controls) {
        QWidget::setTabOrder(before, control);
        before = control;
    }
}
}  // namespace

ModulePanel::ModulePanel(QWidget* parent)
    : QStackedWidget(parent), m_empty(look::newMutedLabel({}, this)), m_generic(new GenericPanel(this)) {
    look::name(this, u"modulePanel"_s, tr("Selected module"));
    m_empty->setObjectName(u"emptyPanel"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setFont(look::scaled(font(), 1.2));
    addWidget(m_empty);
    addWidget(m_generic);
    m_generic->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    connect(m_generic, &GenericPanel::intentRequested, this, &ModulePanel::intentRequested);
}

ModulePage& ModulePanel::servo() {
    if (m_servo == nullptr) {
        adopt(m_servo = new ServoPanel(this));
        connect(m_servo, &ServoPanel::stepResponseWanted, this, &ModulePanel::stepResponseWanted);
    }
    return *m_servo;
}

ModulePage& ModulePanel::stepper() {
    if (m_stepper == nullptr)
        adopt(m_stepper = new StepPanel(this));
    return *m_stepper;
}

void ModulePanel::adopt(ModulePage* page) {
    addWidget(page);
    m_pages.append(page);
    keepTabOrder(m_generic, page);
    if (m_holdInterval)
        page->setHoldInterval(*m_holdInterval);
    connect(page, &ModulePage::intentRequested, this, &ModulePanel::intentRequested);
    connect(page, &ModulePage::holdRequested, this, &ModulePanel::holdRequested);
    connect(page, &ModulePage::holdReleased, this, &ModulePanel::holdReleased);
    connect(page, &ModulePage::settingsEdited, this, &ModulePanel::settingsEdited);
}

void ModulePanel::forgetModules() {
    showNothing(m_empty->text());
    qDeleteAll(m_pages);
    m_pages.clear();
    m_servo = nullptr;
    m_stepper = nullptr;
}

void ModulePanel::resetSpeeds() {
    for (ModulePage* page : m_pages)
        page->resetSpeeds();
}

void ModulePanel::endHold() {
    for (ModulePage* page : m_pages)
        page->endHold();
}

void ModulePanel::setHoldInterval(int milliseconds) {
    m_holdInterval = milliseconds;
    for (ModulePage* page : m_pages)
        page->setHoldInterval(milliseconds);
}

void ModulePanel::stageGains(const servo::SetGain& gains) {
    if (m_servo != nullptr && currentWidget() == m_servo)
        m_servo->stageGains(gains);
}

void ModulePanel::bringUp(QWidget* page) {
    if (page == currentWidget())
        return;
    // Qt would hand the focus of the page that goes to what comes first on the other: Enable.
    if (QWidget* focused = window()->focusWidget(); focused != nullptr && isAncestorOf(focused))
        focused->clearFocus();
    for (int i = 0; i < count(); ++i) {
        const auto policy = widget(i) == page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        widget(i)->setSizePolicy(policy, policy);
    }
    setCurrentWidget(page);
}

void ModulePanel::showModule(const PanelView& view) {
    if (!view.module.isServo() && !view.module.isStepper()) {
        endHold();
        m_generic->showModule(view);
        bringUp(m_generic);
        return;
    }
    ModulePage& page = view.module.isServo() ? servo() : stepper();
    for (ModulePage* other : m_pages)
        if (other != &page)
            other->endHold();
    page.showModule(view);
    bringUp(&page);
}

void ModulePanel::showNothing(const QString& text) {
    endHold();
    look::setText(m_empty, text);
    bringUp(m_empty);
}

}  // namespace nmc
