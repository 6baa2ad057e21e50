// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>

#include "widgets/panels/modulecontext.h"
#include "widgets/panels/movebybox.h"

class QComboBox;
class QLabel;

namespace nmc {

class Command;
class FormGrid;
class QuantityField;

/// Moves to a position, at once or when the move is started later, and runs at a velocity. Each value is
/// shown in the user's unit, with the chip's beside it; the duration of a move is shown before it starts.
class MotionBox : public QGroupBox, public MovesBy {
    Q_OBJECT

public:
    MotionBox(ModuleContext& context, QWidget* parent);

    [[nodiscard]] QString whyNoMovesBy() const override;
    [[nodiscard]] std::optional<Intent> movesBy(const Rounds& moves) const override;

signals:
    /// A hold in progress was requested with another acceleration.
    void accelerationEdited();

private:
    void buildMove(FormGrid* grid);
    void buildRun(FormGrid* grid);
    [[nodiscard]] QuantityField* newField(const QString& objectName, const QString& name,
                                          const QString& meaning, double MotionSettings::*part);
    [[nodiscard]] std::optional<servomotion::Trapezoid> entered() const;
    [[nodiscard]] std::optional<servomotion::VelocityProfile> enteredRun(bool reverse) const;
    [[nodiscard]] std::optional<CountsPerTick> velocity() const;
    [[nodiscard]] std::optional<CountsPerTickSquared> acceleration() const;
    [[nodiscard]] std::optional<ServoPace> pace() const;
    /// The nearest goal that is allowed; empty if the goal is not beyond the travel limits.
    [[nodiscard]] std::optional<std::int32_t> nearest() const;
    void offerNearest();
    void takeNearest();
    void refreshRun(Command& command, bool reverse, const QString& meaning);
    void move(bool later);
    void goHome();
    void run(bool reverse);
    void keep(const QuantityField& field, double MotionSettings::*part);
    void forgetGoal();
    void showModule();
    void refresh();
    void refreshForecast();
    [[nodiscard]] bool relative() const;
    /// What the goal counts from; a distance does not.
    [[nodiscard]] std::optional<WorkZero> zero() const;
    [[nodiscard]] QString reasonNow(IntentKind kind,
                                    std::initializer_list<const QuantityField*> fields) const;

    ModuleContext& m_context;
    QuantityField* m_goal = nullptr;
    QComboBox* m_goalKind = nullptr;
    QuantityField* m_velocity = nullptr;
    QuantityField* m_acceleration = nullptr;
    QuantityField* m_runVelocity = nullptr;
    QLabel* m_forecast = nullptr;
    Command* m_nearest = nullptr;
    Command* m_go = nullptr;
    Command* m_load = nullptr;
    Command* m_start = nullptr;
    Command* m_goHome = nullptr;
    Command* m_zero = nullptr;
    Command* m_runForward = nullptr;
    Command* m_runReverse = nullptr;
    QLabel* m_hint = nullptr;
    MotionSettings m_motion;  ///< of the axis, as last seen
};

}  // namespace nmc
