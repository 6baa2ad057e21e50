// SPDX-License-Identifier: GPL-3.0-or-later
// The questions that the window asks before motors are stopped or positions are lost, and what follows from
// the answers.
#include <QCloseEvent>
#include <utility>

#include "widgets/common/askdialog.h"
#include "widgets/common/texts.h"
#include "widgets/machine/machinemenu.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/messages/banner.h"
#include "widgets/panels/modulepanel.h"

namespace nmc {

using namespace Qt::StringLiterals;

void MainWindow::askBeforeStopping(const QString& name, const QString& stopText,
                                   const std::function<void()>& go) {
    AskDialog::ask({.name = name,
                    .title = tr("Motors are moving"),
                    .text = m_session.whileOpen(texts::closing),
                    .stay = tr("&Cancel"),
                    .stayName = u"stayButton"_s},
                   {{stopText, u"stopAndCloseButton"_s,
                     [this, go] {
                         emit stopAllRequested();
                         go();
                     }}},
                   this);
}

void MainWindow::askBeforeDisconnect() {
    if (!m_session.leavingStopsMotors())
        emit disconnectRequested();
    else
        askBeforeStopping(u"disconnectDialog"_s, tr("&Stop and disconnect"),
                          [this] { m_session.disconnectWhenStopped(); });
}

/// Shows a waiting question in the banner, where the user may look meanwhile. It is not an event for the list
/// of messages.
void MainWindow::reviewQuestions() {
    AskDialog::reviewAll(*this);
    const AskDialog* question = AskDialog::waiting(*this);
    const QString title = question != nullptr ? question->windowTitle() : QString();
    if (std::exchange(m_waiting, title) == title)
        return;
    if (question != nullptr)
        m_banner->setNotice(texts::questionWaits(title, question->text()));
    else
        m_banner->setNotice({});
}

void MainWindow::askBeforeRestart() {
    if (whyInaccessible(m_session.link()))
        return;
    AskDialog::ask({.name = u"restartDialog"_s,
                    .title = tr("Restart the network"),
                    .text = m_session.whileOpen(texts::beforeRestart),
                    .stay = tr("&Cancel"),
                    .stayName = u"cancelRestartButton"_s,
                    .stayIsDefault = true},
                   {{tr("&Restart the network: positions and gains are lost"), u"restartButton"_s,
                     [this] { emit restartNetworkRequested(); }}},
                   this);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool moving = !m_mayClose && m_session.leavingStopsMotors();
    const MachineFile& file = m_machineMenu->file();
    const bool unsaved = !m_mayClose && !m_workMayWait && (file.modified || file.saving);
    if (!moving && !unsaved) {
        endHold();
        saveLayout();
        event->accept();
        return;
    }
    event->ignore();
    if (moving)
        askBeforeStopping(u"closeDialog"_s, tr("&Stop and close"), [this] {
            m_bar->showStopResult(texts::stoppingBeforeClose());
            emit closeConfirmed();
        });
    else
        m_machineMenu->askBeforeClose([this] {
            // Motors may have been started since the question was asked.
            m_workMayWait = true;
            close();
            m_workMayWait = false;
        });
}

void MainWindow::finishClose() {
    m_mayClose = true;
    close();
}

}  // namespace nmc
