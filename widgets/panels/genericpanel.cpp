// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/genericpanel.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

GenericPanel::GenericPanel(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_name(new QLabel(this)),
      m_text(form::newParagraph({}, {}, this)),
      m_status(new QLabel(this)),
      m_ask(form::newPush({u"askAnewButton"_s, tr("Request status")}, this)) {
    connect(m_ask, &QPushButton::clicked, this,
            [this, &requests] { emit requests.intent(m_module, intent::AskAnew{}); });
    look::name(this, u"genericPanel"_s, tr("Module without controls"));
    m_name->setFont(look::scaled(font(), 1.5));
    form::setBold(m_name);
    m_name->setObjectName(u"genericName"_s);
    m_status->setObjectName(u"genericStatus"_s);
    m_status->setFont(look::tabular(font()));
    auto* layout = new QVBoxLayout(this);
    const int unit = look::gridUnit(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->addWidget(m_name);
    layout->addWidget(m_text);
    layout->addWidget(m_status);
    layout->addWidget(m_ask, 0, Qt::AlignLeft);
    layout->addStretch(1);
}

void GenericPanel::showModule(const PanelView& view) {
    const ModuleState& module = view.module;
    m_module = module.info.index;
    look::setText(m_name, Common::tr("%1: %2").arg(texts::moduleName(module.info.index),
                                                   texts::moduleType(module.info.identity)));
    look::setText(
        m_text,
        tr("The panel does not support this type and version (supported: PIC-SERVO v1 to v5 and v10, PIC-STEP v1, PIC-I/O v1), so it only shows the module's status. STOP ALL might not stop its motor: use the hardware stop."));
    QString status = tr("No status yet.");
    if (module.latest.has_value()) {
        status = tr("Status byte %1").arg(module.latest->status, 2, 16, QChar(u'0'));
        if (module.latest->position.has_value())
            status += tr(", position %1").arg(texts::grouped(*module.latest->position));
    }
    if (module.silent && !module.notAsked)
        status = tr("It does not answer. ") + status;
    look::setText(m_status, status);
    look::setPossible(m_ask,
                      module.lookedFor ? texts::refusal(Refusal::Looking)
                      : view.connected ? QString()
                                       : texts::refusal(Refusal::NotConnected),
                      tr("Sends No Operation, which only requests the status."));
}

}  // namespace nmc
