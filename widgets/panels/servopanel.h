// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panels/modulepage.h"

class QTabWidget;

namespace nmc {

class AxisBox;
class DetailsBox;
class DirectionCheckBox;
class GainsBox;
class HomingBox;
class IoBox;
class JogBox;
class MotionBox;
class PanelHead;
class PwmBox;
class StepByBox;

/// Everything one PIC-SERVO can be asked for. Motion and jog are always in sight; the rest shares the pages
/// beside them.
class ServoPanel : public ModulePage {
    Q_OBJECT

public:
    explicit ServoPanel(QWidget* parent = nullptr);

    void resetSpeeds() override;
    void endHold() override;
    void setHoldInterval(int milliseconds) override;
    /// Into the fields, in sight; sends nothing.
    void stageGains(const servo::SetGain& gains);

signals:
    void stepResponseWanted();

protected:
    void showBoxes(const PanelView& view) override;
    void setBusy(bool busy) override;

private:
    void connectBoxes();

    PanelHead* m_head;
    MotionBox* m_motion;
    JogBox* m_jog;
    StepByBox* m_step;
    QTabWidget* m_pages;
    GainsBox* m_gains;
    IoBox* m_io;
    HomingBox* m_homing;
    PwmBox* m_pwm;
    AxisBox* m_axis;
    DirectionCheckBox* m_direction;
    DetailsBox* m_details;
};

}  // namespace nmc
