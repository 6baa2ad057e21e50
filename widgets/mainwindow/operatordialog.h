// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>

#include "model/settings/operatorrights.h"

class QLabel;
class QLineEdit;

namespace nmc {

/// Asks for the PIN: once to leave operator mode; twice to begin it, together with what the operator may do.
/// Not modal: the panel stays usable, and STOP ALL with it.
class OperatorDialog : public QDialog {
    Q_OBJECT

public:
    /// For beginning the mode.
    OperatorDialog(const OperatorRights& rights, QWidget* window);
    /// For leaving the mode. `isPin`: true if the PIN typed is right; `forgotten`: what to do if it was
    /// forgotten.
    OperatorDialog(std::function<bool(const QString&)> isPin, const QString& forgotten, QWidget* window);

signals:
    void locked(const nmc::OperatorRights& rights, const QString& pin);
    void unlocked();

private:
    explicit OperatorDialog(QWidget* window);
    QLineEdit* newPinField(const QString& name, const QString& label);
    void addEnd(const QString& goOn, const QString& goOnName, const std::function<void()>& act);

    QLineEdit* m_pin = nullptr;
    QLabel* m_problem = nullptr;
};

}  // namespace nmc
