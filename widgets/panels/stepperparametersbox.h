// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "module/stepperspeed.h"
#include "widgets/panels/modulecontext.h"
#include "widgets/panels/steppermeaning.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class NumberField;
class QuantityField;
class StepperRampBox;

/// The parameters of one PIC-STEP. They cannot be read back, so each shows whether it was sent in this
/// connection. Edits are staged; Apply sends all of them at once.
class StepperParametersBox : public QWidget {
    Q_OBJECT

public:
    StepperParametersBox(ModuleContext& context, QWidget* parent);

    /// Adapts to a width in pixels: if it is small, marks replace words.
    void fitInto(int width);

private:
    struct Row {
        QLabel* label = nullptr;
        QLabel* remark = nullptr;
        QLabel* state = nullptr;
    };
    /// The contents of the fields; empty for a field without a valid number.
    using Entries = std::array<std::optional<int>, kStepperParameters.size()>;

    void buildRows(QGridLayout* grid);
    void buildButtons(QGridLayout* grid, int line);
    void addRow(QGridLayout* grid, StepperParameter parameter, QWidget* control);
    void connectControls();

    [[nodiscard]] std::optional<int> entry(StepperParameter parameter) const;
    [[nodiscard]] Entries entries() const;
    [[nodiscard]] std::optional<stepper::SetParameters> entered() const;
    void showEntries(const Entries& entries);
    void showSettings();
    void showModule();
    void edit();
    void revert();
    void fillIn();
    void apply();
    [[nodiscard]] QString trouble() const;
    void refreshRow(StepperParameter parameter);
    void refresh();
    [[nodiscard]] StepperSpeed speeds() const;

    ModuleContext& m_context;
    QComboBox* m_speedMode;
    QuantityField* m_minimumSpeed;
    NumberField* m_runCurrent;
    NumberField* m_holdCurrent;
    NumberField* m_thermalLimit;
    QCheckBox* m_ignoreLimits;
    QCheckBox* m_ignoreEstop;
    QCheckBox* m_motorOff;
    std::array<Row, kStepperParameters.size()> m_rows;
    StepperRampBox* m_ramp;
    Command* m_fill;
    Command* m_revert;
    Command* m_apply;
    bool m_narrow = false;
    int m_wideWidth = 0;  ///< pixels that the layout with words needs
    QLabel* m_hint;

    bool m_typed = false;  ///< edited since the parameters were sent or a machine file was opened
    /// The parameters of the axis and those that were sent, both as last shown.
    std::optional<stepper::SetParameters> m_kept;
    std::optional<stepper::SetParameters> m_sent;
};

}  // namespace nmc
