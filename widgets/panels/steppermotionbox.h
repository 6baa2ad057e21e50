// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>

#include "module/stepperspeed.h"
#include "widgets/panels/modulecontext.h"
#include "widgets/panels/movebybox.h"
#include "widgets/panels/steppermodechoice.h"

class QCheckBox;
class QGridLayout;
class QLabel;

namespace nmc {

class Command;
class QuantityField;
class StepperHoldBox;

/// The four ways a PIC-STEP moves, and hold to move. A change that the chip does not allow in motion is
/// offered as "Stop, wait, go".
class StepperMotionBox : public QGroupBox, public MovesBy {
    Q_OBJECT

public:
    StepperMotionBox(ModuleContext& context, QWidget* parent);

    [[nodiscard]] QString whyNoMovesBy() const override;
    /// With a ramp, at the speed of the moves to a position, whatever mode is chosen.
    [[nodiscard]] std::optional<Intent> movesBy(const Rounds& moves) const override;

private:
    void buildFields(QGridLayout* grid, int line);
    void buildButtons(QGridLayout* grid, int line);
    void connectControls();

    /// The part of the settings that the speed field shows now.
    [[nodiscard]] double MotionSettings::*speedSetting() const;
    void chooseMode();
    void lookedForAnew();
    void showModule();
    void showSpeed();
    void keepSpeed();
    void request(bool reverse);
    /// Of moves with a ramp.
    [[nodiscard]] bus::StepperPace movePace() const;
    /// A goal beyond the limits of travel has a nearest one within.
    [[nodiscard]] std::optional<std::int32_t> nearest() const;
    void takeNearest();
    void offerNearest();

    [[nodiscard]] std::optional<StepperMotion> motion(bool reverse) const;
    [[nodiscard]] std::optional<Refusal> refusalOf(bool reverse) const;
    /// The refusal is Table 4's alone: it could be done by stopping first.
    [[nodiscard]] bool viaStop(bool reverse) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;
    [[nodiscard]] QString outcome() const;
    [[nodiscard]] QString forecast() const;
    void refresh();
    void refreshCommand(Command& command, bool reverse, const QString& text, const QString& meaning);
    void refreshCommands();

    ModuleContext& m_context;
    StepperModeChoice* m_mode = nullptr;
    QuantityField* m_goal = nullptr;
    QCheckBox* m_relative = nullptr;
    QuantityField* m_speed = nullptr;
    QLabel* m_outcome = nullptr;
    QLabel* m_ramp = nullptr;
    QLabel* m_forecast = nullptr;
    Command* m_nearest = nullptr;
    Command* m_goHome = nullptr;
    Command* m_go = nullptr;
    Command* m_runReverse = nullptr;
    Command* m_runForward = nullptr;
    QCheckBox* m_loadOnly = nullptr;
    Command* m_startLoaded = nullptr;
    QLabel* m_hint = nullptr;
    StepperHoldBox* m_hold = nullptr;

    std::optional<double> m_shownSpeed;         ///< as it stands in the settings
    std::optional<double> m_shownFastest;       ///< the same
    std::optional<StepperSpeed> m_shownSpeeds;  ///< what it ranges over
};

}  // namespace nmc
