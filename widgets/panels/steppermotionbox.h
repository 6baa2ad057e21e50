// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>

#include "module/stepperspeed.h"
#include "widgets/panels/modulecontext.h"
#include "widgets/panels/movebybox.h"

class QButtonGroup;
class QCheckBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class QuantityField;

/// The four kinds of motion of a PIC-STEP. A change that the chip does not allow during a
/// motion is offered as "Stop, wait: Go".
class StepperMotionBox : public QGroupBox, public MovesBy {
    Q_OBJECT

public:
    StepperMotionBox(ModuleContext& context, QWidget* parent);

    [[nodiscard]] QString whyNoMovesBy() const override;
    /// The moves have a ramp and the speed of moves to a position, whatever mode is selected.
    [[nodiscard]] std::optional<Intent> movesBy(const Rounds& moves) const override;

signals:
    void modeChosen();

private:
    enum class Mode : std::uint8_t { Trapezoid, Profile, TimedMove, TimedRun };

    void buildMode(FormGrid* grid);
    void buildFields(FormGrid* grid);
    void buildButtons(FormGrid* grid);
    void connectControls();

    [[nodiscard]] Mode mode() const;
    /// Emits nothing.
    void showMode(Mode mode);
    /// True if the motion has a ramp.
    [[nodiscard]] bool profiled() const { return mode() == Mode::Trapezoid || mode() == Mode::Profile; }
    [[nodiscard]] bool hasGoal() const { return mode() == Mode::Trapezoid || mode() == Mode::TimedMove; }
    /// The part of the settings that the speed field shows now.
    [[nodiscard]] double MotionSettings::*speedSetting() const;
    void chooseMode();
    void lookedForAnew();
    void showModule();
    void showSpeed();
    void keepSpeed();
    void request(bool reverse);
    /// What the goal counts from; a distance does not.
    [[nodiscard]] std::optional<WorkZero> zero() const;
    /// The nearest position within the travel limits if the goal is beyond them; otherwise empty.
    [[nodiscard]] std::optional<std::int32_t> nearest() const;
    void takeNearest();
    void offerNearest();

    [[nodiscard]] std::optional<StepperMotion> motion(bool reverse) const;
    /// Of steps and Go home: the speed in the field, which an operator may type but not store, or that of the
    /// settings while the field shows the speed of a run.
    [[nodiscard]] Pace pace() const;
    [[nodiscard]] std::optional<Refusal> refusalOf(bool reverse) const;
    /// True if only Table 4 prevents the motion, so that it is possible after a stop.
    [[nodiscard]] bool viaStop(bool reverse) const;
    /// What the chip is sent for a speed.
    [[nodiscard]] std::uint8_t chipSpeed(double speed) const;
    [[nodiscard]] stepper::TimerCount chipTimer(double speed) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;
    [[nodiscard]] QString outcome() const;
    [[nodiscard]] QString forecast() const;
    void refresh();
    void refreshCommand(Command& command, bool reverse, const QString& text, const QString& meaning);
    void refreshCommands();

    ModuleContext& m_context;
    QButtonGroup* m_modes = nullptr;
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

    std::optional<double> m_shownSpeed;         ///< speed in the settings, as last shown
    std::optional<double> m_shownFastest;       ///< fastest speed in the settings, as last shown
    std::optional<StepperSpeed> m_shownSpeeds;  ///< speed mode that determined the range shown
};

}  // namespace nmc
