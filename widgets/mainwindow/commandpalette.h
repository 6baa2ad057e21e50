// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace nmc {

/// Finds any command by typing some of its words, says why it can't be done now, and does it on Enter. It
/// blocks nothing: STOP ALL and Esc work as ever, and Esc closes it, as does a press anywhere else. GUI
/// thread.
class CommandPalette : public QDialog {
    Q_OBJECT

public:
    struct Entry {
        QString text;      ///< as on its button: "Go"
        QString sentence;  ///< "Go to the position"
        QString place;     ///< whose it is: "Module 3 "Z axis"", "Chain"
        QString key;
        QString meaning;                  ///< what Enter does
        std::function<QString()> reason;  ///< why it can't be done now; empty where it can
        std::function<void()> act;
    };

    explicit CommandPalette(QWidget* parent);

    /// Opens it with these, whatever it had before.
    void showEntries(std::vector<Entry> entries);

protected:
    /// The arrow keys choose while the line has the focus. Watches the whole application for presses beside
    /// it: one who works elsewhere has done with it, and it may lie over what he means to press next.
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
