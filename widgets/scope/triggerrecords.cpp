// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scope/triggerrecords.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <utility>

#include "widgets/common/filedialog.h"
#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/requests.h"
#include "widgets/common/words.h"
#include "widgets/scope/scopeexport.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {
constexpr int kUsuallyKept = 20, kMostKept = 999;
}

TriggerRecords::TriggerRecords(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_wanted(
          form::newCheck({.name = u"triggerSaveBox"_s,
                          .text = tr("Save each picture…"),
                          .accessible = tr("Save each picture"),
                          .meaning = tr("Saves the samples of each picture to a folder that you choose.")},
                         this)),
      m_keep(form::newNumber({.name = u"triggerKeepField"_s,
                              .accessible = tr("Keep the last"),
                              .min = 1,
                              .max = kMostKept,
                              .digits = 4,
                              .meaning = tr("How many files are kept. Then the oldest is replaced.")},
                             this)),
      m_state(new QLabel(this)),
      m_kept(kUsuallyKept) {
    look::name(this, u"triggerRecords"_s, tr("Saved pictures"));
    look::nameText(m_state, u"triggerSavedLabel"_s, tr("Saved pictures"));
    m_keep->showValue(kUsuallyKept);
    connect(m_wanted, &QCheckBox::clicked, this, [this](bool wanted) { wanted ? chooseFolder() : stop(); });
    connect(m_keep, &NumberField::editingFinished, this, &TriggerRecords::takeKept);
    form::fill(this, form::newLine(this,
                                   {m_wanted, form::newLabel(tr("Keep the last"), m_keep), m_keep,
                                    form::Item(m_state, 1)},
                                   0.5));
}

void TriggerRecords::chooseFolder() {
    m_wanted->setChecked(false);
    QFileDialog* dialog = newFileDialog(window(), {.objectName = u"triggerFolderDialog"_s,
                                                   .title = tr("Save each picture to a folder"),
                                                   .folder = m_folder});
    if (dialog == nullptr)
        return;
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        m_folder = folder;
        m_wanted->setChecked(true);
        begin();
    });
    dialog->show();
}

void TriggerRecords::begin() {
    m_prefix = QDateTime::currentDateTime().toString(u"yyyy-MM-dd HHmmss"_s);
    m_taken = 0;
    showState();
}

void TriggerRecords::stop() {
    m_prefix.clear();
    showState();
}

/// Counted on with another number, the files would no longer be replaced from the oldest on.
void TriggerRecords::takeKept() {
    const auto wanted = m_keep->value();
    const auto kept = wanted ? static_cast<std::uint64_t>(*wanted) : m_kept;
    if (std::exchange(m_kept, kept) != kept && !m_prefix.isEmpty())
        begin();
}

void TriggerRecords::showState() {
    look::setText(m_state, m_prefix.isEmpty() ? QString()
                                              : tr("%1 taken for %2")
                                                    .arg(texts::grouped(static_cast<qint64>(m_taken)),
                                                         QDir::toNativeSeparators(m_folder)));
}

void TriggerRecords::take(const History& history, const ScopeTrigger::Picture& picture,
                          const std::vector<ScopeModule>& modules, const ScopeOrigin& origin) {
    if (m_prefix.isEmpty())
        return;
    const QString file = m_prefix + u" trigger %1.csv"_s.arg(m_taken++ % m_kept + 1, 3, 10, QChar(u'0'));
    emit m_requests.save(QDir(m_folder).filePath(file),
                         samplesBetween(picture.from, picture.to, history, modules, origin));
    showState();
}

}  // namespace nmc
