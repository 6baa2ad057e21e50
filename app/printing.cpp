// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/printing.h"

#include <QProcess>

#include "widgets/common/printtexts.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/response/responsedock.h"
#include "widgets/scope/scopefiles.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
const QString kCommand = u"lp"_s;  // POSIX; a part of CUPS
}

Printing::Printing(MainWindow& window, QObject* parent) : QObject(parent), m_window(window) {
    connect(&window.scopeFiles(), &ScopeFiles::printRequested, this, &Printing::print);
    connect(&window.stepResponses(), &ResponseDock::printRequested, this, &Printing::print);
}

void Printing::print(const QByteArray& pdf) {
    auto* process = new QProcess(this);
    connect(process, &QProcess::errorOccurred, this, [this, process](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;  // finished() follows
        m_window.showMessage(texts::noPrinting(kCommand));
        process->deleteLater();
    });
    connect(process, &QProcess::finished, this, [this, process](int code, QProcess::ExitStatus status) {
        const bool printed = status == QProcess::NormalExit && code == 0;
        m_window.showMessage(
            printed ? texts::sentToPrinter()
                    : texts::notPrinted(QString::fromLocal8Bit(process->readAllStandardError()).trimmed()));
        process->deleteLater();
    });
    process->start(kCommand, {u"-t"_s, u"NMC Panel"_s});
    process->write(pdf);
    process->closeWriteChannel();
}

}  // namespace nmc
