// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/askdialog.h"

namespace nmc {

/// "2 motors are moving. They will be stopped before the port closes." [Stop and close] [Stay]
class CloseDialog : public AskDialog {
    Q_OBJECT

public:
    /// `stopText`: the verb that stops first, "Stop and close" or "Stop and disconnect".
    CloseDialog(int movingMotors, const QString& stopText, QWidget* parent);
};

/// "Restart the network?" [Restart the network: positions and gains are lost] [Cancel]
class RestartDialog : public AskDialog {
    Q_OBJECT

public:
    RestartDialog(int movingMotors, QWidget* parent);
};

}  // namespace nmc
