// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "widgets/panels/modulecontext.h"

class QComboBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class NumberField;

/// Timer and counter of one PIC-I/O, and what it does at the same moment as the other modules of its group:
/// latching its inputs and applying stored outputs.
class CounterBox : public QWidget {
    Q_OBJECT

public:
    CounterBox(ModuleContext& context, QWidget* parent);

private:
    void buildTimer(FormGrid& grid);
    void buildSynch(FormGrid& grid);
    void setMode();
    void store();
    void apply();
    /// What the stored levels switch at outputs with "Ask first", as questions; empty if nothing.
    [[nodiscard]] QString questions() const;
    void refresh();
    [[nodiscard]] QString rate() const;

    ModuleContext& m_context;
    QComboBox* m_mode;
    QComboBox* m_prescaler;
    Command* m_set;
    QLabel* m_count;
    QLabel* m_rate;
    QLabel* m_latched;
    Command* m_synchInput;
    NumberField* m_outputs;
    std::array<NumberField*, 2> m_pwm{};
    Command* m_store;
    Command* m_synchOutput;
    QLabel* m_stored;
};

}  // namespace nmc
