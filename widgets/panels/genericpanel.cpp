// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/genericpanel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

GenericPanel::GenericPanel(QWidget* parent)
    : QWidget(parent), m_name(new QLabel(this)), m_text(new QLabel(this)), m_status(new QLabel(this)) {
    look::name(this, u"genericPanel"_s, tr("Module without controls"));
    QFont large = look::scaled(font(), 1.5);
    large.setBold(true);
    m_name->setFont(large);
    m_name->setObjectName(u"genericName"_s);
    m_text->setWordWrap(true);
    m_status->setObjectName(u"genericStatus"_s);
    m_status->setFont(look::tabular(font()));
    auto* layout = new QVBoxLayout(this);
    const int unit = look::gridUnit(this);
    layout->setContentsMargins(unit * 2, unit * 2, unit * 2, unit * 2);
    layout->addWidget(m_name);
    layout->addWidget(m_text);
    layout->addWidget(m_status);
    layout->addStretch(1);
}

void GenericPanel::showModule(const ModuleState& module) {
    look::setText(m_name, tr("%1: %2").arg(texts::moduleName(module.info.index),
                                           texts::moduleType(module.info.identity)));
    look::setText(
        m_text,
        tr("There are no controls for this type of module yet. It is polled, and Stop all reaches it."));
    QString status = tr("No status yet.");
    if (module.latest.has_value()) {
        status = tr("Status byte %1").arg(module.latest->status, 2, 16, QChar(u'0'));
        if (module.latest->position.has_value())
            status += tr(", position %1").arg(texts::grouped(*module.latest->position));
    }
    if (module.silent)
        status = tr("It does not answer. ") + status;
    look::setText(m_status, status);
}

}  // namespace nmc
