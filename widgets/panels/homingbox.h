// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/panelview.h"

class QLabel;
class QPushButton;

namespace nmc {

class HomingForm;
class LimitStopBox;

/// Everything about home of one module, of either chip: how it is looked for, how the search goes and went,
/// and on a PIC-SERVO the limit stop. What is edited is kept in the axis' settings; nothing is sent by that.
class HomingBox : public QWidget {
    Q_OBJECT

public:
    /// The names of a stepper's controls begin with "step".
    explicit HomingBox(QWidget* parent = nullptr, ModuleType type = ModuleType::Servo);

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// A click was passed on; what starts something waits for the module's next word.
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);
    void settingsEdited(const nmc::SettingsEdit& edit);

private:
    void keepRecipe();
    void adoptRecipe(const PanelView& view);
    void refresh();
    void refreshProgress();
    [[nodiscard]] QString whyNotNow() const;
    [[nodiscard]] bool running() const;
    [[nodiscard]] QString stages() const;

    HomingForm* m_form;
    LimitStopBox* m_limitStop = nullptr;
    QPushButton* m_home;
    QPushButton* m_cancel;
    QLabel* m_stages;
    QLabel* m_result;
    QLabel* m_hint;

    AxisSettings m_settings;
    AxisScale m_scale;
    ModuleState m_state;
    std::optional<ModuleIndex> m_module;
    std::optional<ProcedureReport> m_report;  ///< of the last search
    std::optional<HomingRecipe> m_shown;      ///< what the settings had when they were looked at last
    int m_reached = -1;                       ///< of stages()
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
