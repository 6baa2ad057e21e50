// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>

class QFileDialog;
class QWidget;

namespace nmc {

/// Returns what is to be written to a file; called in the thread that writes it.
using FileContent = std::function<std::string()>;

/// Makes a dialog that asks for a file. It is not modal: the panel, including STOP ALL, stays usable. If this
/// dialog is already open, it comes to the front, and null is returned. The caller connects fileSelected()
/// and shows the dialog.
[[nodiscard]] QFileDialog* newFileDialog(QWidget* window, const QString& objectName, const QString& title,
                                         const QStringList& filters, const QString& folder);

}  // namespace nmc
