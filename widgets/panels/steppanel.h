// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QTabWidget;

namespace nmc {

class PanelHead;
class StepDetailsBox;
class StepIoBox;
class StepMotionBox;
class StepParametersBox;

/// Everything one PIC-STEP can be asked for. Motion is always in sight; parameters, inputs and outputs,
/// homing and details share the pages beside it.
class StepPanel : public QWidget {
    Q_OBJECT

public:
    explicit StepPanel(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
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
    void pass(const Intent& intent);
    void passSettings(const AxisSettings& settings);
    void setBusy(bool busy);

    PanelHead* m_head;
    StepMotionBox* m_motion;
    QTabWidget* m_pages;
    StepParametersBox* m_parameters;
    StepIoBox* m_io;
    StepDetailsBox* m_details;
    ModuleIndex m_module;
    TimePoint m_latestTime;
    /// A click that was passed on, until the module has spoken again: a double click is one command.
    std::optional<TimePoint> m_askedAt;
};

}  // namespace nmc
