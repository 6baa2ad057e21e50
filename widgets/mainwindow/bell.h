// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>

class QAction;
class QSettings;

namespace nmc {

/// Plays the desktop's own sound for users who do not look at the window: at a fault, and at the end of a
/// procedure or a sequence. It can be switched off, and sounds at most once a second.
class Bell : public QObject {
    Q_OBJECT

public:
    /// `settings` stores whether it is on.
    Bell(QSettings& settings, QObject* parent);

    [[nodiscard]] QAction* action() const { return m_action; }
    void ring();

signals:
    void rang();

private:
    QAction* m_action;
    QElapsedTimer m_since;
};

}  // namespace nmc
