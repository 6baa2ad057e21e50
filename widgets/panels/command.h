// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QPushButton>
#include <functional>

namespace nmc {

/// A command on a page, as an object: its name, its key, what it does, and why it is not possible now.
/// Button, menu and command palette share it. Its key acts while its box is visible, and never by
/// auto-repeat. GUI thread.
class Command : public QAction {
    Q_OBJECT

public:
    struct Spec {
        QString name;    ///< object name of its button, for tests and scripts: "goButton"
        QString icon{};  ///< name in resources/icons; empty for none
        QString text;    ///< on the button and in the menu
        /// For screen readers and the palette's search: a sentence without full stop; empty: `text`.
        QString accessible{};
        QKeySequence key{};
    };

    /// `act` is called only while the command is possible.
    Command(const Spec& spec, QWidget* box, std::function<void()> act);

    /// If `reason` is empty, the command is possible; otherwise it says why not. `meaning` says what the
    /// command does; the tooltip appends the key to it.
    void setPossible(const QString& reason, const QString& meaning);
    /// Why it is not possible now; empty if it is.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    [[nodiscard]] const QString& sentence() const { return m_sentence; }
    /// The box that it belongs to.
    [[nodiscard]] QWidget* box() const;
    /// Acts like its button: does nothing while the command is not possible.
    void act() {
        if (isEnabled())
            trigger();
    }

    /// Owned by its box.
    [[nodiscard]] QPushButton* button() const { return m_button; }

private:
    QString m_sentence;
    QString m_reason;
    QPushButton* m_button;
};

}  // namespace nmc
