// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/printing.h"

#include <QProcess>
#include <QSettings>
#include <memory>

#include "widgets/common/look.h"
#include "widgets/common/printdialog.h"
#include "widgets/common/printtexts.h"
#include "widgets/common/requests.h"
#include "widgets/mainwindow/mainwindow.h"
#include "widgets/mainwindow/settingskeys.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

// lp is part of POSIX; lp and lpstat both belong to CUPS.
const QString kPrint = u"lp"_s;
const QString kLook = u"lpstat"_s;
const QString kPrinters = u"-e"_s;
const QString kStandard = u"-d"_s;

struct Printers {
    QStringList names;
    QString standard;
    int looks = 2;  ///< queries that have not returned yet

    /// Call after each query.
    void showIn(PrintDialog& dialog) {
        if (!standard.isEmpty() && !names.contains(standard))
            names.prepend(standard);
        dialog.showPrinters(names, standard, --looks == 0);
    }
};

/// Extracts the name from "system default destination: office"; without a default, nothing follows a colon.
QString standardIn(const QString& said) {
    return said.section(u": "_s, 1).trimmed();
}

}  // namespace

Printing::Printing(MainWindow& window, QSettings& settings) : m_window(window), m_settings(settings) {
    connect(&window.requests(), &Requests::print, this, &Printing::ask);
}

/// A dialog that is already open gets the new page.
void Printing::ask(const QByteArray& pdf) {
    if (m_dialog == nullptr || !m_dialog->isVisible()) {
        m_dialog = new PrintDialog(m_settings.value(settingskeys::kPrinter).toString(), m_window.requests(),
                                   &m_window);
        connect(m_dialog, &PrintDialog::printRequested, this, &Printing::print);
        lookFor(*m_dialog);
    }
    m_dialog->setPage(pdf);
    look::showInFront(m_dialog);
}

void Printing::lookFor(PrintDialog& dialog) {
    const auto printers = std::make_shared<Printers>();
    lookUp(dialog, kStandard, [&dialog, printers](const QString& said) {
        printers->standard = standardIn(said);
        printers->showIn(dialog);
    });
    lookUp(dialog, kPrinters, [&dialog, printers](const QString& said) {
        printers->names = said.split(u'\n', Qt::SkipEmptyParts);
        printers->showIn(dialog);
    });
}

void Printing::lookUp(PrintDialog& dialog, const QString& option,
                      const std::function<void(const QString&)>& then) {
    auto* process = new QProcess(this);
    // Its output is parsed, so it must not be localised.
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"LC_ALL"_s, u"C.UTF-8"_s);
    process->setProcessEnvironment(environment);
    connect(process, &QProcess::errorOccurred, &dialog, [process, then](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;  // finished() follows
        then({});
        process->deleteLater();
    });
    connect(process, &QProcess::finished, &dialog,
            [process, then] { then(QString::fromLocal8Bit(process->readAllStandardOutput())); });
    connect(process, &QProcess::finished, process, &QObject::deleteLater);
    connect(&dialog, &QObject::destroyed, process, &QProcess::kill);
    process->start(kLook, {option});
}

void Printing::print(const QByteArray& pdf, const QString& printer, int copies) {
    m_settings.setValue(settingskeys::kPrinter, printer);
    auto* process = new QProcess(this);
    connect(process, &QProcess::errorOccurred, this, [this, process](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart)
            return;  // finished() follows
        m_window.showMessage(texts::noPrinting(kPrint));
        process->deleteLater();
    });
    connect(
        process, &QProcess::finished, this, [this, process, printer](int code, QProcess::ExitStatus status) {
            const bool printed = status == QProcess::NormalExit && code == 0;
            m_window.showMessage(
                printed
                    ? texts::sentToPrinter(printer)
                    : texts::notPrinted(QString::fromLocal8Bit(process->readAllStandardError()).trimmed()));
            process->deleteLater();
        });
    process->start(kPrint, {u"-d"_s, printer, u"-n"_s, QString::number(copies), u"-t"_s, u"NMC Panel"_s});
    process->write(pdf);
    process->closeWriteChannel();
}

}  // namespace nmc
