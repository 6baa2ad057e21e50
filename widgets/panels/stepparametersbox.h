// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "model/module/stepspeed.h"
#include "widgets/panels/modulecontext.h"
#include "widgets/panels/stepmeaning.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class NumberField;
class QuantityField;
class StepRampBox;

/// The parameters of one PIC-STEP. They cannot be read back, so each says whether it was sent in this
/// connection. Edits are staged; Apply sends all of them at once.
class StepParametersBox : public QWidget {
    Q_OBJECT

public:
    StepParametersBox(ModuleContext& context, QWidget* parent);

private:
    struct Row {
        QLabel* label = nullptr;
        QLabel* remark = nullptr;
        QLabel* state = nullptr;
    };
    /// What stands in the fields; empty where there is no number.
    using Entries = std::array<std::optional<int>, kStepParameters.size()>;

    void buildRows(QGridLayout* grid);
    void buildButtons(QGridLayout* grid, int line);
    void addRow(QGridLayout* grid, StepParameter parameter, QWidget* control);
    void connectControls();

    [[nodiscard]] std::optional<int> entry(StepParameter parameter) const;
    [[nodiscard]] Entries entries() const;
    [[nodiscard]] std::optional<step::SetParameters> entered() const;
    void showEntries(const Entries& entries);
    void showSettings();
    void showModule();
    void edit();
    void revert();
    void fillIn();
    void apply();
    [[nodiscard]] QString trouble() const;
    void refreshRow(StepParameter parameter);
    void refresh();
    [[nodiscard]] StepSpeed speeds() const;

    ModuleContext& m_context;
    QComboBox* m_speedMode;
    QuantityField* m_minimumSpeed;
    NumberField* m_runCurrent;
    NumberField* m_holdCurrent;
    NumberField* m_thermalLimit;
    QCheckBox* m_ignoreLimits;
    QCheckBox* m_ignoreEstop;
    QCheckBox* m_motorOff;
    std::array<Row, kStepParameters.size()> m_rows;
    StepRampBox* m_ramp;
    Command* m_fill;
    Command* m_revert;
    Command* m_apply;
    QLabel* m_hint;

    bool m_typed = false;  ///< since it was sent, or a machine file was opened
    /// When they were looked at last: the axis's, and those that were sent.
    std::optional<step::SetParameters> m_kept;
    std::optional<step::SetParameters> m_sent;
};

}  // namespace nmc
