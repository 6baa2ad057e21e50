// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QPushButton>
#include <functional>

namespace nmc {

/// Something that can be asked for on a page, as an object: what it is called, its key, what it does, and why
/// it can't be done now. Button, menu and command palette show the same one. Its key acts while its box is in
/// sight; never by auto-repeat. GUI thread.
class Command : public QAction {
    Q_OBJECT

public:
    struct Spec {
        QString name;        ///< of its button, for tests and scripts: "goButton"
        QString icon;        ///< of resources/icons; empty for none
        QString text;        ///< on the button and in the menu
        QString accessible;  ///< read out, and found by in the palette: a whole sentence without its dot
        QKeySequence key{};
    };

    /// `act` is called where it is possible only.
    Command(const Spec& spec, QWidget* box, std::function<void()> act);

    /// Possible, or not for this reason; `meaning`: what it does. The key is named behind it.
    void setPossible(const QString& reason, const QString& meaning);
    /// Why it can't be done; empty where it can.
    [[nodiscard]] const QString& reason() const { return m_reason; }
    [[nodiscard]] const QString& sentence() const { return m_sentence; }
    /// The box that it belongs to.
    [[nodiscard]] QWidget* box() const;
    /// As a button acts: nothing where it is not possible.
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
