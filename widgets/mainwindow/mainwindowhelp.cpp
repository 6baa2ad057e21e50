// SPDX-License-Identifier: GPL-3.0-or-later
// The manual, and the problem report.
#include "widgets/help/manualwindow.h"
#include "widgets/help/problemreport.h"
#include "widgets/help/reportdialog.h"
#include "widgets/mainwindow/connectionbar.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/messages/messagelist.h"
#include "widgets/messages/messagepanel.h"
#include "widgets/monitor/monitordock.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kReportedPackets = 500;
}  // namespace

/// Creates the window, which reads the manual's pages, when it is first opened; it remembers what the user
/// has read.
ManualWindow& MainWindow::manual() {
    auto* manual = findChild<ManualWindow*>();
    return manual != nullptr ? *manual : *new ManualWindow(Manual(), this);
}

void MainWindow::openManual(const QString& page) {
    manual().openAt(page);
}

void MainWindow::openManualAt(const QWidget* widget) {
    manual().openFor(widget);
}

void MainWindow::openProblemReport() {
    auto* dialog = findChild<ReportDialog*>();
    if (dialog == nullptr) {
        const QString report = problemReport(
            {m_settings, m_session.link(), m_monitor->figures(), m_bar->ports(),
             m_monitor->lastPackets(kReportedPackets),
             QString::fromStdString(messageText({m_model->entries().begin(), m_model->entries().end()}))});
        dialog = new ReportDialog(report, *m_requests, this);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

}  // namespace nmc
