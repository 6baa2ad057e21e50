// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "widgets/panels/panelview.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class FormGrid;
class HoldFirstButton;
class NumberField;
class QuantityField;
class Requests;

/// The settings of the next step, and the button that makes it.
class ResponseForm : public QWidget {
    Q_OBJECT

public:
    explicit ResponseForm(Requests& requests, QWidget* parent = nullptr);

    // Emit nothing.
    void showModule(const PanelView& view);
    void showNothing();

    /// Makes a step as the button does; with `series`, a series of such steps by these distances
    /// (intent::StepSeries).
    void step(const std::vector<std::int32_t>& series = {});

    /// Why step() is not possible now; empty if it is.
    [[nodiscard]] QString whyNotNow(const std::vector<std::int32_t>& series = {}) const;
    /// In counts; empty if the field contains no valid value.
    [[nodiscard]] std::optional<std::int32_t> distance() const;

    /// In percent of the step; the last valid value of the field.
    [[nodiscard]] double band() const { return m_lastBand; }

    /// Why no step is possible, or the progress or failure of the last one; a child of the form's parent, to
    /// be placed where there is room for a sentence.
    [[nodiscard]] QLabel* stateLabel() const { return m_state; }

signals:
    void bandEdited(double percent);
    /// The settings of the next step have changed.
    void edited();

private:
    void buildFields(FormGrid* grid);
    void buildButton(FormGrid* grid);
    void refresh();
    void askWhichGains(const intent::StepResponse& step, const std::vector<std::int32_t>& series);
    void ask(ModuleIndex module, const intent::StepResponse& step, const std::vector<std::int32_t>& series);
    [[nodiscard]] std::optional<Refusal> refusal(const std::vector<std::int32_t>& series = {}) const;
    [[nodiscard]] std::optional<intent::StepResponse> entered() const;
    [[nodiscard]] QString unsentGains() const;

    Requests& m_requests;
    QuantityField* m_distance = nullptr;
    QComboBox* m_method = nullptr;
    NumberField* m_record = nullptr;
    NumberField* m_band = nullptr;
    QPushButton* m_step = nullptr;
    HoldFirstButton* m_hold = nullptr;
    QLabel* m_state = nullptr;
    std::optional<ModuleState> m_module;
    std::optional<servo::SetGain> m_staged;  ///< values in the fields of the gains
    std::optional<ProcedureReport> m_report;
    double m_lastBand;
    bool m_connected = false;
};

}  // namespace nmc
