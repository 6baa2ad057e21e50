// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace nmc {

/// Watches the whole application for keys that repeat while they are held, so that repeats trigger no
/// command. Enter, shortcuts of the window, and keys on buttons and combo boxes count once for each press;
/// typing, Tab, and the shortcuts of a single view, such as the scope, repeat as usual. A held jog does not
/// depend on repeats.
class RepeatFilter : public QObject {
    Q_OBJECT

public:
    explicit RepeatFilter(QObject* parent);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool m_repeats = false;  ///< the last key event, which may become a shortcut, is a repeat
};

}  // namespace nmc
