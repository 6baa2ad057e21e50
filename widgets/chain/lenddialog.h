// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "model/module/linkstate.h"

class QLineEdit;
class QPushButton;

namespace nmc {

class Requests;

/// Asks at which path the line is to be lent to a program (docs/lending.md). Not modal. GUI thread.
class LendDialog : public QDialog {
    Q_OBJECT

public:
    LendDialog(Requests& requests, QWidget* window);
    /// Shows whether the line can be lent now. Emits nothing.
    void showLink(const LinkState& link);

private:
    void showProblem();

    QLineEdit* m_path;
    QPushButton* m_lend;
    QString m_problem;  ///< why the line cannot be lent, whatever the path
};

}  // namespace nmc
