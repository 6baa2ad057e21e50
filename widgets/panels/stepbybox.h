// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>

#include "widgets/panels/panelview.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class NumberField;
class QuantityField;

/// Step by N: one click is one move of exactly this distance, or as many as are asked for.
class StepByBox : public QGroupBox {
    Q_OBJECT

public:
    /// What a move is made with besides its distance; empty while it has no value.
    struct Pace {
        std::optional<CountsPerTick> velocity;
        std::optional<CountsPerTickSquared> acceleration;
    };

    explicit StepByBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view, const Pace& pace);
    void setBusy(bool busy);

signals:
    void intentRequested(const nmc::Intent& intent);
    void settingsEdited(const nmc::SettingsEdit& edit);

private:
    void buildDistance(QGridLayout* grid, int& line);
    void buildRepeat(QGridLayout* grid, int& line);
    void step(bool reverse);
    void refresh();
    [[nodiscard]] QString whyNotNow() const;

    QuantityField* m_distance = nullptr;
    QPushButton* m_reverse = nullptr;
    QPushButton* m_forward = nullptr;
    NumberField* m_rounds = nullptr;
    NumberField* m_pause = nullptr;
    QCheckBox* m_backAndForth = nullptr;
    QPushButton* m_end = nullptr;
    QLabel* m_progress = nullptr;
    std::optional<ModuleState> m_module;
    AxisSettings m_settings;
    Pace m_pace;
    std::optional<ProcedureReport> m_report;
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
