// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/filedialog.h"

#include <QDir>
#include <QFileDialog>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

QFileDialog* newFileDialog(QWidget* window, const FileQuestion& question) {
    if (auto* open = window->findChild<QFileDialog*>(question.objectName)) {
        open->activateWindow();
        return nullptr;
    }
    auto* dialog = new QFileDialog(window, question.title);
    look::name(dialog, question.objectName, question.title);
    // The system's own dialog keeps Esc to itself, but Esc must stop the motors here, too.
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setNameFilters(question.filters);
    dialog->setDirectory(question.folder.isEmpty() ? QDir::homePath() : question.folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}

QFileDialog* newSaveDialog(QWidget* window, const FileQuestion& question) {
    QFileDialog* dialog = newFileDialog(window, question);
    if (dialog == nullptr)
        return nullptr;
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    const auto takeSuffix = [dialog](const QString& filter) {
        const qsizetype dot = filter.indexOf(u"(*."_s);
        if (dot >= 0)
            dialog->setDefaultSuffix(filter.mid(dot + 3).chopped(1));
    };
    takeSuffix(question.filters.front());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, takeSuffix);
    dialog->selectFile(question.proposed);
    return dialog;
}

void askWhereToSave(QWidget* window, const FileQuestion& question, const FileChosen& chosen) {
    QFileDialog* dialog = newSaveDialog(window, question);
    if (dialog == nullptr)
        return;
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen);
    dialog->show();
}

void askWhatToOpen(QWidget* window, const FileQuestion& question, const FileChosen& chosen) {
    QFileDialog* dialog = newFileDialog(window, question);
    if (dialog == nullptr)
        return;
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen);
    dialog->show();
}

}  // namespace nmc
