// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>

class QFileDialog;
class QWidget;

namespace nmc {

/// Makes the content of a file. A call may take a second, and may come from any thread.
using FileContent = std::function<std::string()>;

/// What a dialog asks for.
struct FileQuestion {
    QString objectName, title;
    QStringList filters{};
    QString folder{};    ///< empty: that of the user
    QString proposed{};  ///< name of a new file
};
using FileChosen = std::function<void(const QString& path)>;

/// Makes a dialog that asks for a file. It is not modal: the panel, including STOP ALL, stays usable. If this
/// dialog is already open, it comes to the front, and null is returned. The caller connects fileSelected()
/// and shows the dialog.
[[nodiscard]] QFileDialog* newFileDialog(QWidget* window, const FileQuestion& question);
/// The same for a file to write; a file is replaced only if the user confirms it. A name without a suffix
/// gets that of the filter.
[[nodiscard]] QFileDialog* newSaveDialog(QWidget* window, const FileQuestion& question);

/// Asks which file to write, as newSaveDialog() does.
void askWhereToSave(QWidget* window, const FileQuestion& question, const FileChosen& chosen);
/// Asks which file to read.
void askWhatToOpen(QWidget* window, const FileQuestion& question, const FileChosen& chosen);

}  // namespace nmc
