// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/tuningfiles.h"

#include <QWidget>

#include "widgets/common/filedialog.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/looptests/frequencypage.h"
#include "widgets/looptests/looptestsdock.h"
#include "widgets/looptests/tuningreport.h"
#include "widgets/mainwindow/session.h"
#include "widgets/response/responsedock.h"

namespace nmc {

using namespace Qt::StringLiterals;

TuningFiles::TuningFiles(const Session& session, ResponseDock& responses, LoopTestsDock& tests,
                         Requests& requests, QWidget* window)
    : QObject(window),
      m_session(session),
      m_responses(responses),
      m_tests(tests),
      m_requests(requests),
      m_window(window) {
    connect(&tests, &LoopTestsDock::reportWanted, this, &TuningFiles::chooseReportFile);
}

std::optional<TuningReport> TuningFiles::report() const {
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
    report.port = tr("%1, %2 Bd").arg(QString::fromStdString(link.port), QString::number(link.baud));
    report.simulated = link.simulated;
    report.made = QDateTime::currentDateTime();
    report.gains = module->gains;
    for (const KeptResponse& run : m_responses.page().runs())
        if (run.run.module == info.index)
            report.run = run;
    report.motor = m_responses.page().model().motorWords();
    if (const FrequencyPage::Found* last = m_tests.frequency().last())
        report.frequency = *last;
    return report;
}

void TuningFiles::chooseReportFile() {
    const auto report = this->report();
    if (!report)
        return;
    askWhereToSave(m_window,
                   {.objectName = u"reportFileDialog"_s,
                    .title = tr("Save the tuning report"),
                    .filters = {Common::tr("PDF (*.pdf)"), tr("HTML (*.html)")},
                    .proposed = u"tuning-report"_s},
                   [this, report = *report](const QString& path) {
                       const bool html = path.endsWith(u".html"_s, Qt::CaseInsensitive);
                       const QByteArray bytes = html ? reportHtml(report).toUtf8() : reportPdf(report);
                       emit m_requests.save(path, [content = bytes.toStdString()] { return content; });
                   });
}

}  // namespace nmc
