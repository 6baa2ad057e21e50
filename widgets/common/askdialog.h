// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QPointer>
#include <functional>
#include <initializer_list>

class QHBoxLayout;
class QLabel;

namespace nmc {

/// A question before something that cannot be undone, in a window of its own that blocks no other: the panel,
/// including STOP ALL, stays usable. What the question is about may therefore change while it is open: its
/// text is made again at every review, and an answer counts only if there is still something to ask.
class AskDialog : public QDialog {
    Q_OBJECT

public:
    struct Question {
        QString name;  ///< object name
        QString title;
        /// Returns the present text; empty if there is nothing left to ask, which withdraws the question.
        std::function<QString()> text;
        QString stay = AskDialog::tr("&Cancel");  ///< the button that leaves everything as it is
        QString stayName;
        bool goIsDefault = false;                        ///< the first choice; otherwise `stay` is
        QString textName = QStringLiteral("closeText");  ///< object name of the text
    };
    struct Choice {
        QString text;  ///< a verb phrase, with what is lost
        QString name;  ///< object name of the button
        std::function<void()> go;
    };

    /// Opens the question, in place of one of this name that is already open: that one may be about something
    /// else. Its functions are called only while the owner exists; then it is withdrawn. `parent`: by default
    /// the owner's window, because the page of a module is in no window while that of another one is shown.
    static AskDialog& ask(const Question& question, std::initializer_list<Choice> choices, QWidget* owner,
                          QWidget* parent = nullptr);
    ~AskDialog() override;
    /// An open question of this window, of its pages, or of windows that it has opened, while the user works
    /// in another window; null if there is none.
    [[nodiscard]] static AskDialog* waiting(const QWidget& window);
    void comeForward();
    /// The present text.
    [[nodiscard]] QString text() const { return m_owner != nullptr ? m_text() : QString(); }
    /// Call when something has changed that these questions may be about.
    static void reviewAll(const QWidget& window);

private:
    AskDialog(const Question& question, std::initializer_list<Choice> choices, QWidget* owner,
              QWidget* parent);
    void addChoice(const Choice& choice);
    /// Updates the text. Returns false if the question was withdrawn.
    bool review();

    QPointer<QWidget> m_owner;
    std::function<QString()> m_text;
    QLabel* m_label;
    QHBoxLayout* m_buttons;
};

}  // namespace nmc
