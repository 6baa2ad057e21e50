// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chaindialog.h"

#include <QScreen>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "model/intent/rights.h"
#include "widgets/chain/doctorpage.h"
#include "widgets/chain/groupspage.h"
#include "widgets/chain/ratepage.h"
#include "widgets/common/focuskeeper.h"
#include "widgets/common/look.h"
#include "widgets/common/scrolled.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChainDialog::ChainDialog(Requests& requests, QWidget* parent)
    : QDialog(parent),
      m_focus(new FocusKeeper(*this)),
      m_pages(new QTabWidget(this)),
      m_doctor(new DoctorPage(requests, this)),
      m_groups(new GroupsPage(requests, this)),
      m_rate(new RatePage(requests, this)) {
    look::name(this, u"chainDialog"_s, Common::tr("Chain"));
    setWindowTitle(Common::tr("Chain"));
    look::name(m_pages, u"chainPages"_s, tr("Doctor, groups and baud rate"));
    m_pages->tabBar()->setObjectName(u"chainPagesBar"_s);
    m_pages->tabBar()->setAccessibleName(m_pages->accessibleName());
    m_pages->addTab(scrolled(m_doctor), tr("Doctor"));
    m_pages->addTab(scrolled(m_groups), Common::tr("Groups"));
    m_pages->addTab(scrolled(m_rate), Common::tr("Baud rate"));
    keepFocusOnTabs(*m_pages);
    auto* layout = new QVBoxLayout(this);
    const int unit = look::gridUnit(this);
    layout->setContentsMargins(unit, unit, unit, unit);
    layout->addWidget(m_pages);
    const int em = fontMetrics().height();
    const QSize room = screen()->availableSize() * 0.9;
    resize(qMin(em * 44, room.width()), qMin(em * 26, room.height()));
}

bool ChainDialog::focusNextPrevChild(bool next) {
    return !m_focus->leave() && (m_focus->resume(next) || QDialog::focusNextPrevChild(next));
}

void ChainDialog::openAt(Page page) {
    m_pages->setCurrentIndex(page);
    look::showInFront(this);
}

void ChainDialog::showChain(const Machine& machine, const LinkState& link) {
    m_doctor->showChain(diagnose(machine, link), whyInaccessible(link), whyNotEdited(link.rights));
    m_groups->showLink(link, machine.groups);
    m_rate->showLink(link);
}

}  // namespace nmc
