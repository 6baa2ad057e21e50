// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/printdialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/printtexts.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kMostCopies = 99;
constexpr int kStateWidth = 20;  ///< line heights
}  // namespace

PrintDialog::PrintDialog(const QString& last, Requests& requests, QWidget* window)
    : QDialog(window),
      m_requests(requests),
      m_chosen(last),
      m_printer(form::newChoice({u"printerBox"_s, tr("Printer"), {}}, this)),
      m_copies(form::newNumber(
          {.name = u"copiesField"_s, .accessible = tr("Copies"), .min = 1, .max = kMostCopies, .digits = 3},
          this)),
      m_state(form::newParagraph(u"printState"_s, tr("Printers"), this)),
      m_print(form::newPush({u"printButton"_s, tr("&Print"), tr("Print")}, this)),
      m_save(form::newPush({u"printSaveButton"_s, tr("Save as P&DF…"), tr("Save as PDF…")}, this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Print"));
    look::name(this, u"printDialog"_s, windowTitle());
    m_copies->showValue(1);
    m_state->setMinimumWidth(fontMetrics().height() * kStateWidth);
    m_print->setDefault(true);
    m_save->setAutoDefault(false);
    m_save->setToolTip(tr("Saves the page as a file that any computer can print."));
    connect(m_printer, &QComboBox::activated, this, [this] { m_chosen = m_printer->currentText(); });
    connect(m_copies, &NumberField::edited, this, &PrintDialog::showPossible);
    connect(m_print, &QPushButton::clicked, this, &PrintDialog::print);
    connect(m_save, &QPushButton::clicked, this, &PrintDialog::savePdf);
    layOut();
    showPrinters({}, {}, false);
}

void PrintDialog::layOut() {
    auto* cancel = form::newPush({u"printCancelButton"_s, tr("&Cancel"), Common::tr("Cancel")}, this);
    cancel->setAutoDefault(false);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    auto* rows = new QFormLayout;
    rows->addRow(tr("P&rinter"), m_printer);
    rows->addRow(tr("C&opies"), m_copies);
    auto* buttons = form::newLine(this, {nullptr, m_print, m_save, cancel});
    form::fill(this, form::newColumn(this, {rows, m_state, buttons}), 2);
}

void PrintDialog::showPrinters(const QStringList& printers, const QString& standard, bool all) {
    m_printer->clear();
    m_printer->addItems(printers);
    const int chosen = m_printer->findText(m_chosen);
    m_printer->setCurrentIndex(
        qMax(chosen >= 0 ? chosen : m_printer->findText(standard), printers.empty() ? -1 : 0));
    look::setText(m_state, !all               ? texts::lookingForPrinters()
                           : printers.empty() ? texts::noPrinter()
                                              : QString());
    showPossible();
    adjustSize();  // the new text may have more lines
}

void PrintDialog::showPossible() {
    look::setPossible(m_printer, m_printer->count() == 0 ? m_state->text() : QString(),
                      tr("The printer to use. It is preselected next time."));
    look::setPossible(m_print, m_printer->count() == 0 ? m_state->text() : m_copies->problemText(),
                      tr("Sends the page to this printer."));
}

void PrintDialog::print() {
    emit printRequested(m_pdf, m_printer->currentText(), static_cast<int>(m_copies->value().value_or(1)));
    accept();
}

void PrintDialog::savePdf() {
    askWhereToSave(this,
                   {.objectName = u"printPdfDialog"_s,
                    .title = tr("Save the page"),
                    .filters = {Common::tr("PDF (*.pdf)")},
                    .proposed = tr("page")},
                   [this](const QString& path) {
                       emit m_requests.save(path, [content = m_pdf.toStdString()] { return content; });
                       accept();
                   });
}

}  // namespace nmc
