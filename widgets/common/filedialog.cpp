// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/filedialog.h"

#include <QDir>
#include <QFileDialog>

#include "widgets/common/look.h"

namespace nmc {

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

}  // namespace nmc
