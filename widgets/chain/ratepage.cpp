// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/ratepage.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "model/intent/intent.h"
#include "protocol/baud.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr quint32 kOther = 0;  // the divisor says
}  // namespace

RatePage::RatePage(QWidget* parent)
    : QWidget(parent),
      m_now(new QLabel(this)),
      m_rate(new QComboBox(this)),
      m_divisor(new QSpinBox(this)),
      m_other(new QLabel(this)),
      m_change(new QPushButton(tr("&Change the rate"), this)),
      m_reason(new QLabel(this)) {
    look::name(this, u"ratePage"_s, tr("Rate"));
    look::name(m_rate, u"chainRateBox"_s, tr("New rate of the chain"));
    m_rate->setToolTip(tr("The rate that the whole chain shall run at."));
    look::name(m_change, u"changeRateButton"_s, tr("Change the rate of the whole chain"));
    m_now->setObjectName(u"chainRateLabel"_s);
    m_reason->setObjectName(u"chainRateReason"_s);
    m_reason->setWordWrap(true);
    for (const BaudRow& row : kBaudRows)
        m_rate->addItem(tr("%1 Bd").arg(texts::grouped(row.nominal)), row.nominal);
    m_rate->addItem(tr("Other…"), kOther);
    look::name(m_divisor, u"chainDivisorBox"_s, tr("Divisor of Set Baud Rate"));
    m_divisor->setRange(0, 255);
    m_divisor->setToolTip(tr(
        "The rate is 1 250 000 Bd / (divisor + 1). Whether the port of this computer makes it to within 2 % is tried before any module is told."));
    m_other->setObjectName(u"chainDivisorRate"_s);
    auto* remark = look::newMutedLabel(
        tr("Positions, gains and groups stay. Every module is asked at the new rate; when one does not answer there, all go back to the old one."),
        this);
    remark->setWordWrap(true);
    const int unit = look::gridUnit(this);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(unit, unit, unit, unit);
    grid->setHorizontalSpacing(unit);
    grid->setVerticalSpacing(unit);
    grid->addWidget(m_now, 0, 0, 1, 5);
    grid->addWidget(m_rate, 1, 0);
    grid->addWidget(m_divisor, 1, 1);
    grid->addWidget(m_other, 1, 2);
    grid->addWidget(m_change, 1, 3);
    grid->addWidget(m_reason, 2, 0, 1, 5);
    grid->addWidget(remark, 3, 0, 1, 5);
    grid->setRowStretch(4, 1);
    grid->setColumnStretch(4, 1);
    connect(m_divisor, &QSpinBox::valueChanged, this, &RatePage::refresh);
    connect(m_rate, &QComboBox::currentIndexChanged, this, &RatePage::refresh);
    connect(m_change, &QPushButton::clicked, this, [this] { emit rateRequested(wanted()); });
    refresh();
}

void RatePage::showLink(const LinkState& link) {
    const bool news = m_link.baud != link.baud;
    m_link = link;
    if (news && link.baud != 0) {
        const int row = m_rate->findData(link.baud);
        m_rate->setCurrentIndex(row >= 0 ? row : m_rate->findData(kOther));
        m_divisor->setValue(findBrd(link.baud).value_or(kPowerUpBrd));
    }
    refresh();
}

quint32 RatePage::wanted() const {
    const quint32 chosen = m_rate->currentData().toUInt();
    return chosen == kOther ? baudOf(static_cast<std::uint8_t>(m_divisor->value())) : chosen;
}

QString RatePage::whyNot() const {
    if (m_link.phase != LinkPhase::Connected)
        return texts::refusal(Refusal::NotConnected);
    if (const auto refusal = whyNotTold(m_link))
        return texts::refusal(*refusal);
    const auto those = [this](auto unfit) {
        std::vector<ModuleIndex> modules;
        for (const ModuleState& module : m_link.modules)
            if (unfit(module))
                modules.push_back(module.info.index);
        return modules.empty() ? QString() : texts::listOfModules(modules);
    };
    if (const QString gone = those([](const ModuleState& m) { return m.silent || m.hasRestarted; });
        !gone.isEmpty())
        return tr("Some modules do not answer, and would be left behind at the old rate: %1.").arg(gone);
    if (!those([](const ModuleState& m) { return m.moving(); }).isEmpty())
        return tr("A motor is moving. The rate changes at standstill only.");
    if (const QString unknown = those([](const ModuleState& m) { return !m.info.group; }); !unknown.isEmpty())
        return tr("The groups of some modules are not known, so they might not hear it: %1. Choose a group for them on the page Groups, or none.")
            .arg(unknown);
    if (const QString leaders = those([](const ModuleState& m) { return m.info.group->leader; });
        !leaders.isEmpty())
        return tr("A leader of a group would answer while the rate changes. Take that from these on the page Groups: %1.")
            .arg(leaders);
    if (wanted() == m_link.baud)
        return tr("The chain runs at this rate already.");
    return {};
}

void RatePage::refresh() {
    const bool other = m_rate->currentData().toUInt() == kOther;
    m_divisor->setVisible(other);
    m_other->setVisible(other);
    look::setText(m_other, tr("= %1 Bd").arg(texts::grouped(wanted())));
    look::setText(m_now, m_link.phase == LinkPhase::Connected
                             ? tr("The chain runs at %1 Bd.").arg(texts::grouped(m_link.baud))
                             : texts::refusal(Refusal::NotConnected));
    const QString reason = whyNot();
    look::setPossible(m_change, reason, tr("Tells every module the new rate, and asks each there."));
    look::setText(m_reason, reason);
}

}  // namespace nmc
