// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QWidget>
#include <array>
#include <optional>

#include "model/module/stepspeed.h"
#include "widgets/panels/panelview.h"
#include "widgets/panels/stepmeaning.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;
class QuantityField;
class StepRampBox;

/// The parameters of one PIC-STEP. They cannot be read back, so each says whether it was sent in this
/// connection. Edits are staged per module; Apply sends all of them at once.
class StepParametersBox : public QWidget {
    Q_OBJECT

public:
    explicit StepParametersBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// A click was passed on; Apply waits for the module's next word.
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);
    void settingsEdited(const nmc::SettingsEdit& edit);

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
    void edit();
    void revert();
    void fillIn();
    void apply();
    [[nodiscard]] QString trouble() const;
    void refreshRow(StepParameter parameter);
    void refresh();
    [[nodiscard]] StepSpeed speeds() const;

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
    QPushButton* m_fill;
    QPushButton* m_revert;
    QPushButton* m_apply;
    QLabel* m_hint;

    /// Typed and not sent.
    struct Draft {
        Entries entries;
        std::optional<step::SetParameters> axis;  ///< what the axis had then: others since, from a file, win
    };
    QHash<int, Draft> m_drafts;  ///< of modules with edits that are not sent
    std::optional<ModuleState> m_state;
    AxisSettings m_settings;
    std::optional<step::SetParameters> m_shown;  ///< of the settings, as last shown or emitted
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
