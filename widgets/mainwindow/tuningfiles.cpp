// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/mainwindow/tuningfiles.h"

#include <QCoreApplication>

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

namespace {

class TuningFiles {
    Q_DECLARE_TR_FUNCTIONS(nmc::TuningFiles)
};

}  // namespace

void saveTuningReport(const Session& session, ResponseDock& responses, LoopTestsDock& tests,
                      Requests& requests, QWidget* window) {
    const ModuleState* module = session.selected();
    if (module == nullptr || !module->isServo())
        return;
    const LinkState& link = session.link();
    const bus::ModuleInfo& info = module->info;
    TuningReport report;
    report.machine = QString::fromStdString(session.machine().name);
    report.module = texts::moduleName(info.index);
    report.chip = TuningFiles::tr("PIC-SERVO, version %1, address %2")
                      .arg(info.identity.version)
                      .arg(info.address.value());
    report.port =
        TuningFiles::tr("%1, %2 Bd").arg(QString::fromStdString(link.port), QString::number(link.baud));
    report.simulated = link.simulated;
    report.made = QDateTime::currentDateTime();
    report.gains = module->gains;
    for (const KeptResponse& run : responses.page().runs())
        if (run.run.module == info.index)
            report.run = run;
    report.motor = responses.page().model().motorWords(info.index);
    if (const FrequencyPage::Found* last = tests.frequency().last())
        report.frequency = *last;
    askWhereToSave(window,
                   {.objectName = u"reportFileDialog"_s,
                    .title = TuningFiles::tr("Save the tuning report"),
                    .filters = {Common::tr("PDF (*.pdf)"), TuningFiles::tr("HTML (*.html)")},
                    .proposed = u"tuning-report"_s},
                   [&requests, report](const QString& path) {
                       const bool html = path.endsWith(u".html"_s, Qt::CaseInsensitive);
                       const QByteArray bytes = html ? reportHtml(report).toUtf8() : reportPdf(report);
                       emit requests.save(path, [content = bytes.toStdString()] { return content; });
                   });
}

}  // namespace nmc
