// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QShortcutEvent>

namespace nmc {

/// A button whose mnemonic or shortcut acts at once. Qt shows the button pressed for 100 ms first, and a
/// motor that is to stop does not wait for that.
class PromptButton : public QPushButton {
    Q_OBJECT

public:
    using QPushButton::QPushButton;

protected:
    bool event(QEvent* event) override {
        if (event->type() != QEvent::Shortcut || static_cast<QShortcutEvent*>(event)->isAmbiguous())
            return QPushButton::event(event);
        click();
        return true;
    }
};

}  // namespace nmc
