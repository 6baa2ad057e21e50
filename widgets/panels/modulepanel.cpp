// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/modulepanel.h"

#include <QLabel>

#include "widgets/common/look.h"
#include "widgets/panels/genericpanel.h"
#include "widgets/panels/servopanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

ModulePanel::ModulePanel(QWidget* parent)
    : QStackedWidget(parent),
      m_empty(look::newMutedLabel({}, this)),
      m_servo(new ServoPanel(this)),
      m_generic(new GenericPanel(this)) {
    look::name(this, u"modulePanel"_s, tr("Selected module"));
    m_empty->setObjectName(u"emptyPanel"_s);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setFont(look::scaled(font(), 1.2));
    addWidget(m_empty);
    addWidget(m_servo);
    addWidget(m_generic);
    setCurrentWidget(m_servo);
    bringUp(m_empty);
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

void ModulePanel::showModule(const ModuleState& module, bool connected, std::optional<double> age) {
    if (module.isServo()) {
        m_servo->showModule(module, connected, age);
        bringUp(m_servo);
    } else {
        m_servo->endHold();
        m_generic->showModule(module);
        bringUp(m_generic);
    }
}

void ModulePanel::showNothing(const QString& text) {
    m_servo->endHold();
    look::setText(m_empty, text);
    bringUp(m_empty);
}

}  // namespace nmc
