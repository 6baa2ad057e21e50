// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/chain/chainmenu.h"

#include <QAction>
#include <QMenu>

#include "model/intent/rights.h"
#include "widgets/chain/chaindialog.h"
#include "widgets/chain/copydialog.h"
#include "widgets/chain/lenddialog.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

ChainMenu::ChainMenu(const Machine& machine, const LinkState& link, Requests& requests, QWidget* window)
    : QObject(window),
      m_requests(requests),
      m_machine(machine),
      m_link(link),
      m_window(window),
      m_doctor(look::newAction(
          window, u"chainDoctorAction"_s, tr("Chain &doctor…"),
          tr("Compares the expected modules with those found, and shows where the chain probably breaks."),
          Qt::Key_F6)),
      m_groups(look::newAction(window, u"groupsAction"_s, tr("&Groups…"),
                               tr("Assigns modules to groups, and starts their loaded moves together."),
                               Qt::Key_F7)),
      m_rate(look::newAction(window, u"rateAction"_s, tr("B&aud rate of the chain…"),
                             tr("Changes the baud rate of the whole chain."), Qt::Key_F8)),
      m_copy(look::newAction(window, u"copyAxisAction"_s, tr("&Copy settings to other axes…"))),
      m_scan(look::newAction(window, u"scanAction"_s, Common::tr("&Scan again"),
                             tr("Scans the chain again; nothing is reset."), Qt::Key_F5)),
      m_restart(look::newAction(window, u"restartNetworkAction"_s,
                                tr("&Restart the network: positions and gains are lost…"))),
      m_programs(
          look::newAction(window, u"letProgramsInAction"_s, tr("&Let programs in"),
                          tr("Other programs on this computer may read the chain, and ask to move motors."))),
      m_lend(look::newAction(window, u"lendLineAction"_s, tr("L&end the line to a program…"),
                             tr("A program has the modules for itself; the panel shows what they report."))) {
    m_programs->setCheckable(true);
    connect(m_programs, &QAction::triggered, &requests, &Requests::letProgramsIn);
    connect(m_doctor, &QAction::triggered, this, &ChainMenu::openDoctor);
    connect(m_groups, &QAction::triggered, this, [this] { open(ChainDialog::Groups); });
    connect(m_rate, &QAction::triggered, this, [this] { open(ChainDialog::Rate); });
    connect(m_copy, &QAction::triggered, this, &ChainMenu::openCopy);
    connect(m_lend, &QAction::triggered, this, &ChainMenu::openLending);
    connect(m_scan, &QAction::triggered, &requests, &Requests::scan);
    connect(m_restart, &QAction::triggered, &requests, &Requests::restart);
    refresh();
}

void ChainMenu::addTo(QMenu& menu) {
    menu.addActions({m_doctor, m_groups, m_rate, m_copy});
    menu.addSeparator();
    menu.addActions({m_scan, m_restart});
    menu.addSeparator();
    menu.addActions({m_programs, m_lend});
}

void ChainMenu::showPrograms(bool on) {
    m_programs->setChecked(on);
}

void ChainMenu::refresh() {
    m_scan->setEnabled((m_link.phase == LinkPhase::Connected || m_link.phase == LinkPhase::Lost) &&
                       !m_link.lent);
    const auto refusal = whyInaccessible(m_link);
    m_restart->setEnabled(!refusal);
    m_restart->setToolTip(refusal ? texts::refusal(*refusal)
                                  : Common::tr("Resets every module and assigns new addresses. Asks first."));
    const auto noCopy = whyNoCopy();
    m_copy->setEnabled(!noCopy);
    m_copy->setToolTip(
        noCopy
            ? texts::refusal(*noCopy)
            : tr("Copies gains, limits and other settings to axes of the same type. Shows the differences first."));
    if (m_copyDialog != nullptr && (noCopy || !m_copyDialog->isFor(m_link)))
        m_copyDialog->close();
    else if (m_copyDialog != nullptr)
        m_copyDialog->showMachine(m_machine);
    if (m_dialog != nullptr && m_dialog->isVisible())
        m_dialog->showChain(m_machine, m_link);
    if (m_lendDialog != nullptr)
        m_lendDialog->showLink(m_link);
}

/// Settings are stored even if they cannot be sent, as on a read-only connection.
std::optional<Refusal> ChainMenu::whyNoCopy() const {
    const auto refusal = whyNoChain(m_link);
    return refusal ? refusal : whyNotEdited(m_link.rights);
}

void ChainMenu::openCopy() {
    if (m_copyDialog == nullptr)
        m_copyDialog = new CopyDialog(m_machine, m_link, m_selected, m_requests, m_window);
    look::showInFront(m_copyDialog);
}

void ChainMenu::openLending() {
    if (m_lendDialog == nullptr)
        m_lendDialog = new LendDialog(m_requests, m_window);
    m_lendDialog->showLink(m_link);
    look::showInFront(m_lendDialog);
}

void ChainMenu::openDoctor() {
    open(ChainDialog::Doctor);
}

void ChainMenu::open(int page) {
    if (m_dialog == nullptr) {
        m_dialog = new ChainDialog(m_requests, m_window);
        // Their keys work in the dialog, too.
        m_dialog->addActions({m_doctor, m_groups, m_rate, m_scan, m_restart});
    }
    m_dialog->showChain(m_machine, m_link);
    m_dialog->openAt(static_cast<ChainDialog::Page>(page));
}

}  // namespace nmc
