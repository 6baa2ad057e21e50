// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>

class QAction;
class QSettings;

namespace nmc {

/// The desktop's own sound, for who does not look at the window: at a fault, and at the end of a procedure
/// or a sequence. Can be off; not more often than once a second.
class Bell : public QObject {
    Q_OBJECT

public:
    /// `settings` keeps whether it is on.
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
