// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/scopefiles.h"

#include <QAction>
#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include "model/recording/recording.h"
#include "widgets/common/filedialog.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

constexpr double kMove = 0.005;  ///< share of the visible time, for each press

const QString kRecordingFileSuffix = QString::fromLatin1(kRecordingSuffix.data(), kRecordingSuffix.size());

}  // namespace

ScopeFiles::ScopeFiles(Requests& requests, QWidget* panel)
    : QWidget(panel),
      m_panel(panel),
      m_export(requests, panel),
      m_record(look::newAction(panel, u"scopeRecordAction"_s, {}, {}, Qt::CTRL | Qt::SHIFT | Qt::Key_R)),
      m_open(look::newAction(panel, u"openRecordingAction"_s, tr("Open &recording…"),
                             tr("Shows a recording in the scope. Control of the motors continues."),
                             Qt::CTRL | Qt::SHIFT | Qt::Key_O)),
      m_under(look::newAction(
          panel, u"layUnderAction"_s, tr("Over&lay a recording…"),
          tr("Draws a recording in pale lines below the live traces, aligned to the start of the last motion."))) {
    look::name(this, u"scopeFiles"_s, tr("Recordings"));
    form::fill(this, form::newColumn(this, {}, 0));
    m_recordingRow = addRow(u"scopeRecording"_s, tr("Recording"), tr("Stop recording"),
                            tr("Ends the recording and closes its file (Ctrl+Shift+R)."));
    m_openingRow = addRow(u"scopeOpening"_s, tr("Opening"), Common::tr("Cancel"),
                          tr("Cancels opening; the scope stays as it is."));
    m_underRow = addRow(u"scopeUnder"_s, tr("Overlay"), Common::tr("Remove"),
                        tr("Removes the recording from the plots. Its file is kept."));
    addMoveButton(u"scopeUnderEarlierButton"_s, tr("◂ Earlier"), tr("Moves the recording to the left."),
                  -kMove);
    addMoveButton(u"scopeUnderLaterButton"_s, tr("Later ▸"), tr("Moves the recording to the right."), kMove);
    connect(m_underRow.button, &QPushButton::clicked, this, &ScopeFiles::underRemoved);
    connect(m_recordingRow.button, &QPushButton::clicked, this, &ScopeFiles::recordingEndRequested);
    connect(m_openingRow.button, &QPushButton::clicked, this, &ScopeFiles::openingCancelled);

    connect(m_record, &QAction::triggered, this, &ScopeFiles::recordOrEnd);
    panel->addAction(m_record);
    connect(m_open, &QAction::triggered, this,
            [this] { choose(u"openRecordingDialog"_s, tr("Open recording"), &ScopeFiles::openRequested); });
    connect(m_under, &QAction::triggered, this,
            [this] { choose(u"layUnderDialog"_s, tr("Overlay a recording"), &ScopeFiles::underRequested); });
    showRecording({});
    showOpening({});
    showUnder({});
}

ScopeFiles::Row ScopeFiles::addRow(const QString& name, const QString& title, const QString& verb,
                                   const QString& meaning) {
    Row row{new QWidget(this), new QLabel(this), new QPushButton(verb, this)};
    row.widget->setLayout(form::newLine(this, {row.label, row.button, nullptr}, form::kUsual));
    row.widget->layout()->setContentsMargins(0, look::gridUnit(this) / 2, 0, 0);
    look::name(row.label, name + u"Label"_s, title);
    look::name(row.button, name + u"EndButton"_s, verb);
    row.button->setToolTip(meaning);
    layout()->addWidget(row.widget);
    return row;
}

void ScopeFiles::showConnected(bool connected) {
    m_connected = connected;
    showRecordAction();
}

void ScopeFiles::showRecordAction() {
    const QString record = tr("Saves every sample of all modules to a file from now on (Ctrl+Shift+R).");
    m_record->setEnabled(m_connected || m_recording);
    m_record->setText(m_recording ? tr("Stop recording") : tr("Record…"));
    m_record->setToolTip(m_recording   ? m_recordingRow.button->toolTip()
                         : m_connected ? record
                                       : tr("Nothing to record: connect a module first."));
}

void ScopeFiles::showRecording(const std::optional<Recording>& recording) {
    m_recording = recording.has_value();
    if (recording)
        look::setText(
            m_recordingRow.label,
            tr("● Recording %1, %2, %3")
                .arg(QFileInfo(recording->path).fileName(),
                     tr("%1 s").arg(texts::grouped(static_cast<qint64>(recording->seconds))),
                     locale().formattedDataSize(recording->bytes, 1, QLocale::DataSizeTraditionalFormat)));
    m_recordingRow.widget->setVisible(m_recording);
    showRecordAction();
}

void ScopeFiles::showOpening(const std::optional<Opening>& opening) {
    if (opening)
        look::setText(m_openingRow.label, tr("Opening %1, %2 %")
                                              .arg(QFileInfo(opening->path).fileName(),
                                                   QString::number(static_cast<int>(opening->share * 100))));
    m_openingRow.widget->setVisible(opening.has_value());
}

void ScopeFiles::showUnder(const QString& title) {
    look::setText(m_underRow.label, Common::tr("Overlay: %1").arg(title));
    m_underRow.widget->setVisible(!title.isEmpty());
}

void ScopeFiles::addMoveButton(const QString& objectName, const QString& text, const QString& meaning,
                               double share) {
    auto* button = new QPushButton(text, m_underRow.widget);
    look::name(button, objectName, text);
    button->setToolTip(meaning);
    button->setAutoRepeat(true);
    connect(button, &QPushButton::clicked, this, [this, share] { emit underMoved(share); });
    auto* row = static_cast<QHBoxLayout*>(m_underRow.widget->layout());
    row->insertWidget(row->indexOf(m_underRow.button), button);
}

void ScopeFiles::recordOrEnd() {
    if (m_recording)
        return emit recordingEndRequested();
    askWhereToSave(m_panel,
                   {u"scopeRecordDialog"_s, tr("Record to a file"), filters(), m_folder,
                    QDateTime::currentDateTime().toString(u"yyyy-MM-dd HHmmss"_s)},
                   [this](const QString& path) {
                       m_folder = QFileInfo(path).absolutePath();
                       emit recordRequested(path);
                   });
}

QStringList ScopeFiles::filters() {
    return {tr("Recordings (*.%1)").arg(kRecordingFileSuffix), Common::tr("All files (*)")};
}

void ScopeFiles::choose(const QString& objectName, const QString& title,
                        void (ScopeFiles::*wanted)(const QString&)) {
    askWhatToOpen(m_panel, {objectName, title, filters(), m_folder}, [this, wanted](const QString& path) {
        m_folder = QFileInfo(path).absolutePath();
        emit(this->*wanted)(path);
    });
}

}  // namespace nmc
