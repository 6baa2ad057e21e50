// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

class QTabWidget;

namespace nmc {

class AxisBox;
class HomingBox;
class PanelHead;
class StepDetailsBox;
class StepIoBox;
class StepMotionBox;
class StepParametersBox;

/// Everything one PIC-STEP can be asked for. Motion is always in sight; parameters, inputs and outputs,
/// homing, axis and details share the pages beside it.
class StepPanel : public ModulePage {
    Q_OBJECT

public:
    explicit StepPanel(QWidget* parent = nullptr);

    void resetSpeeds() override;
    void endHold() override;
    void setHoldInterval(int milliseconds) override;

protected:
    void showBoxes(const PanelView& view) override;
    void setBusy(bool busy) override;

private:
    PanelHead* m_head;
    StepMotionBox* m_motion;
    QTabWidget* m_pages;
    StepParametersBox* m_parameters;
    StepIoBox* m_io;
    HomingBox* m_homing;
    AxisBox* m_axis;
    StepDetailsBox* m_details;
};

}  // namespace nmc
