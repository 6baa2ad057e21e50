// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/reportdialog.h"

#include <QDate>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/help/placing.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
// In line heights.
constexpr int kReportWidth = 50;
constexpr int kReportHeight = 36;
}  // namespace

ReportDialog::ReportDialog(const QString& report, Requests& requests, QWidget* parent)
    : QDialog(parent), m_requests(requests) {
    look::name(this, u"reportDialog"_s, tr("Report a problem"));
    setWindowTitle(tr("Report a problem"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* advice =
        new QLabel(tr("Nothing is sent. Read the report below, save it, and attach the file where you "
                      "describe the problem. It contains neither your PIN nor the name of your home folder."),
                   this);
    advice->setWordWrap(true);
    auto* text = new QPlainTextEdit(report, this);
    look::name(text, u"reportTextField"_s, tr("Text of the report"));
    text->setReadOnly(true);
    text->setLineWrapMode(QPlainTextEdit::NoWrap);
    text->setTabChangesFocus(true);
    text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    auto* save = form::newPush({u"reportSaveButton"_s, tr("&Save as…"), Common::tr("Save as…")}, this);
    auto* close = form::newPush({u"reportCloseButton"_s, tr("&Close"), tr("Close")}, this);
    connect(save, &QPushButton::clicked, this, [this, report] { chooseFile(report); });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* buttons = form::newLine(this, {nullptr, save, close}, form::kUsual);
    setLayout(form::newColumn(this, {advice, {text, 1}, buttons}, form::kUsual));
    placeBelowTop(*this, QSize(kReportWidth, kReportHeight) * fontMetrics().height());
}

void ReportDialog::chooseFile(const QString& report) {
    askWhereToSave(this,
                   {.objectName = u"reportSaveDialog"_s,
                    .title = tr("Save the report"),
                    .filters = {Common::tr("Text (*.txt)")},
                    .proposed = u"nmcpanel-report-"_s + QDate::currentDate().toString(Qt::ISODate)},
                   [this, report](const QString& path) {
                       emit m_requests.save(path, [report] { return report.toStdString(); });
                   });
}

}  // namespace nmc
