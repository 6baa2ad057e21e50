// SPDX-License-Identifier: GPL-3.0-or-later
// What is known about the selected servo's loop, on one page.

#include "model/response/frequencyfile.h"
#include "widgets/common/filedialog.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/tuningreport.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scoperecord.h"

namespace nmc {

using namespace Qt::StringLiterals;

std::optional<TuningReport> MainWindow::tuningReport() {
    const ModuleState* module = m_session.selected();
    if (module == nullptr || !module->isServo())
        return std::nullopt;
    const LinkState& link = m_session.link();
    const bus::ModuleInfo& info = module->info;
    TuningReport report;
    report.machine = QString::fromStdString(m_session.machine().name);
    report.module = texts::moduleName(info.index);
    report.chip =
        tr("PIC-SERVO, version %1, address %2").arg(info.identity.version).arg(info.address.value());
    report.port = tr("%1, %2 Bd").arg(QString::fromStdString(link.port)).arg(link.baud);
    report.simulated = link.simulated;
    report.made = QDateTime::currentDateTime();
    report.gains = module->gains;
    const std::vector<KeptResponse>& runs = m_response->page().runs();
    for (const KeptResponse& run : runs)
        if (run.run.module == info.index)
            report.run = run;
    report.motor = m_response->page().motorWords();
    report.frequencies = m_loopTests->frequency().points();
    return report;
}

void MainWindow::saveFrequencies(const QString& path, const QDateTime& measured) {
    const ModuleState* module = m_session.selected();
    if (module == nullptr)
        return;
    const LinkState& link = m_session.link();
    emit m_requests->save(
        path, [origin = recordingHeader({}, QString::fromStdString(link.port), link.simulated, {}, measured),
               name = texts::moduleName(module->info.index).toStdString(),
               points = m_loopTests->frequency().points(), speed = m_loopTests->frequency().speed()] {
            return frequencyCsv(origin, name, points, speed);
        });
}

void MainWindow::chooseReportFile() {
    const auto report = tuningReport();
    if (!report)
        return;
    askWhereToSave(this,
                   {.objectName = u"reportFileDialog"_s,
                    .title = tr("Save the tuning report"),
                    .filters = {Common::tr("PDF (*.pdf)"), tr("HTML (*.html)")},
                    .proposed = u"tuning-report"_s},
                   [this, report = *report](const QString& path) {
                       const bool html = path.endsWith(u".html"_s, Qt::CaseInsensitive);
                       const QByteArray bytes = html ? reportHtml(report).toUtf8() : reportPdf(report);
                       emit m_requests->save(path, [content = bytes.toStdString()] { return content; });
                   });
}

}  // namespace nmc
