// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace nmc {

/// Finds any command by some of its words, shows why it is not possible now, and carries it out on Enter. It
/// blocks nothing: STOP ALL and Esc work as always. Esc also closes it, as does a press anywhere else. GUI
/// thread.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    struct Entry {
        QString keywords;  ///< only searched: its button's text, or the tool tip of a menu's action
        QString sentence;  ///< "Go to the position"
        QString place;     ///< to what it belongs: "Module 3 "Z axis"", "Chain"
        QString key;
        QString meaning;                  ///< what Enter does
        std::function<QString()> reason;  ///< why it is not possible now; empty if it is
        std::function<void()> act;
    };

    explicit CommandPalette(QWidget* parent);

    /// Opens it with these entries in place of all earlier ones.
    void showEntries(std::vector<Entry> entries);

protected:
    /// The arrow keys choose while the text field has the focus. A press outside, anywhere in the
    /// application, closes it: a user who works elsewhere no longer needs it, and it may cover what is to be
    /// pressed next.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum Column { What, Where, Key, kColumns };

    void filter();
    void choose();
    void act();
    [[nodiscard]] bool isMine(const QObject* object) const;
    [[nodiscard]] const Entry* current() const;

    QLineEdit* m_words;
    QTreeWidget* m_list;
    QLabel* m_reason;
    std::vector<Entry> m_entries;
};

}  // namespace nmc
