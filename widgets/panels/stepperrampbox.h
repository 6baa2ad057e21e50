// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/panels/modulecontext.h"

class QLabel;

namespace nmc {

class NumberField;
class QuantityField;

/// What is no parameter of the chip's and goes with every motion: the acceleration time, and how fast hold to
/// move may get. Kept in the settings; nothing is sent by an edit.
class StepperRampBox : public QWidget {
    Q_OBJECT

public:
    StepperRampBox(ModuleContext& context, QWidget* parent);

    /// Marks stand for words.
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
