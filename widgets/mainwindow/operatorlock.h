// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "model/settings/operatorrights.h"

class QAction;
class QSettings;
class QWidget;

namespace nmc {

class OperatorDialog;

/// Operator mode: who leaves it needs the PIN. It outlives the session, in the settings, where the PIN is
/// kept as a salted hash. It knows nothing of commands: what rights() leaves is the model's to say.
class OperatorLock : public QObject {
    Q_OBJECT

public:
    OperatorLock(QSettings& settings, QWidget* window);

    /// Opens the question that begins the mode, or that leaves it.
    [[nodiscard]] QAction* action() const { return m_action; }
    [[nodiscard]] bool isLocked() const { return m_locked; }
    /// Empty: everything may be asked for.
    [[nodiscard]] std::optional<OperatorRights> rights() const;
    /// As the machine has them.
    void showRights(const OperatorRights& rights);
    void open();

signals:
    /// rights() are others.
    void changed();
    /// The user has chosen what is left; for the machine.
    void rightsEdited(const nmc::OperatorRights& rights);

private:
    void begin(const OperatorRights& rights, const QString& pin);
    void leave();
    [[nodiscard]] bool isPin(const QString& pin) const;
    void present();

    QSettings& m_settings;
    QWidget* m_window;
    QAction* m_action;
    OperatorRights m_rights;
    bool m_locked;
    QPointer<OperatorDialog> m_dialog;
};

}  // namespace nmc
