// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>
#include <initializer_list>

class QHBoxLayout;
class QLabel;

namespace nmc {

/// A question before something that cannot be undone, in a window of its own that blocks no other: the panel
/// stays usable, and STOP ALL with it. So what it asks about may change while it stands. Its words are made
/// anew at every review, and an answer counts only if there is still something to ask.
class AskDialog : public QDialog {
    Q_OBJECT

public:
    struct Question {
        QString name;  ///< object name
        QString title;
        /// What it says now; empty: there is nothing to ask any more, and the question is withdrawn.
        std::function<QString()> text;
        QString stay;  ///< leaves all as it is
        QString stayName;
        bool stayIsDefault = false;                      ///< otherwise the first choice is
        QString textName = QStringLiteral("closeText");  ///< object name of the text
    };
    struct Choice {
        QString text;  ///< a verb that finishes the sentence; names what is lost
        QString name;  ///< object name of the button
        std::function<void()> go;
    };

    /// One that stands already under this name comes to the front instead.
    static AskDialog& ask(const Question& question, std::initializer_list<Choice> choices, QWidget* window);
    /// One of this window that stands while its user works elsewhere; null for none.
    [[nodiscard]] static AskDialog* waiting(const QWidget& window);
    void comeForward();
    /// What it says now.
    [[nodiscard]] QString text() const { return m_text(); }
    /// Something has changed that questions of this window may be about.
    static void reviewAll(const QWidget& window);

private:
    AskDialog(const Question& question, std::initializer_list<Choice> choices, QWidget* window);
    void addChoice(const Choice& choice);
    /// False: it was withdrawn.
    bool review();

    std::function<QString()> m_text;
    QLabel* m_label;
    QHBoxLayout* m_buttons;
};

}  // namespace nmc
