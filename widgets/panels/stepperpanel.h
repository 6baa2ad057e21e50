// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

namespace nmc {

class StepperParametersBox;

/// Everything one PIC-STEP can be asked for. Motion is always in sight; parameters, inputs and outputs,
/// homing, axis and details share the pages beside it.
class StepperPanel : public ModulePage {
    Q_OBJECT

public:
    explicit StepperPanel(const PanelView& view, QWidget* parent = nullptr);

private:
    void fitPages(int width) override;

    StepperParametersBox* m_parameters = nullptr;
};

}  // namespace nmc
