// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <string>

class QFileDialog;
class QWidget;

namespace nmc {

/// Makes what is to be written to a file, in the thread that writes it.
using FileContent = std::function<std::string()>;

/// Asks for a file beside the panel, which stays usable, and STOP ALL with it. Null when that dialog is open
/// already; it comes to the front. The caller connects fileSelected() and shows it.
[[nodiscard]] QFileDialog* newFileDialog(QWidget* window, const QString& objectName, const QString& title,
                                         const QStringList& filters, const QString& folder);

}  // namespace nmc
