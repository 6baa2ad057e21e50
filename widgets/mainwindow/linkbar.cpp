// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/linkbar.h"

#include <QLabel>
#include <cmath>

#include "widgets/common/elidedlabel.h"
#include "widgets/common/look.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

LinkBar::LinkBar(QWidget* parent)
    : QStatusBar(parent),
      m_link(new ElidedLabel(1, this)),
      m_rate(new QLabel(this)),
      m_errors(new QLabel(this)),
      m_roundTrip(new QLabel(this)) {
    look::name(this, u"linkBar"_s, tr("State of the link"));
    m_link->setObjectName(u"linkLabel"_s);
    m_rate->setObjectName(u"rateLabel"_s);
    m_errors->setObjectName(u"errorLabel"_s);
    m_roundTrip->setObjectName(u"roundTripLabel"_s);
    m_rate->setToolTip(tr("Exchanges per second, and their share of the line's capacity."));
    m_errors->setToolTip(tr("Failed exchanges: no answer, garbled, or refused for a bad checksum."));
    m_roundTrip->setToolTip(tr("Mean time from sending a command to its complete answer."));
    addWidget(m_link, 1);
    for (QLabel* label : {m_rate, m_errors, m_roundTrip}) {
        label->setFont(look::tabular(font()));
        label->setMargin(look::gridUnit(this) / 3);
        addPermanentWidget(label);
    }
    showLink({});
}

void LinkBar::showLink(const LinkState& state) {
    look::setText(m_link, texts::link(state));
    const bool connected = state.phase == LinkPhase::Connected;
    if (connected == m_connected && !m_rate->text().isEmpty())
        return;
    m_connected = connected;
    // Figures of a link that does not exist would be wrong.
    look::setText(m_rate, tr("– exchanges/s"));
    look::setText(m_errors, tr("– errors"));
    look::setText(m_roundTrip, tr("round trip –"));
    makeRoom();
}

void LinkBar::showFigures(const LinkFigures& figures) {
    if (!m_connected)
        return;
    look::setText(m_rate, tr("%1 exchanges/s, %2 % bus load")
                              .arg(texts::readout(std::round(figures.exchangesPerSecond)))
                              .arg(qRound(figures.wireShare * 100)));
    look::setText(m_errors, tr("%1 errors, %2/s", nullptr, static_cast<int>(figures.errors))
                                .arg(texts::grouped(static_cast<qint64>(figures.errors)),
                                     texts::readout(figures.errorsPerSecond, 2)));
    look::setText(m_roundTrip, tr("round trip %1 ms").arg(texts::readout(figures.meanRoundTripMs, 3)));
    makeRoom();
}

void LinkBar::makeRoom() {
    int used = fontMetrics().horizontalAdvance(m_link->text()) + look::gridUnit(this) * 4;
    for (QLabel* label : {m_rate, m_errors, m_roundTrip}) {
        used += label->sizeHint().width() + look::gridUnit(this);
        label->setVisible(used <= width());
    }
}

void LinkBar::resizeEvent(QResizeEvent* event) {
    QStatusBar::resizeEvent(event);
    makeRoom();
}

}  // namespace nmc
