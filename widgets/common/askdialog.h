// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QHBoxLayout;
class QPushButton;

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
        QString textName = QStringLiteral("closeText");  ///< object name of the text
    };
    AskDialog(const Question& question, QWidget* parent);

protected:
    /// Another way to go on, before the button that leaves all as it is. It accepts, too.
    QPushButton* addChoice(const QString& text, const QString& objectName);

private:
    QHBoxLayout* m_buttons;
};

}  // namespace nmc
