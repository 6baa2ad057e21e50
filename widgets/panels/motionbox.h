// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QHash>
#include <optional>

#include "widgets/panels/panelview.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace nmc {

class QuantityField;

/// Go to a position, now or when it is started later; run at a velocity. Each value stands in the user's unit
/// with the chip's beside it, and a move says before its start how long it will take.
class MotionBox : public QGroupBox {
    Q_OBJECT

public:
    explicit MotionBox(QWidget* parent = nullptr);

    /// Emits nothing.
    void showModule(const PanelView& view);
    /// A click was passed on; moves wait for the module's next word.
    void setBusy(bool busy);
    /// A new connection: the goals that were typed are forgotten.
    void forgetGoals();
    /// Empty while the field has no value.
    [[nodiscard]] std::optional<CountsPerTickSquared> acceleration() const;
    /// Of a move to a position.
    [[nodiscard]] std::optional<CountsPerTick> velocity() const;

signals:
    void intentRequested(const nmc::Intent& intent);
    void settingsEdited(const nmc::SettingsEdit& edit);
    /// What is held was asked for at another acceleration.
    void accelerationEdited();

private:
    void build();
    void buildMove(class QGridLayout* grid, int& line);
    void buildRun(class QGridLayout* grid, int& line);
    QuantityField* addQuantity(class QGridLayout* grid, int line, const QString& label,
                               const QString& objectName, const QString& accessibleName,
                               double MotionSettings::*part);
    void connectControls();
    [[nodiscard]] std::optional<intent::GoTo> entered() const;
    void move(bool later);
    void goHome();
    void run(bool reverse);
    void keep(const QuantityField& field, double MotionSettings::*part);
    void showGoal();
    void refresh();
    void refreshForecast();
    [[nodiscard]] bool relative() const;
    [[nodiscard]] QString reasonFor(Request request,
                                    std::initializer_list<const QuantityField*> fields) const;

    QuantityField* m_goal = nullptr;
    QComboBox* m_goalKind = nullptr;
    QuantityField* m_velocity = nullptr;
    QuantityField* m_acceleration = nullptr;
    QuantityField* m_runVelocity = nullptr;
    QLabel* m_forecast = nullptr;
    QPushButton* m_go = nullptr;
    QPushButton* m_load = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_goHome = nullptr;
    QPushButton* m_zero = nullptr;
    QPushButton* m_runForward = nullptr;
    QPushButton* m_runReverse = nullptr;
    QLabel* m_hint = nullptr;

    struct Goal {
        double counts = 0.0;
        bool relative = false;
    };
    QHash<int, Goal> m_goals;  ///< as typed, of each module
    std::optional<ModuleState> m_module;
    AxisSettings m_settings;
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
