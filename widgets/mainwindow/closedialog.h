// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace nmc {

/// "2 motors are moving. They will be stopped before the port closes." [Stop and close] [Stay]
class CloseDialog : public QDialog {
    Q_OBJECT

public:
    /// `stopText`: the verb that stops first, "Stop and close" or "Stop and disconnect".
    CloseDialog(int movingMotors, const QString& stopText, QWidget* parent);
};

}  // namespace nmc
