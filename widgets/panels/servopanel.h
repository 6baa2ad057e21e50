// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QTabWidget;

namespace nmc {

class AxisBox;
class DetailsBox;
class GainsBox;
class HomingBox;
class IoBox;
class JogBox;
class MotionBox;
class PanelHead;
class PwmBox;

/// Everything one PIC-SERVO can be asked for. Motion and jog are always in sight; the rest shares the pages
/// beside them.
class ServoPanel : public QWidget {
    Q_OBJECT

public:
    explicit ServoPanel(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    void intentRequested(nmc::ModuleIndex module, const nmc::Intent& intent);
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();
    void settingsEdited(nmc::ModuleIndex module, const nmc::AxisSettings& settings);

private:
    void connectBoxes();
    void pass(const Intent& intent);
    void setBusy(bool busy);

    PanelHead* m_head;
    MotionBox* m_motion;
    JogBox* m_jog;
    QTabWidget* m_pages;
    GainsBox* m_gains;
    IoBox* m_io;
    HomingBox* m_homing;
    PwmBox* m_pwm;
    AxisBox* m_axis;
    DetailsBox* m_details;
    ModuleIndex m_module;
    TimePoint m_latestTime;
    /// A click that was passed on, until the module has spoken again: a double click is one command.
    std::optional<TimePoint> m_askedAt;
};

}  // namespace nmc
