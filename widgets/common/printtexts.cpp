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
            .headline = Texts::tr("The page was not printed."),
            .body = Texts::tr("%1 Export the page as a PDF file, and print that elsewhere.").arg(cause),
            .details = details};
}

}  // namespace

Message sentToPrinter() {
    return {.key = kKey,
            .headline = Texts::tr("The page is on its way to the printer."),
            .body = Texts::tr("It went to the printer that this computer uses unless told otherwise.")};
}

Message noPrinting(const QString& command) {
    return notPrintedBecause(
        Texts::tr("The program %1 is not installed, which hands pages to the printer.").arg(command), {});
}

Message notPrinted(const QString& details) {
    return notPrintedBecause(Texts::tr("The print system does not take it: see the details."), details);
}

}  // namespace nmc::texts
