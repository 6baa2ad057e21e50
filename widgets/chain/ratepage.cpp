// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/ratepage.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "model/intent/intent.h"
#include "protocol/baud.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr quint32 kOther = 0;  // determined by the divisor
}  // namespace

RatePage::RatePage(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_now(new QLabel(this)),
      m_rate(form::newChoice({.name = u"chainRateBox"_s,
                              .accessible = tr("New baud rate of the chain"),
                              .meaning = tr("The new baud rate of the whole chain.")},
                             this)),
      m_divisor(form::newNumber(
          {.name = u"chainDivisorBox"_s,
           .accessible = tr("Divisor of Set Baud Rate"),
           .words = tr("The divisor"),
           .max = 255,
           .digits = 5,
           .meaning = tr(
               "The baud rate is 1 250 000 Bd / (divisor + 1). The panel first checks that this computer's port supports it to within 2 %.")},
          this)),
      m_other(new QLabel(this)),
      m_change(form::newPush(
          {u"changeRateButton"_s, tr("&Change baud rate"), tr("Change baud rate of the whole chain")}, this)),
      m_reason(form::newParagraph(u"chainRateReason"_s, {}, this)) {
    look::name(this, u"ratePage"_s, Common::tr("Baud rate"));
    m_now->setObjectName(u"chainRateLabel"_s);
    for (const BaudRow& row : kBaudRows)
        m_rate->addItem(tr("%1 Bd").arg(texts::grouped(row.nominal)), row.nominal);
    m_rate->addItem(tr("Other…"), kOther);
    m_other->setObjectName(u"chainDivisorRate"_s);
    QLabel* remark = form::newRemark(
        tr("Positions, gains and groups are kept. The panel checks every module at the new baud rate; if one does not answer, all modules go back to the old rate."),
        this);
    auto* rate = form::newLine(this, {m_rate, m_divisor, m_other, m_change, nullptr});
    form::fill(this, form::newColumn(this, {m_now, rate, m_reason, remark, nullptr}), 1);
    connect(m_divisor, &NumberField::edited, this, &RatePage::refresh);
    connect(m_rate, &QComboBox::currentIndexChanged, this, &RatePage::refresh);
    connect(m_change, &QPushButton::clicked, this, [this] { emit m_requests.rate(*wanted()); });
    refresh();
}

void RatePage::showLink(const LinkState& link) {
    const bool news = m_link.baud != link.baud;
    m_link = link;
    if (news && link.baud != 0) {
        const int row = m_rate->findData(link.baud);
        m_rate->setCurrentIndex(row >= 0 ? row : m_rate->findData(kOther));
        m_divisor->showValue(findBrd(link.baud).value_or(kPowerUpBrd));
    }
    refresh();
}

std::optional<quint32> RatePage::wanted() const {
    const quint32 chosen = m_rate->currentData().toUInt();
    if (chosen != kOther)
        return chosen;
    const auto divisor = m_divisor->value();
    return divisor ? std::optional(baudOf(static_cast<std::uint8_t>(*divisor))) : std::nullopt;
}

QString RatePage::whyNot() const {
    if (const auto refusal = whyNoChain(m_link))
        return texts::refusal(*refusal);
    if (const auto refusal = whyInaccessible(m_link))
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
        return tr("Modules that do not answer would stay at the old baud rate: %1.").arg(gone);
    if (!those([](const ModuleState& m) { return m.moving(); }).isEmpty())
        return tr("A motor is moving. Stop all motors to change the baud rate.");
    if (const QString unknown = those([](const ModuleState& m) { return !m.info.group; }); !unknown.isEmpty())
        return tr("Modules with an unknown group may miss the change: %1. Set their group on the Groups page, or none.")
            .arg(unknown);
    if (const QString leaders = those([](const ModuleState& m) { return m.info.group->leader; });
        !leaders.isEmpty())
        return tr("Group leaders would answer during the change. Make these ordinary members on the Groups page: %1.")
            .arg(leaders);
    if (!wanted())
        return m_divisor->problemText();
    if (*wanted() == m_link.baud)
        return tr("The chain already runs at this baud rate.");
    return {};
}

void RatePage::refresh() {
    const bool other = m_rate->currentData().toUInt() == kOther;
    m_divisor->setVisible(other);
    m_other->setVisible(other);
    look::setText(m_other, wanted() ? tr("= %1 Bd").arg(texts::grouped(*wanted())) : u"–"_s);
    const auto noChain = whyNoChain(m_link);
    look::setText(m_now, noChain ? texts::refusal(*noChain)
                                 : tr("The chain runs at %1 Bd.").arg(texts::grouped(m_link.baud)));
    const QString reason = whyNot();
    look::setPossible(m_change, reason, tr("Sends the new baud rate to every module, then checks each one."));
    look::setText(m_reason, reason);
}

}  // namespace nmc
