// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QHash>
#include <optional>

#include "widgets/panels/panelview.h"
#include "widgets/panels/stepmodechoice.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace nmc {

class QuantityField;
class StepHoldBox;

/// The four ways a PIC-STEP moves, and hold to move. A change that the chip does not allow in motion is
/// offered as "Stop, wait, go".
class StepMotionBox : public QGroupBox {
    Q_OBJECT

public:
    explicit StepMotionBox(QWidget* parent = nullptr);

    /// Emits nothing, except that a hold ends when its module or its permission goes.
    void showModule(const PanelView& view);
    /// A click was passed on; moves wait for the module's next word.
    void setBusy(bool busy);
    /// A new connection: nothing is left over from the last one.
    void resetSpeeds();
    void endHold();
    void setHoldInterval(int milliseconds);

signals:
    void intentRequested(const nmc::Intent& intent);
    void settingsEdited(const nmc::SettingsEdit& edit);
    void holdRequested(const nmc::bus::HoldToMove& hold);
    void holdReleased();

private:
    /// What is typed and not part of the settings, per module.
    struct Draft {
        StepModeChoice::Mode mode = StepModeChoice::Mode::Trapezoid;
        double goal = 0;
        bool relative = false;
    };

    void buildFields(QGridLayout* grid, int line);
    void buildButtons(QGridLayout* grid, int line);
    void connectControls();

    /// The part of the settings that the speed field shows now.
    [[nodiscard]] double MotionSettings::*speedSetting() const;
    void chooseMode();
    void showDraft();
    void showSpeed();
    void keepSpeed();
    void request(bool reverse);

    [[nodiscard]] std::optional<StepMotion> motion(bool reverse) const;
    [[nodiscard]] std::optional<Refusal> refusalOf(bool reverse) const;
    /// The refusal is Table 4's alone: it could be done by stopping first.
    [[nodiscard]] bool viaStop(bool reverse) const;
    [[nodiscard]] QString reasonFor(bool reverse) const;
    [[nodiscard]] QString outcome() const;
    [[nodiscard]] QString forecast() const;
    void refresh();
    void refreshButton(QPushButton* button, bool reverse, const QString& text, const QString& meaning);
    void refreshButtons();

    StepModeChoice* m_mode = nullptr;
    QuantityField* m_goal = nullptr;
    QCheckBox* m_relative = nullptr;
    QuantityField* m_speed = nullptr;
    QLabel* m_outcome = nullptr;
    QLabel* m_ramp = nullptr;
    QLabel* m_forecast = nullptr;
    QPushButton* m_go = nullptr;
    QPushButton* m_runReverse = nullptr;
    QPushButton* m_runForward = nullptr;
    QCheckBox* m_loadOnly = nullptr;
    QPushButton* m_startLoaded = nullptr;
    QLabel* m_hint = nullptr;
    StepHoldBox* m_hold = nullptr;

    QHash<int, Draft> m_drafts;
    std::optional<ModuleState> m_state;
    AxisSettings m_settings;
    std::optional<double> m_shownSpeed;  ///< as it stands in the settings
    bool m_connected = false;
    bool m_busy = false;
};

}  // namespace nmc
