// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace nmc {

class Requests;

/// Shows a report before it is saved. It sends nothing. Not modal.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    ReportDialog(const QString& report, Requests& requests, QWidget* parent);

private:
    void chooseFile(const QString& report);

    Requests& m_requests;
};

}  // namespace nmc
