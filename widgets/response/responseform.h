// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "model/intent/intent.h"
#include "model/response/movemetrics.h"
#include "widgets/common/quantityfield.h"
#include "widgets/panels/panelview.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class FormGrid;
class HoldFirstButton;
class Requests;

/// The settings of the next step or profiled move, and the button that makes it.
class ResponseForm : public QWidget {
    Q_OBJECT

public:
    explicit ResponseForm(Requests& requests, QWidget* parent = nullptr);

    // Emit nothing.
    void showModule(const PanelView& view);
    void showNothing();

    /// Makes a step or the moves as the button does; with `series`, steps by these distances
    /// (intent::StepSeries).
    void step(const std::vector<std::int32_t>& series = {});

    /// Why step() is not possible now; empty if it is.
    [[nodiscard]] QString whyNotNow(const std::vector<std::int32_t>& series = {}) const;
    /// In counts; empty if the field contains no valid value.
    [[nodiscard]] std::optional<std::int32_t> distance() const;

    /// In percent of the step; the last valid value of the field.
    [[nodiscard]] double band() const { return m_lastBand; }
    /// The last valid values of the fields.
    [[nodiscard]] const SettleWindow& settleWindow() const { return m_lastWindow; }

    /// Why no step is possible, or the progress or failure of the last one; a child of the form's parent, to
    /// be placed where there is room for a sentence.
    [[nodiscard]] QLabel* stateLabel() const { return m_state; }

signals:
    /// band() or settleWindow() has changed.
    void judgementEdited();
    /// The settings of the next step have changed.
    void edited();

private:
    void buildFields(FormGrid* grid);
    void buildMoveFields(FormGrid* grid);
    [[nodiscard]] QuantityField* newPaceField(const QString& objectName, const QString& name,
                                              const QString& meaning, QuantityField::Kind kind, double step);
    /// Shows the fields that matter to the method.
    void showMethod();
    void takeJudgement();
    void buildButton(FormGrid* grid);
    void refresh();
    void askWhichGains(const intent::StepSeries& wanted, const std::vector<std::int32_t>& series);
    /// `own`: what the fields say; otherwise a series, even one of a single step, from which a motor is
    /// found.
    void ask(ModuleIndex module, const intent::StepSeries& wanted, bool own);
    [[nodiscard]] std::optional<Refusal> refusal(const std::vector<std::int32_t>& series = {}) const;
    /// A single step is a series of one.
    [[nodiscard]] std::optional<intent::StepSeries> entered(
        const std::vector<std::int32_t>& series = {}) const;
    [[nodiscard]] std::vector<const NumberField*> fieldsInUse() const;
    [[nodiscard]] bool moves() const;
    [[nodiscard]] QString unsentGains() const;
    [[nodiscard]] ServoPace atServoRate(const ServoPace& pace, int servoRate) const;

    Requests& m_requests;
    QuantityField* m_distance = nullptr;
    QComboBox* m_method = nullptr;
    NumberField* m_record = nullptr;
    NumberField* m_band = nullptr;
    QuantityField* m_velocity = nullptr;
    QuantityField* m_acceleration = nullptr;
    NumberField* m_rounds = nullptr;
    QuantityField* m_window = nullptr;
    NumberField* m_dwell = nullptr;
    std::vector<QWidget*> m_forSteps, m_forMoves;
    QPushButton* m_step = nullptr;
    HoldFirstButton* m_hold = nullptr;
    QLabel* m_state = nullptr;
    std::optional<ModuleState> m_module;
    std::optional<servo::SetGain> m_staged;  ///< values in the fields of the gains
    MotionSettings m_motion;                 ///< as last shown
    std::optional<ProcedureReport> m_report;
    double m_lastBand;
    SettleWindow m_lastWindow;
    bool m_connected = false;
};

}  // namespace nmc
