// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/machine/machinemenu.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <utility>

#include "model/machinefile/machinefile.h"
#include "widgets/common/askdialog.h"
#include "widgets/common/filedialog.h"
#include "widgets/common/look.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/texts.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

const QString kMachineSuffix = QString::fromLatin1(kMachineFileSuffix);

void doNothing() {}

}  // namespace

QString MachineFile::title() const {
    return path.isEmpty() ? name : QFileInfo(path).completeBaseName();
}

MachineMenu::MachineMenu(QWidget* window)
    : QObject(window),
      m_window(window),
      m_new(look::newAction(window, u"newMachineAction"_s, tr("&New machine"),
                            tr("Discards names, units and settings of all axes; nothing is sent."),
                            Qt::CTRL | Qt::Key_N)),
      m_open(
          look::newAction(window, u"openMachineAction"_s, tr("&Open machine…"),
                          tr("Shows what a machine file would change. Nothing is sent until you apply it."),
                          Qt::CTRL | Qt::Key_O)),
      m_save(look::newAction(window, u"saveMachineAction"_s, tr("&Save machine"),
                             tr("Saves names, units, gains, limits, homing and groups to the machine file."),
                             Qt::CTRL | Qt::Key_S)),
      m_saveAs(look::newAction(window, u"saveMachineAsAction"_s, tr("Save machine &as…"),
                               tr("Saves the machine under another file name."),
                               Qt::CTRL | Qt::SHIFT | Qt::Key_S)),
      m_recent(new QMenu(tr("Open re&cent"), window)) {
    look::name(m_recent, u"recentMachinesMenu"_s, tr("Open recent"));
    m_recent->setToolTipsVisible(true);
    connect(m_new, &QAction::triggered, this, [this] { askFirst([this] { emit newRequested(); }); });
    connect(m_open, &QAction::triggered, this, [this] { askFirst([this] { chooseToOpen(); }); });
    connect(m_save, &QAction::triggered, this, [this] { save(doNothing); });
    connect(m_saveAs, &QAction::triggered, this, [this] { chooseToSave(doNothing); });
    m_recent->setEnabled(false);
}

void MachineMenu::addTo(QMenu& menu) {
    menu.setToolTipsVisible(true);
    menu.addAction(m_new);
    menu.addAction(m_open);
    menu.addMenu(m_recent);
    menu.addAction(m_save);
    menu.addAction(m_saveAs);
}

void MachineMenu::showFile(const MachineFile& file) {
    const bool otherRecent = file.recent != m_file.recent;
    const bool done = m_file.saving && !file.saving;
    m_file = file;
    if (otherRecent)
        fillRecent();
    refresh();
    emit shown();
    if (done)
        goOnAfterSaving();
}

void MachineMenu::setLocked(bool locked) {
    m_locked = locked;
    if (locked && m_differences != nullptr)
        m_differences->reject();  // the choice is dropped, not only out of sight
    refresh();
}

void MachineMenu::refresh() {
    const bool possible = !m_file.saving && !m_locked;
    for (QAction* action : {m_new, m_open, m_save, m_saveAs})
        action->setEnabled(possible);
    for (QAction* action : m_recent->actions())
        action->setEnabled(possible);  // the command palette finds them, too
    m_recent->setEnabled(possible && !m_file.recent.isEmpty());
}

void MachineMenu::fillRecent() {
    m_recent->clear();
    int number = 1;
    for (const QString& path : m_file.recent) {
        // An ampersand in a file name must not mark a mnemonic.
        QAction* action = m_recent->addAction(
            u"&%1  %2"_s.arg(QString::number(number), QFileInfo(path).fileName().replace(u"&"_s, u"&&"_s)));
        action->setObjectName(u"recentMachine%1Action"_s.arg(number++));
        action->setToolTip(QDir::toNativeSeparators(path));
        connect(action, &QAction::triggered, this,
                [this, path] { askFirst([this, path] { emit openRequested(path); }); });
    }
}

QString MachineMenu::titlePart() const {
    const QString title = m_file.title();
    if (title.isEmpty() && !m_file.modified && !m_file.saving)
        return {};
    const QString marked = (title.isEmpty() ? tr("new machine") : title) + u"[*]"_s;
    return m_file.saving ? tr("%1 (being saved)").arg(marked) : marked;
}

void MachineMenu::showDifferences(const QString& file, std::vector<Difference> differences) {
    openDifferences().showDifferences(texts::machineFileName(file), std::move(differences));
}

