// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "widgets/common/filedialog.h"

namespace nmc {

/// Shows a report before it is saved. It sends nothing. Not modal.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    ReportDialog(const QString& report, QWidget* parent);

signals:
    /// If the file exists, the user has agreed to replace it.
    void saveRequested(const QString& path, const nmc::FileContent& content);

private:
    void chooseFile(const QString& report);
};

}  // namespace nmc
