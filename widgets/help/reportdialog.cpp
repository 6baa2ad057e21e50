// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/reportdialog.h"

#include <QDate>
#include <QFileDialog>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/common/look.h"
#include "widgets/help/placing.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
// In line heights.
constexpr int kReportWidth = 50;
constexpr int kReportHeight = 36;
}  // namespace

ReportDialog::ReportDialog(const QString& report, QWidget* parent) : QDialog(parent) {
    look::name(this, u"reportDialog"_s, tr("Report a problem"));
    setWindowTitle(tr("Report a problem"));
    setAttribute(Qt::WA_DeleteOnClose);
    setModal(false);
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
    auto* save = new QPushButton(tr("&Save as…"), this);
    look::name(save, u"reportSaveButton"_s, tr("Save as…"));
    auto* close = new QPushButton(tr("&Close"), this);
    look::name(close, u"reportCloseButton"_s, tr("Close"));
    connect(save, &QPushButton::clicked, this, [this, report] { chooseFile(report); });
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(save);
    buttons->addWidget(close);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(advice);
    layout->addWidget(text, 1);
    layout->addLayout(buttons);
    placeBelowTop(*this, QSize(kReportWidth, kReportHeight) * fontMetrics().height());
}

void ReportDialog::chooseFile(const QString& report) {
    QFileDialog* dialog =
        newFileDialog(this, u"reportSaveDialog"_s, tr("Save the report"), {tr("Text (*.txt)")}, {});
    if (dialog == nullptr)
        return;
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(u"txt"_s);
    dialog->selectFile(u"nmcpanel-report-"_s + QDate::currentDate().toString(Qt::ISODate));
    connect(dialog, &QFileDialog::fileSelected, this, [this, report](const QString& path) {
        emit saveRequested(path, [report] { return report.toStdString(); });
    });
    dialog->show();
}

}  // namespace nmc