void MachineMenu::showCopy(ModuleIndex from, std::vector<Difference> differences) {
    openDifferences().showCopy(from, std::move(differences));
}

DifferencesDialog& MachineMenu::openDifferences() {
    if (m_differences == nullptr) {
        m_differences = new DifferencesDialog(m_window);
        connect(m_differences, &DifferencesDialog::applyRequested, this, &MachineMenu::applyRequested);
        connect(m_differences, &QDialog::rejected, this, [this] {
            m_differences = nullptr;
            emit differencesDropped();
        });
    }
    m_differences->show();
    m_differences->activateWindow();
    return *m_differences;
}

void MachineMenu::closeDifferences() {
    if (m_differences != nullptr)
        m_differences->accept();
    m_differences = nullptr;
}

void MachineMenu::askBeforeClose(const Go& close) {
    if (m_file.saving)
        return waitForSave(close);
    ask(tr("&Save and close"), tr("&Close: the changes can be restored at the next start"), close);
}

void MachineMenu::askFirst(const Go& go) {
    if (m_file.modified)
        ask(tr("&Save changes"), tr("&Discard: the changes are lost"), go);
    else
        go();
}

void MachineMenu::ask(const QString& saveText, const QString& goOnText, const Go& go) {
    // If the changes were saved meanwhile, or another machine was opened, there is nothing left to ask.
    const auto text = [this, path = m_file.path] {
        return m_file.modified && m_file.path == path ? texts::notSaved(m_file.title()) : QString();
    };
    AskDialog::ask(
        {.name = u"unsavedDialog"_s,
         .title = tr("Unsaved changes"),
         .text = text,
         .stay = tr("Ca&ncel"),
         .stayName = u"stayUnsavedButton"_s,
         .goIsDefault = true,
         .textName = u"unsavedText"_s},
        {{saveText, u"saveFirstButton"_s, [this, go] { save(go); }}, {goOnText, u"goOnUnsavedButton"_s, go}},
        m_window);
}

void MachineMenu::waitForSave(const Go& close) {
    m_afterSaving = close;
    const AskDialog& question = AskDialog::ask(
        {.name = u"savingDialog"_s,
         .title = tr("Saving"),
         .text = [this] { return m_file.saving ? texts::beingSaved(m_file.title()) : QString(); },
         .stay = tr("Ca&ncel"),
         .stayName = u"staySavingButton"_s,
         .goIsDefault = true},
        {{tr("&Close: the changes can be restored at the next start"), u"closeUnsavedButton"_s, close}},
        m_window);
    // If the question is withdrawn because the file has been saved, the window closes.
    connect(&question, &QDialog::finished, this, [this] {
        if (m_file.saving)
            m_afterSaving = doNothing;
    });
}

void MachineMenu::save(const Go& then) {
    if (m_file.path.isEmpty())
        chooseToSave(then);
    else
        save({}, then);
}

void MachineMenu::save(const QString& path, const Go& then) {
    m_afterSaving = then;
    if (path.isEmpty())
        emit saveRequested();
    else
        emit saveAsRequested(path);
    if (!m_file.saving)
        goOnAfterSaving();
}

void MachineMenu::goOnAfterSaving() {
    const Go then = std::exchange(m_afterSaving, doNothing);
    if (!m_file.modified)
        then();
}

FileQuestion MachineMenu::fileQuestion(const QString& objectName, const QString& title) const {
    const QString last = m_file.path.isEmpty() ? m_file.recent.value(0) : m_file.path;
    return {objectName,
            title,
            {tr("Machine files (*.%1)").arg(kMachineSuffix), Common::tr("All files (*)")},
            last.isEmpty() ? QString() : QFileInfo(last).absolutePath(),
            m_file.title().isEmpty() ? tr("machine") : m_file.title()};
}

void MachineMenu::chooseToOpen() {
    askWhatToOpen(m_window, fileQuestion(u"openMachineDialog"_s, Common::tr("Open machine")),
                  [this](const QString& path) { emit openRequested(path); });
}

void MachineMenu::chooseToSave(const Go& then) {
    m_afterChoosing = then;  // if the dialog is open already, too
    askWhereToSave(m_window, fileQuestion(u"saveMachineDialog"_s, tr("Save machine")),
                   [this](const QString& path) { save(path, m_afterChoosing); });
}

}  // namespace nmc
