// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/ribbons.h"

#include <QAction>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/apitexts.h"
#include "widgets/common/form.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/common/words.h"
#include "widgets/gamepad/jogwheel.h"
#include "widgets/mainwindow/operatorlock.h"
#include "widgets/mainwindow/pendant.h"
#include "widgets/mainwindow/ribbon.h"
#include "widgets/mainwindow/session.h"

namespace nmc {

using namespace Qt::StringLiterals;

Ribbons::Ribbons(Requests& requests, OperatorLock& lock, Pendant& pendant, QWidget* top)
    : QObject(top),
      m_lock(lock),
      m_pendant(pendant),
      m_simulated(new Ribbon(u"simulatorRibbon"_s, tr("Simulated session"),
                             tr("SIMULATOR — no hardware connected; all values are simulated"), top)),
      m_readOnly(new Ribbon(u"readOnlyRibbon"_s, tr("Read-only session"),
                            tr("READ-ONLY — only status requests are sent. STOP ALL still works."), top)),
      m_operator(new Ribbon(u"operatorRibbon"_s, Common::tr("Operator mode"),
                            tr("OPERATOR MODE — only allowed actions are available. STOP ALL always works."),
                            top)),
      m_programs(new Ribbon(u"programsRibbon"_s, Common::tr("Other programs"), QString(), top)),
      m_endControl(m_programs->addButton(u"endProgramControlButton"_s, tr("End control"),
                                         tr("The program may no longer move motors."))),
      m_lent(new Ribbon(u"lentRibbon"_s, tr("Line lent to a program"), QString(), top)),
      m_letThrough(m_lent->addButton(u"letProgramThroughButton"_s, tr("Release"),
                                     tr("The program has the line again. It may move motors at once."))),
      m_moved(new Ribbon(u"pendantRibbon"_s, tr("Pendant"), QString(), top)) {
    m_column = form::newColumn(top, {m_simulated, m_readOnly, m_operator, m_programs, m_lent, m_moved}, 0);
    QPushButton* fully =
        m_readOnly->addButton(u"connectFullyButton"_s, Common::tr("Connect fully"),
                              tr("Reconnects to the same port with commands allowed. Nothing moves."));
    connect(fully, &QPushButton::clicked, &requests, &Requests::connectFully);
    QPushButton* leave =
        m_operator->addButton(u"leaveOperatorButton"_s, tr("Leave…"), Common::tr("Asks for the PIN."));
    connect(leave, &QPushButton::clicked, &m_lock, &OperatorLock::open);
    const auto showLock = [this] { m_operator->setVisible(m_lock.isLocked()); };
    connect(&m_lock, &OperatorLock::changed, this, showLock);
    showLock();
    connect(m_endControl, &QPushButton::clicked, &requests, &Requests::endProgramControl);
    connect(m_letThrough, &QPushButton::clicked, &requests, &Requests::letProgramThrough);
    QPushButton* endLending = m_lent->addButton(
        u"endLendingButton"_s, tr("End lending"),
        tr("The program loses the line, and the chain is scanned again. Nothing is reset or stopped."));
    connect(endLending, &QPushButton::clicked, &requests, &Requests::endLending);
    QPushButton* end =
        m_moved->addButton(u"endPendantButton"_s, tr("End pendant mode"),
                           tr("Ends pendant mode: arrow keys and gamepad no longer move anything."));
    connect(end, &QPushButton::clicked, this, [this] { m_pendant.action()->setChecked(false); });
    for (QPushButton* button : {m_endControl, m_letThrough, endLending, end})
        button->setFocusPolicy(Qt::NoFocus);
}

void Ribbons::showSession(const Session& session) {
    const LinkState& link = session.link();
    m_simulated->setVisible(session.isOpen() && link.simulated);
    m_readOnly->setVisible(session.isOpen() && link.readOnly);
    m_lent->setVisible(link.lent.has_value());
    if (!link.lent)
        return;
    m_lent->setText(texts::lentTo(*link.lent));
    m_letThrough->setVisible(link.lent->heldOff);
}

void Ribbons::showPrograms(const ProgramsShown& programs) {
    m_programs->setVisible(programs.on);
    m_endControl->setVisible(!programs.inControl.isEmpty());
    m_programs->setText(!programs.inControl.isEmpty()
                            ? tr("PROGRAM — \"%1\" may move motors. Esc or any command of yours ends that.")
                                  .arg(programs.inControl)
                        : programs.failed ? tr("PROGRAMS — none can connect now.")
                        : programs.path.isEmpty()
                            ? tr("PROGRAMS — may connect once a port is open.")
                            : tr("PROGRAMS — may connect at %1. Connected: %2.")
                                  .arg(programs.path, QString::number(programs.connected)));
}

void Ribbons::showPendant(const ModuleState* module) {
    m_moved->setVisible(m_pendant.isOn());
    if (module != nullptr)
        m_moved->setText(tr("PENDANT — %1. %2").arg(texts::moduleName(module->info.index), pendantHelp()));
}

QString Ribbons::pendantHelp() const {
    if (!m_pendant.problem().isEmpty())
        return tr("Not moved: %1").arg(m_pendant.problem());
    if (m_pendant.wheel().isForbidden())
        return tr(
            "There is a jog wheel, but you may not read it. Unplug it and plug it in again; if that does not help, see the manual. Esc ends pendant mode.");
    if (m_pendant.wheel().isThere())
        return tr(
            "To move it, hold a button of the jog wheel, and push its ring or cap for a speed or turn the wheel for steps. The middle button, or the right one of a 3-axis mouse, is STOP ALL. Esc ends pendant mode.");
    if (m_pendant.hasGamepad())
        return tr(
            "To move it, hold Shift with ◂ or ▸, or a shoulder button of the gamepad with its left stick or D-pad. B (○) is STOP ALL. Esc ends pendant mode.");
    return tr("Hold Shift with ◂ or ▸ to move it. Esc ends pendant mode.");
}

}  // namespace nmc
