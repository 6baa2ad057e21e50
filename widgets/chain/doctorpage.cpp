// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/doctorpage.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>

#include "widgets/common/doctortexts.h"
#include "widgets/common/form.h"
#include "widgets/common/glyphs.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

DoctorPage::DoctorPage(Requests& requests, QWidget* parent) : QWidget(parent) {
    look::name(this, u"doctorPage"_s, tr("Chain doctor"));
    build(requests);
    showChain({}, Refusal::NotConnected, {});
}

void DoctorPage::build(const Requests& requests) {
    m_glyph = new GlyphLabel(this);
    m_glyph->setFont(look::scaled(font(), 1.6));
    m_finding = form::newParagraph(u"chainFinding"_s, {}, this);
    form::setBold(m_finding);
    m_advice = form::newParagraph(u"chainAdvice"_s, {}, this);
    m_table = new QTableWidget(0, Columns, this);
    look::name(m_table, u"chainTable"_s, tr("Modules expected and found, the farthest from the PC first"));
    m_table->setHorizontalHeaderLabels(
        {Common::tr("Module"), Common::tr("Name"), tr("Expected"), tr("Found"), tr("State")});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setTabKeyNavigation(false);
    m_scan =
        form::newPush({u"scanButton"_s, Common::tr("&Scan again"), tr("Scan again: look for modules")}, this);
    m_accept = form::newPush({u"acceptChainButton"_s, tr("Accep&t as found"), tr("Accept as found")}, this);
    m_restart = form::newPush({u"restartChainButton"_s, tr("&Restart the network…"),
                               tr("Restart the network: positions and gains are lost")},
                              this);

    auto* head = form::newLine(this, {m_glyph, {m_finding, 1}});
    auto* buttons = form::newLine(this, {m_scan, m_accept, nullptr, m_restart});
    form::fill(this, form::newColumn(this, {head, m_advice, {m_table, 1}, buttons}), 1);
    connect(m_scan, &QPushButton::clicked, &requests, &Requests::scan);
    connect(m_accept, &QPushButton::clicked, &requests, &Requests::acceptChain);
    connect(m_restart, &QPushButton::clicked, &requests, &Requests::restart);
}

void DoctorPage::showChain(const ChainDiagnosis& chain, std::optional<Refusal> whyNoRestart,
                           std::optional<Refusal> whyNotEdited) {
    if (m_chain == chain && m_whyNoRestart == whyNoRestart && m_whyNotEdited == whyNotEdited)
        return;
    m_chain = chain;
    m_whyNoRestart = whyNoRestart;
    m_whyNotEdited = whyNotEdited;
    m_glyph->showSeverity(texts::severityOf(chain.finding));
    look::setText(m_finding, texts::chainFinding(chain));
    const QString advice = texts::chainAdvice(chain);
    look::setText(m_advice, advice);
    m_advice->setVisible(!advice.isEmpty());
    fill();
    using enum ChainDiagnosis::Finding;
    const QString reason = chain.finding == NotConnected ? texts::refusal(Refusal::NotConnected)
                           : chain.finding == Looking    ? texts::refusal(Refusal::Looking)
                                                         : QString();
    look::setPossible(
        m_scan, reason,
        tr("Scans the chain again with status requests only: nothing is reset, nothing moves."));
    look::setPossible(m_restart, whyNoRestart ? texts::refusal(*whyNoRestart) : QString(),
                      Common::tr("Resets every module and assigns new addresses. Asks first."));
    const bool differs = std::any_of(chain.places.begin(), chain.places.end(),
                                     [](const ChainPlace& place) { return place.expected != place.found; });
    look::setPossible(m_accept,
                      !reason.isEmpty() ? reason
                      : whyNotEdited    ? texts::refusal(*whyNotEdited)
                      : differs         ? QString()
                                        : tr("The chain already matches."),
                      tr("From now on, the panel expects the modules found here."));
}

void DoctorPage::fill() {
    m_table->setRowCount(static_cast<int>(m_chain->places.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ChainPlace& place = m_chain->places[static_cast<std::size_t>(row)];
        const auto identity = [](const std::optional<ModuleIdentity>& module) {
            return module ? texts::moduleType(*module) : u"–"_s;
        };
        const std::array<QString, Columns> cells{QString::number(place.module.value() + 1),
                                                 QString::fromStdString(place.name), identity(place.expected),
                                                 identity(place.found), texts::chainVerdict(place.state)};
        for (int column = 0; column < Columns; ++column) {
            auto* item = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
            if (column == Verdict && texts::severityOf(place.state) != Severity::Normal) {
                QFont bold = m_table->font();
                bold.setBold(true);
                item->setFont(bold);
            }
            m_table->setItem(row, column, item);
        }
    }
}

}  // namespace nmc
