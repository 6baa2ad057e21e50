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

/// Operator mode, which only the PIN ends. It outlives the session: it is stored in the settings, with what
/// the user has chosen, and the PIN as a salted hash. It knows nothing about commands: the model decides what
/// rights() permit.
class OperatorLock : public QObject {
    Q_OBJECT

public:
    OperatorLock(QSettings& settings, QWidget* window);

    /// Opens the dialog that begins or ends the mode.
    [[nodiscard]] QAction* action() const { return m_action; }
    [[nodiscard]] bool isLocked() const { return m_locked; }
    /// Empty if everything is permitted.
    [[nodiscard]] std::optional<OperatorRights> rights() const;
    /// Takes the rights that are stored with the machine. If there are none, those that the user has chosen
    /// apply while the mode lasts, otherwise the defaults.
    void showRights(const std::optional<OperatorRights>& ofMachine);
    void open();

signals:
    /// rights() have changed.
    void changed();
    /// The user has chosen what the operator may do; to be stored with the machine.
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
