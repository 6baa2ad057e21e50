// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;

namespace nmc {

class NumberField;
class QuantityField;

/// What is no parameter of the chip's and goes with every motion: the acceleration time, and how fast hold to
/// move may get. Kept in the settings; nothing is sent by an edit.
class StepRampBox : public QWidget {
    Q_OBJECT

public:
    explicit StepRampBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);

signals:
    void settingsEdited(const nmc::SettingsEdit& edit);

private:
    void refresh();

    NumberField* m_time;
    QLabel* m_acceleration;
    QLabel* m_state;
    QuantityField* m_cap;
    std::optional<StepState> m_stepper;
    std::optional<ModuleIndex> m_module;
    AxisSettings m_settings;
};

}  // namespace nmc
