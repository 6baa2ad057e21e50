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
}

void ModulePanel::showModule(const ModuleState& module, bool connected, std::optional<double> age) {
    if (module.isServo()) {
        m_servo->showModule(module, connected, age);
        setCurrentWidget(m_servo);
    } else {
        m_servo->endHold();
        m_generic->showModule(module);
        setCurrentWidget(m_generic);
    }
}

void ModulePanel::showNothing(const QString& text) {
    m_servo->endHold();
    look::setText(m_empty, text);
    setCurrentWidget(m_empty);
}

}  // namespace nmc
