// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class NumberField;
class QuantityField;

/// What is not a parameter of the chip but applies to every motion: the acceleration time, and the speed cap
/// of hold to move. Kept in the settings; an edit sends nothing.
class StepperRampBox : public QWidget {
    Q_OBJECT

public:
    StepperRampBox(ModuleContext& context, QWidget* parent);

    /// If narrow, marks replace words.
    void setNarrow(bool narrow);

private:
    void showModule();
    void refresh();

    ModuleContext& m_context;
    NumberField* m_time;
    QLabel* m_acceleration;
    QLabel* m_state;
    QuantityField* m_cap;
    bool m_narrow = false;
};

}  // namespace nmc
