// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class Command;
class NumberField;

/// PWM mode, set apart from the motions: the value drives the motor directly, and nothing limits it.
class PwmBox : public QWidget {
    Q_OBJECT

public:
    PwmBox(ModuleContext& context, QWidget* parent);

private:
    void drive(bool reverse);
    void refresh();

    ModuleContext& m_context;
    NumberField* m_value;
    QLabel* m_percent;
    Command* m_reverse;
    Command* m_forward;
    Command* m_off;
};

}  // namespace nmc
