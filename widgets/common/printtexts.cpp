// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/printtexts.h"

#include "widgets/common/textparts.h"

namespace nmc::texts {

using namespace Qt::StringLiterals;

namespace {

const QString kKey = u"print"_s;

Message notPrintedBecause(const QString& cause, const QString& details) {
    return {.key = kKey,
            .severity = Severity::Attention,
            .headline = Texts::tr("Could not print the page."),
            .body = Texts::tr("%1 Export the page as a PDF file and print that file.").arg(cause),
            .details = details};
}

}  // namespace

QString lookingForPrinters() {
    return Texts::tr("Looking for printers…");
}

QString noPrinter() {
    return Texts::tr(
        "No printer is set up on this computer. Add one in the system's printer settings, or save the page as a PDF file.");
}

Message sentToPrinter(const QString& printer) {
    return {.key = kKey,
            .headline = Texts::tr("The page was sent to the printer."),
            .body = Texts::tr("Printer: %1").arg(printer)};
}

Message noPrinting(const QString& command) {
    return notPrintedBecause(
        Texts::tr("The program %1, which sends pages to the printer, is not installed.").arg(command), {});
}

Message notPrinted(const QString& details) {
    return notPrintedBecause(Texts::tr("The print system refused it: see Details."), details);
}

}  // namespace nmc::texts
