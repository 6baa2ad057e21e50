// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/ratepage.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "model/intent/intent.h"
#include "protocol/baud.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

RatePage::RatePage(QWidget* parent)
    : QWidget(parent),
      m_now(new QLabel(this)),
      m_rate(new QComboBox(this)),
      m_change(new QPushButton(tr("&Change the rate"), this)) {
    look::name(this, u"ratePage"_s, tr("Rate"));
    look::name(m_rate, u"chainRateBox"_s, tr("New rate of the chain"));
    m_rate->setToolTip(tr("The rate that the whole chain shall run at."));
    look::name(m_change, u"changeRateButton"_s, tr("Change the rate of the whole chain"));
    m_now->setObjectName(u"chainRateLabel"_s);
    for (const BaudRow& row : kBaudRows)
        m_rate->addItem(tr("%1 Bd").arg(texts::grouped(row.nominal)), row.nominal);
    auto* remark =
        look::newMutedLabel(tr("Positions, gains and groups stay. Every module is asked at the new "
                               "rate; when one does not answer there, all go back to the old one."),
                            this);
    remark->setWordWrap(true);
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit);
    grid->addWidget(m_now, 0, 0, 1, 3);
    grid->addWidget(m_rate, 1, 0);
    grid->addWidget(m_change, 1, 1);
    grid->addWidget(remark, 2, 0, 1, 3);
    grid->setRowStretch(3, 1);
    grid->setColumnStretch(2, 1);
    connect(m_rate, &QComboBox::currentIndexChanged, this, &RatePage::refresh);
    connect(m_change, &QPushButton::clicked, this,
            [this] { emit rateRequested(m_rate->currentData().toUInt()); });
    refresh();
}

void RatePage::showLink(const LinkState& link) {
    const bool news = m_baud != link.baud;
    m_phase = link.phase;
    m_readOnly = link.readOnly;
    m_baud = link.baud;
    m_moving = std::any_of(link.modules.begin(), link.modules.end(),
                           [](const ModuleState& module) { return module.moving(); });
    if (news)
        m_rate->setCurrentIndex(m_rate->findData(m_baud));
    refresh();
}

void RatePage::refresh() {
    const bool connected = m_phase == LinkPhase::Connected;
    look::setText(m_now, connected ? tr("The chain runs at %1 Bd.").arg(texts::grouped(m_baud))
                                   : texts::refusal(Refusal::NotConnected));
    QString reason;
    if (!connected)
        reason = texts::refusal(Refusal::NotConnected);
    else if (m_readOnly)
        reason = texts::refusal(Refusal::ReadOnly);
    else if (m_moving)
        reason = tr("A motor is moving. The rate changes at standstill only.");
    else if (m_rate->currentData().toUInt() == m_baud)
        reason = tr("The chain runs at this rate already.");
    look::setPossible(m_change, reason, tr("Tells every module the new rate, and asks each there."));
}

}  // namespace nmc
