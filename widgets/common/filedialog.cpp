// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/filedialog.h"

#include <QDir>
#include <QFileDialog>

#include "widgets/common/look.h"

namespace nmc {

using namespace Qt::StringLiterals;

QFileDialog* newFileDialog(QWidget* window, const QString& objectName, const QString& title,
                           const QStringList& filters, const QString& folder) {
    if (auto* open = window->findChild<QFileDialog*>(objectName)) {
        open->activateWindow();
        return nullptr;
    }
    auto* dialog = new QFileDialog(window, title);
    look::name(dialog, objectName, title);
    // The system's own dialog keeps Esc to itself, but Esc must stop the motors here, too.
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setNameFilters(filters);
    dialog->setDirectory(folder.isEmpty() ? QDir::homePath() : folder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setModal(false);
    return dialog;
}

void askWhereToSave(QWidget* window, const FileQuestion& question, const FileChosen& chosen) {
    QFileDialog* dialog =
        newFileDialog(window, question.objectName, question.title, question.filters, question.folder);
    if (dialog == nullptr)
        return;
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    const auto takeSuffix = [dialog](const QString& filter) {
        const qsizetype dot = filter.indexOf(u"(*."_s);
        if (dot >= 0)
            dialog->setDefaultSuffix(filter.mid(dot + 3).chopped(1));
    };
    takeSuffix(question.filters.front());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, takeSuffix);
    dialog->selectFile(question.proposed);
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen);
    dialog->show();
}

void askWhatToOpen(QWidget* window, const FileQuestion& question, const FileChosen& chosen) {
    QFileDialog* dialog =
        newFileDialog(window, question.objectName, question.title, question.filters, question.folder);
    if (dialog == nullptr)
        return;
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, window, chosen);
    dialog->show();
}

}  // namespace nmc
