// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for keys that repeat while they are held: no command is triggered by that.
/// Enter, shortcuts of the window, and keys on buttons and combo boxes count once for each press; typing,
/// Tab, and the keys of one view, such as the scope's, repeat as ever. A held jog does not live by repeats.
class RepeatFilter : public QObject {
    Q_OBJECT

public:
    explicit RepeatFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_repeats = false;  ///< the key that may become a shortcut next
};

}  // namespace nmc
