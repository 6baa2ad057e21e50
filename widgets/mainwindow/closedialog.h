// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace nmc {

/// A question before something that cannot be undone, with one button that does it and says so, and one that
/// leaves all as it is. Esc stops the motors here, too.
class AskDialog : public QDialog {
    Q_OBJECT

public:
    struct Question {
        QString name;  ///< object name
        QString title;
        QString text;
        QString go;      ///< a verb that finishes the sentence; names what is lost
        QString goName;  ///< object name of that button
        QString stay;
        QString stayName;
    };
    AskDialog(const Question& question, QWidget* parent);
};

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
