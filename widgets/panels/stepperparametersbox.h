// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "module/stepperspeed.h"
#include "widgets/panels/stagedform.h"

namespace nmc {

/// The parameters of one PIC-STEP, which Apply sends all at once, and what applies to all its motions.
class StepperParametersBox : public StagedForm {
    Q_OBJECT

public:
    StepperParametersBox(ModuleContext& context, QWidget* parent);

private:
    /// The fields, which are the parameters of the command Set Parameters (DS-S 4.5, 4.6, 5.1).
    enum Parameter : std::size_t {
        SpeedMode,
        MinimumSpeed,
        RunCurrent,
        HoldCurrent,
        ThermalLimit,
        IgnoreLimits,
        IgnoreEstop,
        MotorOff
    };

    [[nodiscard]] std::optional<Values> kept() const override;
    [[nodiscard]] std::optional<Values> sent() const override;
    void keep() override;
    [[nodiscard]] QString remark(std::size_t field, const std::optional<int>& value) const override;
    void refreshRest() override;

    void addFields(FormGrid* grid);
    void addRamp(FormGrid* grid);
    void showRamp();
    void refreshRamp();
    [[nodiscard]] StepperSpeed speeds() const;
    void setSpeedRange();
    [[nodiscard]] static std::optional<Values> valuesOf(
        const std::optional<stepper::SetParameters>& parameters);
    /// Those in the fields; empty unless all are valid.
    [[nodiscard]] std::optional<stepper::SetParameters> parameters() const;

    QComboBox* m_speedMode = nullptr;
    QuantityField* m_minimumSpeed = nullptr;
    Command* m_start = nullptr;
    Command* m_apply = nullptr;
    NumberField* m_time = nullptr;  ///< acceleration time
    QLabel* m_acceleration = nullptr;
    QLabel* m_timeState = nullptr;
    QuantityField* m_cap = nullptr;
};

}  // namespace nmc
